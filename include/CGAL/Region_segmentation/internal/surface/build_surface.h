// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_BUILD_SURFACE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_BUILD_SURFACE_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/support/compiled.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>
#include <CGAL/Region_segmentation/internal/surface/collect_adjacencies.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>
#include <CGAL/Region_segmentation/internal/surface/find_crumbs.h>
#include <CGAL/Region_segmentation/internal/surface/find_doubled_faces.h>
#include <CGAL/Region_segmentation/internal/surface/find_links.h>
#include <CGAL/Region_segmentation/internal/surface/match_sides.h>
#include <CGAL/Region_segmentation/internal/surface/merge_points.h>
#include <CGAL/Region_segmentation/internal/surface/orient_components.h>
#include <CGAL/Region_segmentation/internal/surface/orient_faces.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What is adjacent beyond the neighbors that are known.
enum class Adjacency_of { NEIGHBORS, COINCIDING_SIDES, COMPONENTS };

/// A seam as an adjacency: with the sign of its angle if its faces are oriented consistently; an
/// edge if one of them is degenerate.
inline Added_adjacency adjacency_of_seam(const Surface& surface, const Seam& seam)
{
  const auto side_of = [&](Surface::Index face) {
    return side_between(surface, face, seam.lower_vertex, seam.higher_vertex);
  };
  const Surface::Index lower = (std::min)(seam.face, seam.other_face),
                       higher = (std::max)(seam.face, seam.other_face);
  const Double_3 direction = surface.point(seam.higher_vertex) - surface.point(seam.lower_vertex);
  Added_adjacency result = {lower,
                            higher,
                            seam.share * seam.share * squared_norm(direction),
                            0,
                            side_of(seam.face),
                            side_of(seam.other_face)};
  if (surface.is_degenerate(lower) || surface.is_degenerate(higher))
    return result;
  result.flags = Surface::SEAM;
  const bool is_forward = runs_along(surface, higher, seam.lower_vertex, seam.higher_vertex);
  if (is_forward != runs_along(surface, lower, seam.lower_vertex, seam.higher_vertex))
    result.flags |= sign_of_edge(surface.normal(higher), surface.normal(lower),
                                 (is_forward ? 1.0 : -1.0) * direction);
  return result;
}

/// Adds links between what is not connected by edges and seams, and marks crumbs.
inline void insert_links(Surface& surface, const Execution& execution)
{
  const Partition connected = label_components(
    surface, [](std::size_t) { return true; }, execution.silent());
  insert_adjacencies(surface, find_links(surface, connected, execution));
  mark_crumbs(surface, edge_components(surface, execution.silent()));
}

/// From points and corners to a surface.
/// \tparam wanted what is adjacent; what others need is not compiled
template <Adjacency_of wanted>
Surface build_surface(Raw_surface&& raw, const Execution& execution)
{
  std::vector<Added_adjacency> added;
  std::vector<Seam> seams;
  const bool has_open_sides = std::find(raw.neighbors.begin(), raw.neighbors.end(),
                                        Raw_surface::none) != raw.neighbors.end();
  if constexpr (wanted != Adjacency_of::NEIGHBORS)
    if (has_open_sides)
      merge_points_of_open_sides(raw);
  compute_normals(raw.surface, execution.step(0, 0.3));
  if constexpr (wanted != Adjacency_of::NEIGHBORS)
    if (has_open_sides) {
      find_doubled_faces(raw, added);
      Side_matcher matcher(raw);
      matcher.match();
      seams = matcher.seams();
      orient_faces(raw, matcher.parallel_sides(), seams);
    }
  std::vector<Surface::Index> faces_at_borders; // as long as neighbors are known
  if (has_open_sides)
    faces_at_borders = faces_with_open_sides(raw);
  collect_adjacencies(raw, execution.step(0.3, 0.8));
  raw.neighbors = Large_array<Surface::Index>(); // later steps need the memory
  const Partition component_of = edge_components(raw.surface, execution.step(0.8, 0.9));
  orient_components(raw, component_of, faces_at_borders, seams);
  for (const Seam& seam : seams)
    added.push_back(adjacency_of_seam(raw.surface, seam));
  insert_adjacencies(raw.surface, added);
  join_degenerate_faces(raw.surface);
  if constexpr (wanted == Adjacency_of::COMPONENTS)
    if (component_of.number_of_parts() > 1)
      insert_links(raw.surface, execution.step(0.9, 1));
  sum_up(raw.surface);
  return std::move(raw.surface);
}

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template Surface
build_surface<Adjacency_of::NEIGHBORS>(Raw_surface&&, const Execution&);
CGAL_REGION_SEGMENTATION_EXTERN template Surface
build_surface<Adjacency_of::COINCIDING_SIDES>(Raw_surface&&, const Execution&);
CGAL_REGION_SEGMENTATION_EXTERN template Surface
build_surface<Adjacency_of::COMPONENTS>(Raw_surface&&, const Execution&);
#endif

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_BUILD_SURFACE_H
