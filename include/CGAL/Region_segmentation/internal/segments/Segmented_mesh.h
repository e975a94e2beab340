// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H

#include <CGAL/Region_segmentation/internal/support/check_maps.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/Key_numbering.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The segments of the faces by their rank, numbered by the first face, and the labels of the segments.
template <typename Label>
struct Segment_numbers
{
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  std::vector<Index> of_face; // none: no segment
  std::vector<Label> labels;  // of the segments

  Label label(Index segment) const { return segment == none ? no_segment<Label> : labels[segment]; }
};

template <typename Traversal, typename SegmentMap>
auto number_segments(const Traversal& traversal, const SegmentMap& segment_map)
{
  static_assert(check_face_map<SegmentMap, std::decay_t<decltype(traversal.mesh())>>());
  using Label = typename boost::property_traits<SegmentMap>::value_type;
  Segment_numbers<Label> numbers;
  numbers.of_face.reserve(traversal.number_of_faces());
  Key_numbering number(2 * traversal.number_of_faces() + 1024);
  traversal.for_each_face([&](const auto& f) {
    const Label label = get(segment_map, f);
    if (!is_segment(label)) {
      numbers.of_face.push_back(Segment_numbers<Label>::none);
      return;
    }
    numbers.of_face.push_back(number(static_cast<std::uint64_t>(label)));
    if (number.size() > numbers.labels.size())
      numbers.labels.push_back(label);
  });
  return numbers;
}

/// A mesh whose faces have segments, by number: the view of it in which a segment is a surface with a border.
///
/// A halfedge is on the border of the segment of its face if the face across is of another segment, or of none, or if
/// there is none. Around a vertex, the faces of a segment form fans between such halfedges; a vertex with several fans
/// of one segment, where it touches itself, counts once for each of them. So every segment is a manifold.
template <typename Traversal>
class Segmented_mesh
{
public:
  using FaceGraph = std::decay_t<decltype(std::declval<const Traversal&>().mesh())>;
  using Index = std::uint32_t;
  using face_descriptor = typename Traversal::face_descriptor;
  using halfedge_descriptor = typename Traversal::halfedge_descriptor;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// Refers to both arguments.
  Segmented_mesh(const Traversal& traversal, const std::vector<Index>& segment_of_face)
    : m_traversal(traversal), m_segment_of_face(segment_of_face), m_rank_of_face(traversal.rank_of_face())
  {}

  const Traversal& traversal() const { return m_traversal; }
  const auto& mesh() const { return m_traversal.mesh(); }
  const std::vector<Index>& segment_of_face() const { return m_segment_of_face; }

  /// The segment of the face of a halfedge; none if it has no face.
  Index segment(halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, mesh());
    return f == boost::graph_traits<FaceGraph>::null_face() ? none : m_segment_of_face[m_rank_of_face(f)];
  }
  Index opposite_segment(halfedge_descriptor h) const { return segment(opposite(h, mesh())); }

  /// Whether a halfedge is on the border of a segment: of that of its face, or of that across.
  bool is_border(halfedge_descriptor h) const { return segment(h) != opposite_segment(h); }

  /// The halfedge that follows another one on the border of a segment, around one of its fans.
  halfedge_descriptor next_on_border(halfedge_descriptor h) const
  {
    h = next(h, mesh());
    while (!is_border(h))
      h = next(opposite(h, mesh()), mesh());
    return h;
  }

  /// Calls `f(halfedge, segment)` for the halfedges on the borders of segments, by their faces in order, around each from its
  /// vertex of lowest number.
  template <typename F>
  void for_each_border_halfedge(const F& f) const
  {
    typename Traversal::Boundary boundary;
    m_traversal.for_each_face([&](face_descriptor fd) {
      const Index segment_of_fd = m_segment_of_face[m_rank_of_face(fd)];
      if (segment_of_fd == none || !touches_border(fd, segment_of_fd))
        return;
      m_traversal.read_boundary(fd, boundary);
      for (halfedge_descriptor h : boundary)
        if (opposite_segment(h) != segment_of_fd)
          f(h, segment_of_fd);
    });
  }

private:
  bool touches_border(face_descriptor f, Index segment_of_f) const
  {
    const halfedge_descriptor start = halfedge(f, mesh());
    halfedge_descriptor h = start;
    do {
      if (opposite_segment(h) != segment_of_f)
        return true;
      h = next(h, mesh());
    } while (h != start);
    return false;
  }

  const Traversal& m_traversal;
  const std::vector<Index>& m_segment_of_face;
  decltype(std::declval<const Traversal&>().rank_of_face()) m_rank_of_face;
};

/// The faces of each segment, in order.
template <typename Traversal>
Grouped_items<typename Traversal::face_descriptor>
faces_of_segments(const Segmented_mesh<Traversal>& segmented, std::size_t number_of_segments)
{
  Grouped_items<typename Traversal::face_descriptor> result(number_of_segments);
  for (auto segment : segmented.segment_of_face())
    if (segment != segmented.none)
      result.count(segment);
  result.end_counting();
  std::size_t rank = 0;
  segmented.traversal().for_each_face([&](const auto& f) {
    const auto segment = segmented.segment_of_face()[rank++];
    if (segment != segmented.none)
      result.add(segment, f);
  });
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENTED_MESH_H
