// SPDX-License-Identifier: GPL-3.0-or-later

// Any soup, as a file may hold it: every method gives each face a segment, no more segments than
// asked for, numbered by their first faces; and the outputs that need one get an oriented
// 2-manifold.

#include "Bytes.h"
#include "require.h"
#include "segmentation/Manifold.h"
#include "soup/Polygon_soup.h"
#include "soup/vector_algebra.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <vector>

namespace RS = CGAL::Region_segmentation;
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

template <typename Method>
void check_method(const Polygon_soup& soup, const Method& method, std::size_t k)
{
  std::vector<std::size_t> labels(soup.polygons.size()), again(labels);
  const auto np = RS::parameters::number_of_segments(k).method(method);
  const std::size_t n = RS::segment_polygon_soup(soup.points, soup.polygons, labels, np);
  std::size_t number = 0;
  for (std::size_t label : labels) {
    require(label <= number, "segments are numbered by their first faces");
    number = (std::max)(number, label + 1);
  }
  require(number == n && n <= k, "as many segments as said, no more than asked for");
  require(RS::segment_polygon_soup(soup.points, soup.polygons, again, np) == n && again == labels,
          "twice the same");
}

void check_manifold(const Polygon_soup& soup)
{
  const Manifold manifold = make_manifold(soup);
  Manifold::Mesh mesh = manifold.mesh; // with the points that no face uses, which CGAL's check
                                       // refuses
  CGAL::Polygon_mesh_processing::remove_isolated_vertices(mesh);
  require(CGAL::is_valid_polygon_mesh(mesh), "a valid mesh");
  require(manifold.face_of_mesh_face.size() == manifold.mesh.number_of_faces(),
          "every face has one");
  for (const std::size_t f : manifold.face_of_mesh_face)
    require(f < soup.polygons.size(), "faces are in range");
  require(manifold.point_of_mesh_point.size() == manifold.mesh.number_of_vertices(),
          "every point has one");
  for (const auto v : manifold.mesh.vertices()) {
    const auto& p = manifold.mesh.point(v);
    require(soup.points[manifold.point_of_mesh_point[v]] == Point{p.x(), p.y(), p.z()},
            "points keep their coordinates");
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const std::size_t k = 1 + bytes.below(16);
  const Polygon_soup soup = soup_from(bytes);
  if (soup.polygons.empty())
    return -1; // not for the corpus
  check_manifold(soup);
  check_method(soup, RS::Two_step(), k);
  check_method(soup, RS::Visibility_merging(), k);
  check_method(soup, RS::Learned_merging(), k);
  check_method(soup, RS::Smooth_faces(), k);
  return 0;
}
