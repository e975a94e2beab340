// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LOWEST_ROOT_FOREST_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LOWEST_ROOT_FOREST_H

#include <CGAL/Region_segmentation/Partition.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The root of an element of a forest, in which a root is its own parent. Halves the path.
template <typename Parents, typename Index>
Index root_in_forest(Parents& parents, Index i)
{
  Index parent = parents[i];
  for (Index above = parents[parent]; above != parent; above = parents[parent]) {
    parents[i] = above;
    i = above;
    parent = parents[i];
  }
  return parent;
}

/// A forest over the faces in which a parent is never above its child: the root of a tree is its
/// lowest face, independently of the order of unions, so the array of parents becomes the array of
/// labels, numbered by first faces.
/// (`boost::disjoint_sets` keeps a second array and any root.)
///
/// Threads may unite concurrently, each within its own range of faces.
class Lowest_root_forest
{
public:
  using Index = Partition::Index;

  explicit Lowest_root_forest(std::size_t size)
    : m_parents(size)
  {
    std::iota(m_parents.begin(), m_parents.end(), Index(0));
  }
  /// `roots`: of the tree of each face
  explicit Lowest_root_forest(Partition::Numbers roots)
    : m_parents(std::move(roots))
  {}

  /// Returns whether they were in different trees.
  bool unite(Index a, Index b)
  {
    a = root(a);
    b = root(b);
    if (a == b)
      return false;
    m_parents[(std::max)(a, b)] = (std::min)(a, b);
    return true;
  }

  /// The lowest face of a tree.
  Index root(Index i) { return root_in_forest(m_parents, i); }

  /// Unites the tree of the root `r` with that of `a`; returns their root. Branch-free, since it is
  /// unpredictable whether they are united already.
  Index unite_with_root(Index r, Index a)
  {
    a = root(a);
    const Index lower = (std::min)(a, r);
    Index unused;
    *(a == r ? &unused : &m_parents[(std::max)(a, r)]) = lower;
    return lower;
  }

  /// Numbers the trees by their roots. The forest is empty afterwards.
  Partition take_partition()
  {
    Index number = 0;
    for (std::size_t i = 0; i < m_parents.size(); ++i) {
      const Index parent = m_parents[i];
      m_parents[i] = parent == i ? number++ : m_parents[parent];
    }
    return Partition(std::move(m_parents), number);
  }

private:
  Partition::Numbers m_parents;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LOWEST_ROOT_FOREST_H
