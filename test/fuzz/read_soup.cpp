// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes, read as a file of one format: a usable soup, or one line that names file and cause.

#include "read/read_mesh.h"
#include "read/errors.h"
#include "require.h"
#include "soup/vector_algebra.h"

using namespace segment_mesh;

namespace {

/// Bytes of memory for each byte of a file. The worst is a header of a PLY that promises more faces
/// than there are.
constexpr std::size_t most_memory_per_byte = 32;
/// A glTF file may repeat a mesh, within bounds that are generous for a small file.
constexpr std::size_t harmless_memory = Mesh_format::FORMAT == Mesh_format::GLTF ? 100000000 : 0;

std::size_t memory_of(const Polygon_soup& soup)
{
  return soup.points.capacity() * sizeof(Point) +
         (soup.polygons.capacity() + soup.polygons.corners().capacity()) * sizeof(Polygons::Index);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Remarks remarks;
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Polygon_soup soup = read_soup("x", Mesh_format::FORMAT, bytes, remarks);
    require(!soup.polygons.empty(), "there are faces");
    for (const Point& p : soup.points)
      require(is_finite(p), "coordinates are finite");
    for (const auto& polygon : soup.polygons) {
      require(polygon.size() >= 3, "faces have three corners");
      for (const std::size_t i : polygon)
        require(i < soup.points.size(), "indices are in range");
    }
    require(memory_of(soup) <= harmless_memory + most_memory_per_byte * size,
            "memory is proportional to the file");
    for (const std::string& remark : remarks)
      require(remark.rfind("x:", 0) == 0 && remark.find('\n') == std::string::npos,
              "a remark is a line: " + remark);
  } catch (const Input_error& error) {
    const std::string message = error.what();
    require(message.rfind("x:", 0) == 0 && message.find('\n') == std::string::npos,
            "a message is a line: " + message);
  }
  return 0;
}
