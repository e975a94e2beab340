// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENTED_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENTED_MESH_H

#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/Mesh_order.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The halfedges of the faces of a mesh as arrays, and the segments of its faces.
///
/// Faces and vertices are numbered in iteration order. The halfedges of a face have consecutive
/// numbers, from the one that leaves its vertex of lowest number. So results are the same for every
/// mesh type.
///
/// Segments are numbered by their first faces. The next number, `number_of_segments`, is that of
/// the faces without a segment, and the one after it stands for what is beyond the border of the
/// mesh. A segment is a surface with a border, where its faces have no neighbor of its number.
struct Segmented_halfedges
{
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  std::size_t number_of_vertices = 0, number_of_segments = 0;
  std::vector<Index> segment_of_face;
  std::vector<Index> first = {0};  // halfedge of each face, and the end
  std::vector<Index> face, source; // of each halfedge
  std::vector<Index> opposite;     // none on the border of the mesh

  std::size_t size() const { return source.size(); }
  std::size_t number_of_faces() const { return first.size() - 1; }
  Index next(Index h) const { return h + 1 < first[face[h] + 1] ? h + 1 : first[face[h]]; }
  Index target(Index h) const { return source[next(h)]; }

  /// Makes a face of the halfedges whose sources were added since the last one.
  void add_face()
  {
    face.resize(size(), Index(number_of_faces()));
    first.push_back(Index(size()));
  }

  /// The number of the segment of the face of a halfedge, and of that across.
  Index segment(Index h) const { return segment_of_face[face[h]]; }
  Index segment_across(Index h) const
  {
    return opposite[h] == none ? Index(number_of_segments + 1) : segment(opposite[h]);
  }
  bool has_segment(Index h) const { return segment(h) < number_of_segments; }
  bool is_on_border(Index h) const
  {
    return opposite[h] == none || segment(h) != segment(opposite[h]);
  }

  /// The halfedge on the border of a segment that follows one on its border.
  Index next_on_border(Index h) const
  {
    for (h = next(h); !is_on_border(h); h = next(opposite[h]))
      ;
    return h;
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
};

/// The segmented halfedges of a face graph, with the descriptors of its elements by number and the
/// labels of the segments.
template <typename FaceGraph, typename Label>
struct Segmented_mesh : Segmented_halfedges
{
  using Traits = boost::graph_traits<FaceGraph>;

  std::vector<typename Traits::halfedge_descriptor> halfedges;
  std::vector<typename Traits::face_descriptor> faces;
  std::vector<typename Traits::vertex_descriptor> vertices;
  std::vector<Label> labels;

  /// The descriptor of a face or a vertex; null for those that the mesh does not have.
  auto face_at(Index f) const { return f < faces.size() ? faces[f] : Traits::null_face(); }
  auto vertex_at(Index v) const
  {
    return v < vertices.size() ? vertices[v] : Traits::null_vertex();
  }

  /// The label of a segment, or `no_segment`.
  Label label(Index segment) const
  {
    return segment < labels.size() ? labels[segment] : Label(no_segment);
  }
};

template <typename FaceGraph, typename SegmentMap, typename Pack>
auto read_segmented_mesh(const FaceGraph& mesh, const SegmentMap& segment_map, const Pack& np)
{
  using Index = Segmented_halfedges::Index;
  Segmented_mesh<FaceGraph, typename boost::property_traits<SegmentMap>::value_type> result;
  const Mesh_order<FaceGraph, Pack> order(mesh, np);
  result.faces = order.ordered_faces();
  result.vertices = order.ordered_vertices();
  result.number_of_vertices = result.vertices.size();
  for (const auto f : result.faces) {
    for (const auto h : CGAL::halfedges_around_face(order.first_halfedge(f), mesh)) {
      result.halfedges.push_back(h);
      result.source.push_back(order.vertex_rank(source(h, mesh)));
    }
    result.add_face();
  }
  using Number = Number_in<CGAL::internal_np::halfedge_index_t, Pack>;
  const Iteration_ranks<typename boost::graph_traits<FaceGraph>::halfedge_descriptor, Number>
    numbers(result.halfedges, Number(np));
  for (const auto h : result.halfedges)
    result.opposite.push_back(numbers[opposite(h, mesh)]);
  result.segment_of_face = number_labels(face_values(mesh, segment_map), result.labels);
  result.number_of_segments = result.labels.size();
  std::replace(result.segment_of_face.begin(), result.segment_of_face.end(), Index(result.none),
               Index(result.number_of_segments));
  return result;
}

/// Whether the surface of a mesh turns a face, since its component is inside out: then its corners
/// run the other way.
inline bool is_turned(const Surface& surface, const Segmented_halfedges& mesh,
                      Segmented_halfedges::Index face)
{
  return surface.corner(face, 1) != mesh.target(mesh.first[face]);
}

/// The adjacency of a surface across a halfedge of its mesh; `Surface::none` on the border of the
/// mesh. Sides of a face run the other way if the surface turns it.
inline Surface::Index adjacency_across(const Surface& surface, const Segmented_halfedges& mesh,
                                       Segmented_halfedges::Index h)
{
  const auto f = mesh.face[h], first = mesh.first[f], last = mesh.first[f + 1] - 1;
  return surface.adjacency(f, is_turned(surface, mesh, f) ? last - h : h - first);
}

/// The deviation of an adjacency in radians, negative if it is concave; 0 where there is no angle.
inline double signed_deviation(const Surface& surface, Surface::Index adjacency)
{
  return (surface.has_flag(adjacency, Surface::CONCAVE) ? -1 : 1) * surface.deviation(adjacency);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENTED_MESH_H
