// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_SELECTION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_SELECTION_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The lowest key that each element was offered; with `Parallel_tag` threads may offer keys
/// concurrently.
class Lowest_keys
{
public:
  /// Not initialized. `execution`: in parallel, threads may offer keys concurrently
  Lowest_keys(std::size_t size, const Execution& execution)
    : m_keys(size)
    , m_is_parallel(execution.is_parallel())
  {}

  void set(std::size_t i, Float_key key) { m_keys[i].store(key, std::memory_order_relaxed); }
  Float_key operator[](std::size_t i) const { return m_keys[i].load(std::memory_order_relaxed); }

  void offer(std::size_t i, Float_key key)
  {
    Float_key lowest = (*this)[i];
    if (m_is_parallel)
      while (key < lowest &&
             !m_keys[i].compare_exchange_weak(lowest, key, std::memory_order_relaxed)) {
      }
    else // without a branch, which would be mispredicted often
      set(i, (std::min)(lowest, key));
  }

private:
  Large_array<std::atomic<Float_key>> m_keys;
  bool m_is_parallel;
};

/// One round of joining patches, see `Surface_patches`: which patches select each other, and which
/// are joined. O(size).
///
/// Selections alone would join the patches of a graded mesh in chains without bound; so their trees
/// are cut at every second level:
///
///       depth  0  1  2  3  4
///              o--o  o--o--o      the last one is a leaf
///
/// Threads read what others write only where the order does not matter: the lowest step of a patch,
/// and the parity of its depth, which is the same whoever finds it.
class Patch_selection
{
  using Index = Partition::Index;

public:
  /// `Patches`: `size()`, `area(i)`, `centroid(i)`, `normal(i)`, `number_of_ranges()` of
  /// adjacencies, `for_each_adjacency(range, f)` with `f(lower, higher, ...)`
  template <typename Patches>
  Patch_selection(const Patches& patches, double maximum_area, double unit, double deviation_weight,
                  const Execution& execution)
    : m_execution(execution.silent())
    , m_parents(patches.size())
  {
    Lowest_keys selections(patches.size(), execution); // the steps and the other patches
    for_each_index(m_execution, patches.size(),
                   [&](std::size_t i) { selections.set(i, make_float_key(unselected, Index(i))); });
    const double scale = 1 / unit;
    m_execution.for_each(0, patches.number_of_ranges(), [&](std::size_t range) {
      patches.for_each_adjacency(range, [&](Index a, Index b, const auto&) {
        if (!(patches.area(a) + patches.area(b) <= maximum_area))
          return;
        const float step = float(scale * norm(patches.centroid(a) - patches.centroid(b)) +
                                 deviation_weight * norm(patches.normal(a) - patches.normal(b)));
        selections.offer(a, make_float_key(step, b));
        selections.offer(b, make_float_key(step, a));
      });
    });
    // Of two patches that select each other, the larger one is a root; of equal ones, the lower
    // one.
    for_each_index(m_execution, patches.size(), [&](std::size_t i) {
      const Index j = index_of(selections[i]);
      const bool is_root = index_of(selections[j]) == i &&
                           (i < j ? !(patches.area(j) > patches.area(i))
                                  : patches.area(i) > patches.area(j));
      m_parents[i] = is_root ? Index(i) : j;
    });
  }

  /// The partition of the patches into those that are joined.
  Partition joined() &&
  {
    Large_array<Index> roots = find_roots();
    m_parents = Large_array<Index>(); // its memory is needed
    Partition::Numbers part_of(roots.size(), none);
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
  static constexpr float unselected = std::numeric_limits<float>::infinity();

  /// What is known of the depth of a patch.
  enum Parity : std::uint8_t { UNKNOWN, EVEN, ODD };

  /// The patch that keeps what each patch is joined to.
  Large_array<Index> find_roots() const
  {
    std::vector<std::atomic<bool>> has_child(m_parents.size());
    std::vector<std::atomic<std::uint8_t>> parities(m_parents.size()); // UNKNOWN
    for_each_block(m_execution, m_parents.size(),
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     std::vector<Index> path;
                     for (std::size_t i = begin; i < end; ++i) {
                       // of a root, too, which does not matter
                       has_child[m_parents[i]].store(true, std::memory_order_relaxed);
                       find_parity(Index(i), parities, path);
                     }
                   });
    Large_array<Index> roots(m_parents.size());
    for_each_index(m_execution, roots.size(), [&](std::size_t i) {
      const Index parent = m_parents[i], grandparent = m_parents[parent];
      const Index of_even = has_child[i].load(std::memory_order_relaxed) ? Index(i) : grandparent;
      roots[i] = parities[i].load(std::memory_order_relaxed) == ODD ? parent : of_even;
    });
    return roots;
  }

  /// Sets the parity of a patch, and, of a deep one, of those above it. `path`: is empty, before
  /// and after
  void find_parity(Index i, std::vector<std::atomic<std::uint8_t>>& parities,
                   std::vector<Index>& path) const
  {
    const Index parent = m_parents[i], grandparent = m_parents[parent];
    if (m_parents[grandparent] == grandparent) { // of most; without unpredictable branches
      const bool is_odd = (parent != i) != (grandparent != parent);
      parities[i].store(is_odd ? ODD : EVEN, std::memory_order_relaxed);
      return;
    }
    std::uint8_t parity = parities[i].load(std::memory_order_relaxed);
    while (parity == UNKNOWN && m_parents[i] != i) {
      path.push_back(i);
      i = m_parents[i];
      parity = parities[i].load(std::memory_order_relaxed);
    }
    if (parity == UNKNOWN) { // a root
      parity = EVEN;
      parities[i].store(parity, std::memory_order_relaxed);
    }
    for (; !path.empty(); path.pop_back()) {
      parity = parity == ODD ? EVEN : ODD;
      parities[path.back()].store(parity, std::memory_order_relaxed);
    }
  }

  const Execution m_execution;  // silent
  Large_array<Index> m_parents; // by patch: the one it selected; itself: a root
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_SELECTION_H
