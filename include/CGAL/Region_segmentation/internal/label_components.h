// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_LABEL_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_LABEL_COMPONENTS_H

#include <CGAL/Region_segmentation/internal/Region_labels.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A forest over the faces in which a parent is never above its child: the root of a tree is its
/// lowest face, so one scan in order numbers the components by their first face, and the array of
/// parents becomes the array of labels. (`boost::disjoint_sets` keeps a second array and any root.)
class Lowest_root_forest
{
public:
  using Index = Flat_mesh::Index;

  explicit Lowest_root_forest(std::size_t size) : m_parents(size)
  {
    for (std::size_t i = 0; i < size; ++i)
      m_parents[i] = Index(i);
  }

  void unite(Index a, Index b)
  {
    a = root(a);
    b = root(b);
    if (a < b)
      m_parents[b] = a;
    else
      m_parents[a] = b;
  }

  /// Numbers the trees by their roots. The forest is empty afterwards.
  Region_labels take_labels()
  {
    Region_labels labels;
    for (std::size_t i = 0; i < m_parents.size(); ++i) {
      const Index parent = m_parents[i];
      m_parents[i] = parent == i ? Index(labels.number_of_regions++) : m_parents[parent];
    }
    labels.of_face = std::move(m_parents);
    return labels;
  }

private:
  Index root(Index i)
  {
    while (m_parents[i] != i) {
      m_parents[i] = m_parents[m_parents[i]]; // path halving
      i = m_parents[i];
    }
    return i;
  }

  std::vector<Index> m_parents;
};

/// The connected components of the faces across edges that are neither marked nor closed by a
/// degenerate face. O(F) in practice (inverse Ackermann is replaced by a logarithm at worst).
inline Region_labels label_components(const Flat_mesh& flat, const Edge_marks& is_feature)
{
  Lowest_root_forest forest(flat.number_of_faces());
  for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
    for (std::size_t e = flat.first_edge(f); e < flat.first_edge(f + 1); ++e)
      if (!is_feature[e] && !flat.has_flag(e, Flat_mesh::CLOSED))
        forest.unite(Flat_mesh::Index(f), flat.higher_face(e));
  return forest.take_labels();
}

/// Clears the marks of edges between two faces of one region, unless they are constrained.
inline void clear_marks_within_regions(const Flat_mesh& flat, const Region_labels& regions,
                                       Edge_marks& is_feature)
{
  for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
    for (std::size_t e = flat.first_edge(f); e < flat.first_edge(f + 1); ++e)
      if (regions.of_face[f] == regions.of_face[flat.higher_face(e)] &&
          !flat.has_flag(e, Flat_mesh::CONSTRAINED))
        is_feature[e] = 0;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_LABEL_COMPONENTS_H
