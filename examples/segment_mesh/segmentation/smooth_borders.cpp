// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/smooth_borders.h"

#include "segmentation/Manifold.h"
#include "segmentation/Stage_clock.h"

#include <CGAL/Region_segmentation/smooth_borders.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <queue>
#include <set>
#include <vector>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

using Mesh = Manifold::Mesh;

/// The constrained edges, by coordinates: points of the soup may be several at one place.
std::vector<char> constrained_edges(const Mesh& mesh, const Polygon_soup& soup, const Marks& marks)
{
  const auto sorted = [](std::array<Point, 2> ends) {
    std::sort(ends.begin(), ends.end());
    return ends;
  };
  std::set<std::array<Point, 2>> edges;
  for (const Vertex_pair& edge : marks.constrained_edges)
    edges.insert(sorted({soup.points[edge[0]], soup.points[edge[1]]}));
  std::vector<char> result(mesh.number_of_edges());
  const auto point = [&](auto v) {
    return Point{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
  };
  for (const auto e : mesh.edges())
    result[e] = edges.count(sorted({point(mesh.vertex(e, 0)), point(mesh.vertex(e, 1))})) > 0;
  return result;
}

/// Labels of the faces of the mesh.
struct Labels
{
  std::vector<std::size_t> segment_of_face, region_of_face;
};

void nest_regions(const Mesh& mesh, const std::vector<std::size_t>& segment_of_region,
                  Labels& labels)
{
  const auto has_moved = [&](std::size_t f) {
    return segment_of_region[labels.region_of_face[f]] != labels.segment_of_face[f];
  };
  std::queue<Mesh::Face_index> front;
  for (const auto f : mesh.faces())
    if (!has_moved(f))
      front.push(f);
  for (; !front.empty(); front.pop()) {
    const auto f = front.front();
    for (const auto g : CGAL::faces_around_face(mesh.halfedge(f), mesh))
      if (g != Mesh::null_face() && has_moved(g) &&
          labels.segment_of_face[g] == labels.segment_of_face[f]) {
        labels.region_of_face[g] = labels.region_of_face[f];
        front.push(g);
      }
  }
}

} // namespace

void smooth_borders(const Polygon_soup& soup, const Marks& marks, const Progress_listener& listener,
                    Segmentation& segmentation)
{
  const Manifold manifold = make_manifold(soup);
  const std::vector<char> is_constrained = constrained_edges(manifold.mesh, soup, marks);
  Labels labels = {manifold.values_of_mesh_faces(segmentation.segment_of_face),
                   manifold.values_of_mesh_faces(segmentation.region_of_face)};
  std::vector<std::size_t> segment_of_region(segmentation.number_of_regions);
  for (std::size_t f = 0; f < segmentation.region_of_face.size(); ++f)
    segment_of_region[segmentation.region_of_face[f]] = segmentation.segment_of_face[f];

  Stage_clock clock(listener);
  RS::smooth_borders<CGAL::Parallel_tag>(
    manifold.mesh,
    boost::make_iterator_property_map(labels.segment_of_face.begin(),
                                      get(boost::face_index, manifold.mesh)),
    RS::parameters::visitor(std::ref(clock))
      .edge_is_constrained_map(boost::make_iterator_property_map(
        is_constrained.begin(), get(boost::edge_index, manifold.mesh))));
  segmentation.seconds += clock.seconds();
  for (Stage_time& time : clock.stages())
    segmentation.stages.push_back(std::move(time));

  nest_regions(manifold.mesh, segment_of_region, labels);
  for (std::size_t f = 0; f < manifold.face_of_mesh_face.size(); ++f) {
    segmentation.segment_of_face[manifold.face_of_mesh_face[f]] = labels.segment_of_face[f];
    segmentation.region_of_face[manifold.face_of_mesh_face[f]] = labels.region_of_face[f];
  }
}

} // namespace segment_mesh
