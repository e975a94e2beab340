// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_DUAL_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_DUAL_GRAPH_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The adjacency of faces, or of patches, in both directions, with a length for each step. Constrained edges are not
/// steps. 8 bytes per face, and with lengths in float 8 for each side of a dual edge.
template <typename Length>
class Dual_graph_of
{
public:
  using Index = Flat_mesh::Index;

  struct Step
  {
    Index face;
    Length length;
  };

  /// `length(face, edge)`: of a dual edge and its lower face.
  template <typename LengthOf>
  Dual_graph_of(const Flat_mesh& mesh, const LengthOf& length)
    : Dual_graph_of(mesh, [](std::size_t) { return true; }, length)
  {}

  /// Only the dual edges for which `is_step(edge)`.
  template <typename IsStep, typename LengthOf>
  Dual_graph_of(const Flat_mesh& mesh, const IsStep& is_step, const LengthOf& length)
    : m_steps(mesh.number_of_faces())
  {
    add_steps([&](const auto& add) {
      for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
        if (!mesh.has_flag(e, Flat_mesh::CONSTRAINED) && is_step(e))
          add(mesh.lower_face(e), mesh.higher_face(e), [&] { return length(mesh.lower_face(e), e); });
    });
  }

  /// Of patches in place of faces; `length(i)`: of the i-th adjacency.
  template <typename LengthOf>
  Dual_graph_of(const Patches& patches, const LengthOf& length)
    : m_steps(patches.size())
  {
    add_steps([&](const auto& add) {
      for (std::size_t i = 0; i < patches.adjacencies().size(); ++i)
        add(patches.adjacencies()[i].lower, patches.adjacencies()[i].higher, [&] { return length(i); });
    });
  }

  std::size_t number_of_faces() const { return m_steps.number_of_groups(); }

  /// The steps from a face, those to lower faces first, in order.
  Iterator_range<const Step*> steps(std::size_t face) const { return m_steps[face]; }

private:
  /// `for_each(add)` calls `add(face, other_face, length)` for each step; it is called twice.
  template <typename ForEach>
  void add_steps(const ForEach& for_each)
  {
    for_each([this](Index f, Index g, const auto&) {
      m_steps.count(f);
      m_steps.count(g);
    });
    m_steps.end_counting();
    for_each([this](Index f, Index g, const auto& length) {
      const Length l = Length(length());
      m_steps.add(f, {g, l});
      m_steps.add(g, {f, l});
    });
  }

  Grouped_items<Step> m_steps; // by face
};

/// Searches over all faces are memory-bound, so lengths are float.
using Dual_graph = Dual_graph_of<float>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_DUAL_GRAPH_H
