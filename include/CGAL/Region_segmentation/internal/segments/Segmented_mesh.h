// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/components.h>
#include <CGAL/Region_segmentation/internal/surface/read_surface.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
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

/// Whether the surface of a mesh turns a face, since its component is inside out: then its corners
/// run the other way.
inline bool is_turned(const Halfedge_table& mesh, const Surface& surface,
                      Halfedge_table::Index face)
{
  return surface.corner(face, 1) != mesh.target(mesh.first[face]);
}

/// From the source of a halfedge to its target.
inline Double_3 direction(const Halfedge_table& mesh, const Surface& surface,
                          Halfedge_table::Index h)
{
  return surface.point(mesh.target(h)) - surface.point(mesh.source[h]);
}

/// The angle between the two normals of an edge in radians, positive if it is convex and negative
/// if it is concave; 0 beside a degenerate face.
inline double signed_deviation(const Halfedge_table& mesh, const Surface& surface,
                               Halfedge_table::Index h)
{
  const Halfedge_table::Index f = mesh.face[h], g = mesh.face[mesh.opposite[h]];
  if (surface.is_degenerate(f) || surface.is_degenerate(g))
    return 0;
  const Double_3 &n = surface.normal(f), &m = surface.normal(g);
  const double angle = std::acos((std::max)(-1.0, (std::min)(1.0, dot(n, m))));
  const double sign = dot(cross(n, m), direction(mesh, surface, h));
  return (is_turned(mesh, surface, f) ? sign > 0 : sign < 0) ? -angle : angle;
}

/// The halfedges of a mesh whose faces have segments, which are numbered by their first faces. A
/// segment is a surface with a border, where its faces have no neighbor or one of another segment.
struct Segmented_halfedges : Halfedge_table
{
  std::size_t number_of_segments = 0;
  std::vector<Index> segment_of_face; // none: no segment

  /// The segment of the face of a halfedge.
  Index segment(Index h) const { return segment_of_face[face[h]]; }
  /// That of the face across; none if there is no face.
  Index segment_across(Index h) const { return opposite[h] == none ? none : segment(opposite[h]); }

  /// Whether a halfedge is on the border of the segment of its face.
  bool is_on_border(Index h) const
  {
    return opposite[h] == none || segment(h) != segment(opposite[h]);
  }

  /// Makes an edge a border of the mesh.
  void cut(Index h)
  {
    if (opposite[h] != none)
      opposite[opposite[h]] = none;
    opposite[h] = none;
  }

  /// The fan of faces of one segment that each halfedge leaves from at its source. Where a segment
  /// touches itself at a vertex, it has several fans there. With a vertex for each fan, every
  /// segment is a 2-manifold.
  Partition fans() const
  {
    Lowest_root_forest forest(size());
    for (Index h = 0; h < size(); ++h)
      if (!is_on_border(h))
        forest.unite(h, next(opposite[h]));
    return forest.take_partition();
  }

  Grouped_items<Index> faces_of_segments() const
  {
    return Grouped_items<Index>(number_of_segments, [&](const auto& add) {
      for (Index f = 0; f < segment_of_face.size(); ++f)
        if (segment_of_face[f] != none)
          add(segment_of_face[f], f);
    });
  }
};

/// The same with the descriptors of the halfedges and the labels of the segments.
template <typename FaceGraph, typename Label>
struct Segmented_mesh : Segmented_halfedges
{
  std::vector<typename boost::graph_traits<FaceGraph>::halfedge_descriptor> descriptors;
  std::vector<Label> labels;

  template <typename SegmentMap, typename Pack>
  Segmented_mesh(const FaceGraph& mesh, const SegmentMap& segment_map, const Pack& np)
    : descriptors(read_halfedges(mesh, np, *this))
  {
    segment_of_face = number_labels(face_values(mesh, segment_map), labels);
    number_of_segments = labels.size();
  }

  Label label(Index segment) const { return segment == none ? Label(no_segment) : labels[segment]; }
};

template <typename FaceGraph, typename SegmentMap, typename Pack>
Segmented_mesh(const FaceGraph&, const SegmentMap&, const Pack&)
  -> Segmented_mesh<FaceGraph, typename boost::property_traits<SegmentMap>::value_type>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H
