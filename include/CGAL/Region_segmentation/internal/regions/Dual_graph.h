// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_DUAL_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_DUAL_GRAPH_H

#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The adjacency of faces, or of patches, in both directions, with a length for each step.
/// 8 bytes per face, and 8 for each side of a dual edge: searches
/// over all faces are memory-bound, so lengths are float.
class Dual_graph
{
public:
  using Index = Surface::Index;

  struct Step
  {
    Index face;
    float length;
  };

  /// Of the adjacencies for which `is_step(adjacency)`.
  template <typename IsStep, typename LengthOf>
  Dual_graph(const Surface& surface, const IsStep& is_step, const LengthOf& length)
    : m_steps(surface.number_of_faces())
  {
    add_steps([&](const auto& add) {
      for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
        if (is_step(a))
          add(surface.lower_face(a), surface.higher_face(a), [&] { return length(a); });
    });
  }

  /// Of patches in place of faces, across edges; `length(i)`: of the i-th adjacency.
  template <typename LengthOf>
  Dual_graph(const Patches& patches, const LengthOf& length)
    : m_steps(patches.size())
  {
    add_steps([&](const auto& add) { add_edges(patches, length, add); });
  }

  /// The same, and across seams and links; `length_of_contact(contact)`.
  template <typename LengthOf, typename LengthOfContact>
  Dual_graph(const Patches& patches, const LengthOf& length,
             const LengthOfContact& length_of_contact)
    : m_steps(patches.size())
  {
    add_steps([&](const auto& add) {
      add_edges(patches, length, add);
      for (const Patches::Adjacency& contact : patches.contacts())
        add(contact.lower, contact.higher, [&] { return length_of_contact(contact); });
    });
  }

  std::size_t number_of_faces() const { return m_steps.number_of_groups(); }

  /// The steps from a face, those to lower faces first, in order.
  Iterator_range<const Step*> steps(std::size_t face) const { return m_steps[face]; }

private:
  template <typename LengthOf, typename Add>
  static void add_edges(const Patches& patches, const LengthOf& length, const Add& add)
  {
    for (std::size_t i = 0; i < patches.adjacencies().size(); ++i)
      add(patches.adjacencies()[i].lower, patches.adjacencies()[i].higher,
          [&] { return length(i); });
  }

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
      const float l = float(length());
      m_steps.add(f, {g, l});
      m_steps.add(g, {f, l});
    });
  }

  Grouped_items<Step> m_steps; // by face
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_DUAL_GRAPH_H
