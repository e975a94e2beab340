// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_HALFEDGE_TABLE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_HALFEDGE_TABLE_H

#include <CGAL/Region_segmentation/internal/surface/Mesh_order.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The halfedges of the faces of a mesh as arrays. Those of a face have consecutive numbers, from
/// the one that leaves its vertex of lowest number; faces and vertices are numbered in iteration
/// order. So what is computed from a table is the same for every mesh type.
struct Halfedge_table
{
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  std::size_t number_of_vertices = 0;
  std::vector<Index> first;        // halfedge of each face, and the end
  std::vector<Index> face, source; // of each halfedge
  std::vector<Index> opposite;     // none on the border of the mesh

  std::size_t size() const { return source.size(); }
  std::size_t number_of_faces() const { return first.size() - 1; }
  Index next(Index h) const { return h + 1 < first[face[h] + 1] ? h + 1 : first[face[h]]; }
  Index target(Index h) const { return source[next(h)]; }
};

/// Fills a table; returns the descriptors of its halfedges.
template <typename FaceGraph, typename Pack>
auto read_halfedges(const FaceGraph& mesh, const Pack& np, Halfedge_table& table)
{
  using Index = Halfedge_table::Index;
  std::vector<typename boost::graph_traits<FaceGraph>::halfedge_descriptor> descriptors;
  const Mesh_order<FaceGraph, Pack> order(mesh, np);
  const auto halfedge_index = get_initialized_halfedge_index_map(mesh, np);
  std::vector<Index> number(num_halfedges(mesh), Halfedge_table::none);
  table.number_of_vertices = order.number_of_vertices();
  table.first.push_back(0);
  for (auto f : order.ordered_faces()) {
    for (auto h : CGAL::halfedges_around_face(order.first_halfedge(f), mesh)) {
      number[std::size_t(get(halfedge_index, h))] = Index(descriptors.size());
      descriptors.push_back(h);
      table.source.push_back(order.vertex_rank(source(h, mesh)));
    }
    table.face.resize(descriptors.size(), Index(table.first.size() - 1));
    table.first.push_back(Index(descriptors.size()));
  }
  for (auto h : descriptors)
    table.opposite.push_back(number[std::size_t(get(halfedge_index, opposite(h, mesh)))]);
  return descriptors;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_HALFEDGE_TABLE_H
