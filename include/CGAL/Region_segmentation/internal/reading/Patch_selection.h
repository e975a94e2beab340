// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_SELECTION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_SELECTION_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/grid.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_keys.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <atomic>
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
///
/// Threads read what others write only where the order does not matter: the lowest step of a patch, and the parity of its
/// depth, which is the same whoever finds it.
template <typename ConcurrencyTag>
class Patch_selection
{
  using Index = Partition::Index;

public:
  /// `Patches`: `size()`, `area(i)`, `centroid(i)`, `normal(i)`, `position(i)`, `number_of_ranges()` of adjacencies,
  /// `for_each_adjacency(range, f)` with `f(lower, higher, ...)`
  template <typename Patches>
  Patch_selection(const Patches& patches, double maximum_area, double unit, double deviation_weight)
    : m_parents(patches.size())
  {
    while (patches.size() >> m_index_bits > 0)
      ++m_index_bits;
    const double positions = double(std::uint64_t(1) << (64 - step_bits - m_index_bits));
    // Of the patch `j`, by the step to it, then by its position.
    const auto key = [&](std::uint64_t step, Index j) {
      return (((step << (64 - step_bits - m_index_bits)) | std::uint64_t(positions * patches.position(j))) << m_index_bits) | j;
    };
    Lowest_keys<ConcurrencyTag> selections(patches.size());
    for_each_index<ConcurrencyTag>(
      patches.size(), [&](std::size_t i) { selections.set(i, (unselected << (64 - step_bits)) | i); });
    const double scale = 1 / unit, most = maximum_area * (1 + 1e-9);
    for_each_block_of<ConcurrencyTag>(0, patches.number_of_ranges(), [&](std::size_t range) {
      patches.for_each_adjacency(range, [&](Index a, Index b, std::size_t) {
        if (!(patches.area(a) + patches.area(b) <= most))
          return;
        const std::uint64_t step = coarse_bits(scale * norm(patches.centroid(a) - patches.centroid(b)) +
                                               deviation_weight * norm(patches.normal(a) - patches.normal(b)));
        selections.offer(a, key(step, b));
        selections.offer(b, key(step, a));
      });
    });
    const auto selected_by = [&](std::size_t i) { return Index(selections[i] & ((std::uint64_t(1) << m_index_bits) - 1)); };
    // Of two patches that select each other, the larger one is a root; of equal ones, that of the lower position.
    for_each_index<ConcurrencyTag>(patches.size(), [&](std::size_t i) {
      const Index j = selected_by(i);
      const auto smallness = [&](Index p) { return unselected - coarse_bits(scale * scale * patches.area(p)); };
      const bool is_root = selected_by(j) == i && key(smallness(Index(i)), Index(i)) < key(smallness(j), j);
      m_parents[i] = is_root ? Index(i) : j;
    });
  }

  /// The partition of the patches into those that are joined.
  Partition joined() &&
  {
    Large_array<Index> roots = find_roots();
    m_parents = Large_array<Index>(); // its memory is needed
    std::vector<Index> part_of(roots.size(), none);
    Index number_of_parts = 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      Index& part = part_of[roots[i]];
      const bool is_new = part == none; // unpredictable
      part = is_new ? number_of_parts : part;
      number_of_parts += is_new;
      part_of[i] = part;
    }
    return Partition(std::move(part_of), number_of_parts);
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  static constexpr unsigned step_bits = 20;
  static constexpr std::uint64_t unselected = (std::uint64_t(1) << step_bits) - 1; // above all steps

  /// What is known of the depth of a patch.
  enum Parity : std::uint8_t { UNKNOWN, EVEN, ODD };

  /// The patch that keeps what each patch is joined to.
  Large_array<Index> find_roots() const
  {
    std::vector<std::atomic<bool>> has_child(m_parents.size());
    std::vector<std::atomic<std::uint8_t>> parities(m_parents.size()); // UNKNOWN
    for_each_block(Execution<ConcurrencyTag>(), m_parents.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      std::vector<Index> path;
      for (std::size_t i = begin; i < end; ++i) {
        if (m_parents[i] != i)
          has_child[m_parents[i]].store(true, std::memory_order_relaxed);
        find_parity(Index(i), parities, path);
      }
    });
    Large_array<Index> roots(m_parents.size());
    for_each_index<ConcurrencyTag>(roots.size(), [&](std::size_t i) {
      const Index parent = m_parents[i], grandparent = m_parents[parent];
      const Index of_even = has_child[i].load(std::memory_order_relaxed) ? Index(i) : grandparent;
      roots[i] = parities[i].load(std::memory_order_relaxed) == ODD ? parent : of_even;
    });
    return roots;
  }

  /// Sets the parity of a patch, and of those above it. `path`: is empty, before and after
  void find_parity(Index i, std::vector<std::atomic<std::uint8_t>>& parities, std::vector<Index>& path) const
  {
    std::uint8_t parity = parities[i].load(std::memory_order_relaxed);
    for (; parity == UNKNOWN; parity = parities[i].load(std::memory_order_relaxed)) {
      path.push_back(i);
      if (m_parents[i] == i) {
        parity = ODD; // of what would be above the root
        break;
      }
      i = m_parents[i];
    }
    for (; !path.empty(); path.pop_back()) {
      parity = parity == ODD ? EVEN : ODD;
      parities[path.back()].store(parity, std::memory_order_relaxed);
    }
  }

  Large_array<Index> m_parents; // by patch: the one it selected; itself: a root
  unsigned m_index_bits = 0;    // of a key
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_PATCH_SELECTION_H
