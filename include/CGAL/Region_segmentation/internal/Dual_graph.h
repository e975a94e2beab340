// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_DUAL_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_DUAL_GRAPH_H

#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/Large_array.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The faces and their neighbors on both sides, with a length for each step. Constrained edges are no
/// step. 4 bytes a face and 8 for each side of a dual edge: searches are bound by memory, so lengths are
/// float.
class Dual_graph
{
public:
  using Index = Flat_mesh::Index;

  struct Step
  {
    Index face;
    float length;
  };

  /// `length(face, edge)`: of a dual edge and its lower face.
  template <typename Length>
  Dual_graph(const Flat_mesh& mesh, const Length& length)
    : m_first(mesh.number_of_faces() + 2, 0)
  {
    // Counted two places further on, so that filling moves each start to where it belongs.
    for_each_step(mesh, [&](std::size_t f, std::size_t g, std::size_t) {
      ++m_first[f + 2];
      ++m_first[g + 2];
    });
    for (std::size_t f = 2; f < m_first.size(); ++f)
      m_first[f] += m_first[f - 1];
    m_steps.resize(m_first.back());
    for_each_step(mesh, [&](std::size_t f, std::size_t g, std::size_t e) {
      const float l = float(length(f, e));
      m_steps[m_first[f + 1]++] = {Index(g), l};
      m_steps[m_first[g + 1]++] = {Index(f), l};
    });
  }

  /// The steps from a face, those to lower faces first, in order.
  Iterator_range<const Step*> steps(std::size_t face) const
  {
    return {m_steps.data() + m_first[face], m_steps.data() + m_first[face + 1]};
  }

  /// Tells the processor that the steps from a face will be wanted: a search waits for memory most of the time.
  void prefetch_steps(std::size_t face) const
  {
#ifdef __GNUC__
    __builtin_prefetch(m_steps.data() + m_first[face]);
#else
    static_cast<void>(face);
#endif
  }

  /// Of a step; 0 where there is none.
  double mean_length() const
  {
    double sum = 0;
    for (const Step& step : m_steps)
      sum += double(step.length);
    return m_steps.empty() ? 0 : sum / double(m_steps.size());
  }

private:
  template <typename F>
  static void for_each_step(const Flat_mesh& mesh, const F& f)
  {
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      if (!mesh.has_flag(e, Flat_mesh::CONSTRAINED))
        f(mesh.lower_face(e), mesh.higher_face(e), e);
  }

  Large_array<Index> m_first;
  Large_array<Step> m_steps;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_DUAL_GRAPH_H
