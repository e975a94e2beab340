// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_DROP_OSCULATING_SURFACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_DROP_OSCULATING_SURFACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// By label: whether it is of a curved surface, and no vertex is inside its face.
inline std::vector<std::uint8_t> single_rows(const Face_search& search)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  constexpr Index unseen = Face_search::none - 1;
  std::vector<Index> of_vertex(surface.number_of_vertices(), unseen); // none: of several labels
  for (Index f = 0; f < search.labels.size(); ++f)
    for (const Index v : surface.corners(f))
      of_vertex[v] = of_vertex[v] == unseen || of_vertex[v] == search.labels[f] ? search.labels[f]
                                                                                : Face_search::none;
  std::vector<std::uint8_t> result;
  for (const Fitted_surface<>& s : search.surfaces)
    result.push_back(s.kind != Surface_kind::PLANE);
  for (const Index label : of_vertex)
    if (label < result.size())
      result[label] = 0;
  return result;
}

/// Which labels are of a single row of facets of a freeform face: at .4 of its border, it goes on
/// smoothly to facets that are not found, and not much larger.
inline std::vector<std::uint8_t> osculating_labels(const Face_search& search)
{
  using Index = Surface::Index;
  constexpr double most = 0.4, much_larger = 8;
  const Tessellation& mesh = search.mesh;
  const auto area_of_facet = [&](Index f) { return mesh.facet(mesh.facet_of(f)).area; };
  std::vector<std::uint8_t> result = single_rows(search);
  std::vector<double> smooth(result.size(), 0), all(result.size(), 0);
  for (Index f = 0; f < search.labels.size(); ++f)
    if (const Index label = search.labels[f]; search.is_found(f) && result[label])
      for_each_neighbor(search.surface, f, [&](Index g, Index v, Index w) {
        if (search.labels[g] == label)
          return;
        const double length = norm(search.surface.point(w) - search.surface.point(v));
        all[label] += length;
        if (search.may_be_curved(g) && mesh.is_smooth(f, g) &&
            area_of_facet(g) <= much_larger * area_of_facet(f))
          smooth[label] += length;
      });
  for (std::size_t label = 0; label < result.size(); ++label)
    result[label] = result[label] && smooth[label] > most * all[label];
  return result;
}

/// Drops curved surfaces that only osculate a freeform face, until none does.
inline void drop_osculating_surfaces(Face_search& search)
{
  for (bool some = true; some;) {
    const std::vector<std::uint8_t> dropped = osculating_labels(search);
    some = false;
    for (Surface::Index f = 0; f < search.labels.size(); ++f)
      if (search.is_found(f) && dropped[search.labels[f]]) {
        search.labels[f] = Face_search::none;
        search.is_freeform[search.mesh.facet_of(f)] = 1;
        some = true;
      }
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_DROP_OSCULATING_SURFACES_H
