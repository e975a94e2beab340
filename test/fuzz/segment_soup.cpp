// SPDX-License-Identifier: GPL-3.0-or-later

// Any soup, as a file may hold it: an oriented 2-manifold with a face for each of its faces, or a cause.

#include "Bytes.h"
#include "io/errors.h"
#include "io/read_mesh.h"
#include "require.h"
#include "soup/link_corners.h"
#include "soup/vector_algebra.h"

#include <algorithm>

using namespace segment_mesh;

namespace {

Polygon_soup soup_from(Bytes bytes)
{
  Polygon_soup soup;
  for (std::size_t i = 0, n = 1 + bytes.below(32); i < n; ++i) {
    const Point point = {bytes.number(), bytes.number(), bytes.number()};
    soup.points.push_back(is_finite(point) ? point : Point{0, 0, 0});
  }
  while (!bytes.empty()) {
    for (std::size_t i = 0, n = 3 + bytes.below(8); i < n; ++i)
      soup.polygons.add_corner(bytes.below(soup.points.size()));
    soup.polygons.close_polygon();
  }
  return soup;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Polygon_soup soup = soup_from(Bytes(data, size));
  if (soup.polygons.empty())
    return -1; // not for the corpus
  try {
    const Input_mesh input = make_input_mesh("x", soup);
    const Polygon_soup& mesh = input.mesh_soup();
    require(input.soup.points == soup.points && input.soup.polygons == soup.polygons,
            "the file's soup is kept");
    require(is_oriented_manifold(mesh), "an oriented 2-manifold");
    require(input.mesh_face_of_face.size() == soup.polygons.size(), "every face has one");
    for (const std::size_t face : input.mesh_face_of_face)
      require(face < mesh.polygons.size(), "faces are in range");
    require(input.point_of_mesh_point.size() == mesh.points.size(), "every point has one");
    std::vector<bool> is_used(mesh.points.size());
    for (const auto& polygon : mesh.polygons)
      for (const std::size_t i : polygon)
        is_used[i] = true;
    require(std::count(is_used.begin(), is_used.end(), false) == 0, "no isolated points");
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      require(mesh.points[i] == soup.points[input.point_of_mesh_point[i]],
              "points keep their coordinates");
  } catch (const Input_error& error) {
    require(std::string(error.what()).rfind("x: ", 0) == 0, error.what());
  }
  return 0;
}
