// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISC_DIVIDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISC_DIVIDER_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/segments/Seam_sides.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/find_seams.h>
#include <CGAL/Region_segmentation/internal/segments/topology.h>
#include <CGAL/Region_segmentation/internal/support/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Divides segments until all are discs: into components first; then each into two halves of the disc that its seams open,
/// those of the faces nearer to one side of the seams than to the other.
///
/// A face with different sides of seams belongs to one half, which may then still meet itself; so this is repeated. A
/// segment that it does not divide any further becomes single faces.
template <typename FaceGraph, typename Pack>
class Disc_divider
{
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

public:
  Disc_divider(const Traversal& traversal, const Pack& np, const Flat_mesh& flat, double concave_gain,
               std::vector<Index> segment_of_face)
    : m_traversal(traversal), m_np(np), m_flat(flat), m_concave_gain(concave_gain)
    , m_segment_of_face(std::move(segment_of_face))
  {}

  /// Returns the number of discs; afterwards `disc_of_face()` is numbered by first faces.
  std::size_t divide()
  {
    std::size_t number = divide_into_components(), previous = 0;
    while (find_discs(number) < number) {
      if (number == previous)
        divide_into_faces();
      else
        divide_into_halves();
      previous = std::exchange(number, divide_into_components());
    }
    return number;
  }

  const std::vector<Index>& disc_of_face() const { return m_segment_of_face; }

private:
  using Segments = Segmented_mesh<Traversal>;

  std::size_t divide_into_components()
  {
    const Partition components = components_of_segments(Segments(m_traversal, m_segment_of_face));
    std::vector<Index> numbers(components.number_of_parts(), none);
    Index number = 0;
    for (std::size_t f = 0; f < m_segment_of_face.size(); ++f)
      if (m_segment_of_face[f] != none) {
        Index& of_component = numbers[components[f]];
        if (of_component == none)
          of_component = number++;
        m_segment_of_face[f] = of_component;
      }
    return number;
  }

  /// Returns the number of segments that are discs.
  std::size_t find_discs(std::size_t number_of_segments)
  {
    m_is_disc.clear();
    for (const Surface_counts& counts : count_surfaces(Segments(m_traversal, m_segment_of_face), m_np, number_of_segments))
      m_is_disc.push_back(counts.is_disc());
    return std::size_t(std::count(m_is_disc.begin(), m_is_disc.end(), true));
  }

  bool is_divided(std::size_t face) const { return m_segment_of_face[face] != none && !m_is_disc[m_segment_of_face[face]]; }

  void divide_into_halves()
  {
    const Segments segments(m_traversal, m_segment_of_face);
    const Edge_marks is_seam =
      find_seams(segments, m_flat, m_concave_gain, [&](Index segment) { return !m_is_disc[segment]; });
    std::vector<Index> half_of_face(m_segment_of_face.size(), none);
    std::vector<Index> sources;
    const auto rank = m_traversal.rank_of_face();
    Seam_sides<FaceGraph, Pack>(segments, m_np, is_seam).for_each_side([&](const auto& f, int half) {
      Index& half_of_f = half_of_face[rank(f)];
      if (half_of_f == none) {
        half_of_f = Index(half);
        sources.push_back(Index(rank(f)));
      }
    });
    spread_halves(is_seam, sources, half_of_face);
    for (std::size_t f = 0; f < m_segment_of_face.size(); ++f)
      if (m_segment_of_face[f] != none)
        m_segment_of_face[f] = 2 * m_segment_of_face[f] + (half_of_face[f] == 1);
  }

  /// To the other faces, by the distance of centroids inside the discs.
  void spread_halves(const Edge_marks& is_seam, const std::vector<Index>& sources, std::vector<Index>& half_of_face) const
  {
    const Dual_graph_of<double> steps(
      m_flat,
      [&](std::size_t e) {
        const Index a = m_flat.lower_face(e);
        return m_segment_of_face[a] == m_segment_of_face[m_flat.higher_face(e)] && is_divided(a) && !is_seam[e];
      },
      [&](std::size_t f, std::size_t e) { return norm(m_flat.centroid(f) - m_flat.centroid(m_flat.higher_face(e))); });
    std::vector<double> distances(m_segment_of_face.size(), std::numeric_limits<double>::infinity());
    find_shortest_paths(
      sources, distances, [](Index) { return true; },
      [&](Index f, const auto& enter) {
        for (const auto& step : steps.steps(f))
          if (enter(step.face, step.length))
            half_of_face[step.face] = half_of_face[f];
      });
  }

  void divide_into_faces()
  {
    Index next = Index(m_is_disc.size());
    for (std::size_t f = 0; f < m_segment_of_face.size(); ++f)
      if (is_divided(f))
        m_segment_of_face[f] = next++; // of a face whose segment is seen no more
  }

  const Traversal& m_traversal;
  const Pack& m_np;
  const Flat_mesh& m_flat;
  const double m_concave_gain;
  std::vector<Index> m_segment_of_face;
  std::vector<char> m_is_disc; // by segment
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISC_DIVIDER_H
