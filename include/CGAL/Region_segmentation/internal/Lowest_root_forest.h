// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_LOWEST_ROOT_FOREST_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_LOWEST_ROOT_FOREST_H

#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <boost/atomic/atomic_ref.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A forest over the faces in which a parent is never above its child: the root of a tree is its lowest face,
/// whatever the order of the unions, so the array of parents becomes the array of labels, numbered by first
/// faces. (`boost::disjoint_sets` keeps a second array and any root.)
///
/// With `Parallel_tag` several threads may unite at the same time: a root gets a parent by one atomic exchange,
/// and what halves a path writes an ancestor over an ancestor (Anderson and Woll 1991).
template <typename ConcurrencyTag = CGAL::Sequential_tag>
class Lowest_root_forest
{
public:
  using Index = Flat_mesh::Index;

  explicit Lowest_root_forest(std::size_t size) : m_parents(size + 1)
  {
    for_each_block<ConcurrencyTag>(size, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        m_parents[i] = Index(i);
    });
  }

  /// Unites the tree of `a` with that of the root `r`; returns their root. In sequence only. Whether they are
  /// united already cannot be predicted: so there is no branch, and a cell that nobody reads is written if they are.
  Index unite_with_root(Index r, Index a)
  {
    a = root(a);
    const Index lower = (std::min)(a, r);
    m_parents[a == r ? m_parents.size() - 1 : (std::max)(a, r)] = lower;
    return lower;
  }

  void unite(Index a, Index b)
  {
    while (true) {
      a = root(a);
      b = root(b);
      if (a == b)
        return;
      if (a < b)
        std::swap(a, b);
      if (make_child(a, b))
        return;
    }
  }

  /// Numbers the trees by their roots. The forest is empty afterwards.
  Region_labels take_labels()
  {
    Region_labels labels;
    m_parents.pop_back();
    if constexpr (is_parallel<ConcurrencyTag>)
      labels.number_of_regions = number_in_parallel();
    else
      for (std::size_t i = 0; i < m_parents.size(); ++i) {
        const Index parent = m_parents[i];
        m_parents[i] = parent == i ? Index(labels.number_of_regions++) : m_parents[parent];
      }
    labels.of_face = std::move(m_parents);
    return labels;
  }

private:
  Index parent(Index i)
  {
    if constexpr (is_parallel<ConcurrencyTag>)
      return boost::atomic_ref<Index>(m_parents[i]).load(boost::memory_order_relaxed);
    else
      return m_parents[i];
  }

  void set_parent(Index i, Index parent)
  {
    if constexpr (is_parallel<ConcurrencyTag>)
      boost::atomic_ref<Index>(m_parents[i]).store(parent, boost::memory_order_relaxed);
    else
      m_parents[i] = parent;
  }

  /// False if `root` has got a parent meanwhile.
  bool make_child(Index root, Index parent)
  {
    if constexpr (is_parallel<ConcurrencyTag>)
      return boost::atomic_ref<Index>(m_parents[root])
        .compare_exchange_strong(root, parent, boost::memory_order_relaxed);
    else {
      m_parents[root] = parent;
      return true;
    }
  }

  Index root(Index i)
  {
    Index p = parent(i);
    for (Index above = parent(p); above != p; above = parent(p)) {
      set_parent(i, above); // path halving
      i = above;
      p = parent(i);
    }
    return p;
  }

  /// Replaces parents by numbers: those of the roots first, since they are looked up there.
  std::size_t number_in_parallel()
  {
    std::vector<std::vector<Index>> roots(number_of_blocks(m_parents.size()));
    for_each_block<ConcurrencyTag>(
      m_parents.size(), [&](std::size_t block, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Index r = root(Index(i));
          set_parent(Index(i), r);
          if (r == i)
            roots[block].push_back(r);
        }
      });
    std::size_t number = 0;
    for (const auto& of_block : roots)
      for (Index r : of_block)
        m_parents[r] = Index(number++);
    for_each_block<ConcurrencyTag>(
      m_parents.size(), [&](std::size_t block, std::size_t begin, std::size_t end) {
        auto next_root = roots[block].begin();
        for (std::size_t i = begin; i < end; ++i)
          if (next_root != roots[block].end() && *next_root == i)
            ++next_root;
          else
            m_parents[i] = m_parents[m_parents[i]];
      });
    return number;
  }

  std::vector<Index> m_parents; // and a cell that nobody reads
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_LOWEST_ROOT_FOREST_H
