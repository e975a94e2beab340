// SPDX-License-Identifier: GPL-3.0-or-later

// Any bytes, read as a file of one format: a usable soup, or one line that names file and cause.

#include "read/read_mesh.h"
#include "read/errors.h"
#include "require.h"
#include "soup/vector_algebra.h"

#include <cmath>

using namespace segment_mesh;

namespace {

/// Bytes of memory for each byte of a file. The worst is a header of a PLY that promises more faces
/// than there are.
constexpr std::size_t most_memory_per_byte = 32;
/// glTF and 3MF files may repeat a mesh, within bounds that are generous for a small file.
constexpr std::size_t harmless_memory = Mesh_format::FORMAT == Mesh_format::GLTF ||
                                            Mesh_format::FORMAT == Mesh_format::THREE_MF
                                          ? 100000000
                                          : 0;

std::size_t memory_of(const Polygon_soup& soup)
{
  return soup.points.capacity() * sizeof(Point) +
         (soup.polygons.capacity() + soup.polygons.corners().capacity()) * sizeof(Polygons::Index);
}

template <typename Value>
void check_values(const Corner_values<Value>& all, const Polygons& polygons)
{
  require(all.empty() || all.of_corner.size() == polygons.corners().size(),
          "each corner has a value or none");
  for (const Polygons::Index i : all.of_corner)
    require(i == all.none || i < all.values.size(), "values are there");
  for (const Value& value : all.values)
    for (const auto number : value)
      require(std::isfinite(number), "values are finite");
}

/// Of each element there is a value, and no index is out of range.
void check_properties(const Input_mesh& input)
{
  const Mesh_properties& properties = input.properties;
  const Polygons& polygons = input.soup.polygons;
  for (const Face_sets& sets : properties.sets) {
    require(sets.empty() || sets.set_of_face.size() == polygons.size(), "each face is in a set");
    for (const std::size_t set : sets.set_of_face)
      require(set < sets.names->size(), "sets have names");
  }
  check_values(properties.colors, polygons);
  check_values(properties.texture, polygons);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Input_mesh input = parse_mesh("x", Mesh_format::FORMAT, bytes);
    const Polygon_soup& soup = input.soup;
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
    check_properties(input);
    for (const std::string& remark : input.remarks)
      require(remark.rfind("x:", 0) == 0 && remark.find('\n') == std::string::npos,
              "a remark is a line: " + remark);
  } catch (const Input_error& error) {
    const std::string message = error.what();
    require(message.rfind("x:", 0) == 0 && message.find('\n') == std::string::npos,
            "a message is a line: " + message);
  }
  return 0;
}
