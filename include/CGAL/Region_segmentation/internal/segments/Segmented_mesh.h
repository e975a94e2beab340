// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/segments/Halfedge_table.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/support/number_labels.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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
