// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEAM_SIDES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEAM_SIDES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/Halfedge_values.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/find_seams.h>
#include <CGAL/Region_segmentation/internal/support/Edge_marks.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Gives the two sides of every seam to two halves of the disc that the seams open.
///
/// The border of the disc passes every path of seams twice, once on each side. One side belongs to each half, so neither half
/// meets itself across a seam. Which one is chosen such that the halves alternate rarely around the disc, twice at best:
///
///      a---b      sides a b a' b' around the disc: halves 0 0 1 1, two changes
///      |   |
///      b'--a'     sides a a' b b': halves 0 1 0 1, four changes; with b exchanged 0 1 1 0, two
template <typename FaceGraph, typename Pack>
class Seam_sides
{
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using halfedge_descriptor = typename Traversal::halfedge_descriptor;
  using Index = std::uint32_t;

public:
  Seam_sides(const Segmented_mesh<Traversal>& segmented, const Pack& np, const Edge_marks& is_seam)
    : m_segmented(segmented), m_is_seam(segmented.mesh(), np, false), m_path_of(segmented.mesh(), np, Index(none))
    , m_is_node(border_vertices(segmented))
  {
    collect_seams(is_seam);
    find_nodes();
  }

  /// Calls `f(face, half)` for the face on each side of each seam, half 0 or 1.
  template <typename F>
  void for_each_side(const F& f)
  {
    for (halfedge_descriptor start : m_seams)
      if (m_path_of[start] == none && m_is_node[source_rank(start)]) {
        walk_around_disc(start);
        choose_halves();
        for (const Step& step : m_walk)
          f(face(step.halfedge, m_segmented.mesh()), half_of(m_sides[step.side]));
      }
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// A path of seams as the border of the disc passes it.
  struct Side
  {
    Index path;
    bool is_second;
  };

  struct Step
  {
    halfedge_descriptor halfedge;
    std::size_t side;
  };

  std::size_t source_rank(halfedge_descriptor h) const { return m_segmented.traversal().source_rank(h); }
  int half_of(const Side& side) const { return side.is_second != bool(m_is_exchanged[side.path]); }

  void collect_seams(const Edge_marks& is_seam)
  {
    m_segmented.traversal().for_each_dual_edge([&](halfedge_descriptor h, std::size_t dual_edge) {
      if (is_seam[dual_edge])
        for (halfedge_descriptor side : {h, opposite(h, m_segmented.mesh())}) {
          m_seams.push_back(side);
          m_is_seam[side] = true;
        }
    });
  }

  /// The vertices where paths of seams end.
  void find_nodes()
  {
    std::vector<Index> degrees(m_is_node.size(), 0);
    for (halfedge_descriptor h : m_seams)
      ++degrees[source_rank(h)];
    for (std::size_t v = 0; v < m_is_node.size(); ++v)
      m_is_node[v] |= degrees[v] != 0 && degrees[v] != 2;
  }

  /// The halfedge that follows on the border of the disc.
  halfedge_descriptor next_on_disc(halfedge_descriptor h) const
  {
    const FaceGraph& mesh = m_segmented.mesh();
    h = next(h, mesh);
    while (!m_is_seam[h] && !m_segmented.is_border(h))
      h = next(opposite(h, mesh), mesh);
    return h;
  }

  /// Numbers the paths on the border of a disc, from a node on.
  void walk_around_disc(halfedge_descriptor start)
  {
    m_walk.clear();
    m_sides.clear();
    Index number_of_paths = 0;
    halfedge_descriptor h = start;
    do {
      if (m_is_seam[h]) {
        const Index path_across = m_path_of[opposite(h, m_segmented.mesh())];
        if (m_is_node[source_rank(h)])
          m_sides.push_back({path_across == none ? number_of_paths++ : path_across, path_across != none});
        m_path_of[h] = m_sides.back().path;
        m_walk.push_back({h, m_sides.size() - 1});
      }
      h = next_on_disc(h);
    } while (h != start);
    m_is_exchanged.assign(number_of_paths, false);
  }

  /// How often the halves change beside the two sides of a path.
  std::size_t changes_at(const std::array<std::size_t, 2>& sides) const
  {
    std::size_t changes = 0;
    for (std::size_t i : sides)
      for (std::size_t j : {i + 1, i + m_sides.size() - 1})
        changes += half_of(m_sides[i]) != half_of(m_sides[j % m_sides.size()]);
    return changes;
  }

  /// Exchanges the sides of one path after another while that helps.
  void choose_halves()
  {
    std::vector<std::array<std::size_t, 2>> sides_of(m_is_exchanged.size());
    for (std::size_t i = 0; i < m_sides.size(); ++i)
      sides_of[m_sides[i].path][m_sides[i].is_second] = i;
    for (bool is_better = true; is_better;) {
      is_better = false;
      for (std::size_t path = 0; path < sides_of.size(); ++path) {
        const std::size_t before = changes_at(sides_of[path]);
        m_is_exchanged[path] = !m_is_exchanged[path];
        if (changes_at(sides_of[path]) < before)
          is_better = true;
        else
          m_is_exchanged[path] = !m_is_exchanged[path];
      }
    }
  }

  const Segmented_mesh<Traversal>& m_segmented;
  std::vector<halfedge_descriptor> m_seams; // both halfedges of each
  Halfedge_values<FaceGraph, Pack, char> m_is_seam;
  Halfedge_values<FaceGraph, Pack, Index> m_path_of;
  std::vector<char> m_is_node; // by vertex

  // of one disc
  std::vector<Step> m_walk;
  std::vector<Side> m_sides;
  std::vector<char> m_is_exchanged; // by path
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEAM_SIDES_H
