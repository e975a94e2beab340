// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_REMAINING_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_REMAINING_FACES_H

#include <CGAL/Region_segmentation/internal/faces/Face_search.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether a face of which all vertices are on faces that are found can have the label of one of
/// them: its vertices lie on that surface, and its normal is that of the surface within some 53
/// degrees, as long triangles across a fillet may have it; with a tolerance above rounding always.
inline bool may_join(const Face_search& search, Surface::Index face, Surface::Index label)
{
  constexpr double least_cosine = 0.6;
  const Fitted_surface<>& s = search.surfaces[label];
  return !search.is_exact() ||
         (search.test.has_vertices_on(s, face) &&
          search.test.has_normal_of(s, face, least_cosine) && !search.is_flat(label, face));
}

/// Faces of which all vertices are on faces that are found go to that neighbor from whose surface
/// they deviate least, beginning with those that have such a neighbor. Where a mesh does not follow
/// the creases, as after remeshing, faces cross them.
inline void join_remaining_faces(Face_search& search)
{
  using Index = Surface::Index;
  std::vector<Index> left;
  for (Index f = 0; f < search.labels.size(); ++f) {
    bool remains = !search.is_found(f);
    for (std::size_t i = 0; i < search.surface.number_of_corners(f); ++i)
      remains = remains && search.is_on_found[search.surface.corner(f, i)];
    if (remains)
      left.push_back(f);
  }
  std::vector<std::pair<Index, Index>> joined; // faces and their labels
  do {
    joined.clear();
    for (const Index f : left) {
      double least = std::numeric_limits<double>::infinity();
      Index best = Face_search::none;
      if (!search.is_found(f))
        for (const Face_neighbors::Neighbor& n : search.neighbors[f])
          if (search.is_found(n.face) && may_join(search, f, search.labels[n.face])) {
            const double deviation = search.test.deviation(search.surface_of(n.face), f);
            if (deviation < least) {
              least = deviation;
              best = search.labels[n.face];
            }
          }
      if (best != Face_search::none)
        joined.push_back({f, best});
    }
    for (const auto& [face, label] : joined)
      search.labels[face] = label;
  } while (!joined.empty());
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_REMAINING_FACES_H
