// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_SELECTION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_SELECTION_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Float_key.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// One round of joining patches, see `Mesh_patches`: which patches select each other, and which are joined. O(size).
///
/// Selections alone would join the patches of a graded mesh in chains without bound; so their trees are cut at every
/// second level:
///
///       depth  0  1  2  3  4
///              o--o  o--o--o      the last one is a leaf
class Patch_selection
{
  using Index = Partition::Index;

public:
  /// `Patches`: `size()`, `area(i)`, `centroid(i)`, `normal(i)`, `for_each_adjacency(f)` with `f(lower, higher, ...)`
  template <typename Patches>
  Patch_selection(const Patches& patches, double maximum_area, double unit, double deviation_weight)
    : m_selected(patches.size())
  {
    // The steps and the other patches; the lowest is selected without a branch, which would be mispredicted often.
    Large_array<Float_key> selections(patches.size());
    for (std::size_t i = 0; i < selections.size(); ++i)
      selections[i] = make_float_key(unselected, Index(i));
    const double scale = 1 / unit;
    patches.for_each_adjacency([&](Index a, Index b, std::size_t) {
      if (!(patches.area(a) + patches.area(b) <= maximum_area))
        return;
      const float step = float(scale * norm(patches.centroid(a) - patches.centroid(b)) +
                               deviation_weight * norm(patches.normal(a) - patches.normal(b)));
      selections[a] = (std::min)(selections[a], make_float_key(step, b));
      selections[b] = (std::min)(selections[b], make_float_key(step, a));
    });
    for (std::size_t i = 0; i < selections.size(); ++i)
      m_selected[i] = index_of(selections[i]);
    make_roots(patches);
  }

  /// The partition of the patches into those that are joined.
  Partition joined() const
  {
    const std::vector<std::uint8_t> state = states();
    std::vector<Index> part_of(m_selected.size(), none);
    Index number_of_parts = 0;
    for (std::size_t i = 0; i < m_selected.size(); ++i) {
      Index& part = part_of[root(Index(i), state)];
      const bool is_new = part == none; // unpredictable
      part = is_new ? number_of_parts : part;
      number_of_parts += is_new;
      part_of[i] = part;
    }
    return Partition(std::move(part_of), number_of_parts);
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  static constexpr float unselected = std::numeric_limits<float>::infinity();
  enum State : std::uint8_t { IS_KNOWN = 1, IS_ODD = 2, HAS_CHILD = 4 };

  /// Of two patches that select each other, the larger one is a root: it selects itself; of equal ones, the lower one.
  template <typename Patches>
  void make_roots(const Patches& patches)
  {
    for (std::size_t i = 0; i < m_selected.size(); ++i)
      if (const Index j = m_selected[i]; j > i && m_selected[j] == i) {
        const Index larger = patches.area(j) > patches.area(i) ? j : Index(i);
        m_selected[larger] = larger;
      }
  }

  /// The parity of the depth of each patch, and whether it is a leaf.
  std::vector<std::uint8_t> states() const
  {
    std::vector<std::uint8_t> state(m_selected.size(), 0);
    std::vector<Index> path;
    for (std::size_t i = 0; i < state.size(); ++i) {
      if (m_selected[i] != i)
        state[m_selected[i]] |= HAS_CHILD;
      Index p = Index(i);
      for (; !(state[p] & IS_KNOWN) && m_selected[p] != p; p = m_selected[p])
        path.push_back(p);
      state[p] |= IS_KNOWN;
      for (std::uint8_t parity = state[p] & IS_ODD; !path.empty(); path.pop_back()) {
        parity ^= IS_ODD;
        state[path.back()] |= IS_KNOWN | parity;
      }
    }
    return state;
  }

  Index root(Index i, const std::vector<std::uint8_t>& state) const
  {
    const Index parent = m_selected[i], grandparent = m_selected[parent];
    const Index of_even = state[i] & HAS_CHILD ? i : grandparent;
    return state[i] & IS_ODD ? parent : of_even;
  }

  Large_array<Index> m_selected; // by patch; itself: a root
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_SELECTION_H
