// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_MERGE_EQUAL_SURFACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_MERGE_EQUAL_SURFACES_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_grower.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The pairs of labels of faces that meet smoothly, each once, in order.
inline std::vector<std::pair<Surface::Index, Surface::Index>>
smooth_neighbors(const Face_search& search)
{
  using Index = Surface::Index;
  std::vector<std::pair<Index, Index>> pairs;
  for (Index f = 0; f < search.labels.size(); ++f)
    for_each_neighbor(search.surface, f, [&](Index g, Index, Index) {
      const Index i = search.labels[f], j = search.labels[g];
      if (i != Face_search::none && j != Face_search::none && i < j && search.mesh.is_smooth(f, g))
        pairs.push_back({i, j});
    });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Merges neighbors of which all vertices are on one surface: that of the larger one, or one that
/// is fitted to both.
class Equal_surfaces
{
public:
  using Index = Surface::Index;

  explicit Equal_surfaces(Face_search& search)
    : m_search(search)
    , m_mesh(search.mesh)
    , m_faces(search.surfaces.size())
    , m_now(search.surfaces.size())
    , m_points(search.surface)
  {
    std::iota(m_now.begin(), m_now.end(), Index(0));
    for (Index f = 0; f < search.labels.size(); ++f)
      if (search.is_found(f))
        m_faces[search.labels[f]].push_back(f);
  }

  void merge()
  {
    for (const auto& pair : smooth_neighbors(m_search)) {
      Index i = root_in_forest(m_now, pair.first), j = root_in_forest(m_now, pair.second);
      if (i == j)
        continue;
      if (m_faces[i].size() < m_faces[j].size())
        std::swap(i, j);
      if (can_merge(i, j)) {
        m_now[j] = i;
        m_faces[i].insert(m_faces[i].end(), m_faces[j].begin(), m_faces[j].end());
        m_faces[j].clear();
      }
    }
    for (Index& label : m_search.labels)
      if (label != Face_search::none)
        label = root_in_forest(m_now, label);
  }

private:
  /// Whether the faces of label j lie on a surface of the kind of label i with those of i, which
  /// then is the surface of i.
  bool can_merge(Index i, Index j)
  {
    Fitted_surface<> s = m_search.surfaces[i];
    if (s.kind == Surface_kind::PLANE && m_search.surfaces[j].kind != Surface_kind::PLANE)
      return false;
    const double largest = largest_deviation(m_mesh, s, m_faces[i]);
    if (!has_all(s, j, largest)) {
      m_points.clear();
      for (const Index label : {i, j})
        for (const Index f : m_faces[label])
          m_points.add(f);
      if (!refine_surface(s, m_points.points(), m_mesh.good_fit()) || !has_all(s, i, largest) ||
          !has_all(s, j, largest))
        return false;
    }
    m_search.surfaces[i] = s;
    return true;
  }

  /// `largest`: of the deviations of faces
  bool has_all(const Fitted_surface<>& s, Index label, double largest) const
  {
    return std::all_of(m_faces[label].begin(), m_faces[label].end(), [&](Index f) {
      return m_mesh.lies_on(s, f) && deviation_of_face(m_mesh.surface, s, f) <= largest;
    });
  }

  Face_search& m_search;
  const Tessellation& m_mesh;
  std::vector<std::vector<Index>> m_faces; // by label
  std::vector<Index> m_now;                // the labels that labels become
  Face_set m_points;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_MERGE_EQUAL_SURFACES_H
