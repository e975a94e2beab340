// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_SMALL_PLANES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_SMALL_PLANES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds plane faces of few vertices: those whose border is mostly not smooth, or meets faces that
/// are found.
inline void find_small_planes(Face_search& search, const Execution& execution)
{
  constexpr std::size_t few_points = 8;
  search.clear_tried();
  const std::vector<Surface::Index> seeds = search.seeds();
  Step_counter progress(execution, seeds.size());
  for (const Surface::Index seed : seeds) {
    progress.advance();
    if (search.is_found(seed) || search.is_tried[seed])
      continue;
    Fitted_surface<> s = surface_of_kind(Surface_kind::PLANE, search.surface.centroid(seed),
                                         search.surface.normal(seed));
    search.grower.grow(s, {seed}, [&](Surface::Index f) { return !search.is_found(f); });
    const std::vector<Surface::Index>& faces = search.grower.faces();
    if (share_of_smooth_border(search) < (search.grower.points().size() < few_points ? 0.1 : 0.5))
      search.add(s, faces);
    else
      for (const Surface::Index f : faces)
        search.is_tried[f] = 1;
  }
}

/// Two facets do not make a curved face: what is left of a component of at most two is planes.
inline void find_pairs_of_planes(Face_search& search, const Execution& execution)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  const auto label_left = [&](const auto& joins, const Execution& step) {
    return label_components(
      surface,
      [&](std::size_t a) {
        return !surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED) &&
               !search.is_found(surface.lower_face(a)) &&
               !search.is_found(surface.higher_face(a)) && joins(a);
      },
      step);
  };
  const Partition components = label_left(
    [&](std::size_t a) { return search.neighbors.may_be_smooth(a); }, execution.step(0, 0.5));
  const Partition facets = label_left(
    [&](std::size_t a) { return search.neighbors.is_coplanar(a); }, execution.step(0.5, 1));
  std::vector<Index> largest(facets.number_of_parts(), Face_search::none); // face of a facet
  for (const Index f : search.seeds())
    if (largest[facets[f]] == Face_search::none)
      largest[facets[f]] = f;
  std::vector<std::size_t> number(components.number_of_parts(), 0); // of facets
  for (const Index f : largest)
    if (f != Face_search::none)
      ++number[components[f]];
  for (const Index f : largest)
    if (f != Face_search::none && !search.is_found(f) && number[components[f]] <= 2) {
      Fitted_surface<> s = surface_of_kind(Surface_kind::PLANE, surface.centroid(f),
                                           surface.normal(f));
      search.grower.grow(s, {f}, [&](Index g) { return !search.is_found(g); });
      search.add(s, search.grower.faces());
    }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_SMALL_PLANES_H
