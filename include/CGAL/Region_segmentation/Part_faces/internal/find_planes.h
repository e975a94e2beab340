// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_PLANES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_PLANES_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_grower.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The angle between neighboring facets of a freeform face is below 20 degrees.
inline constexpr double most_angle_of_freeform = 0.35;

/// The facets that are not found and go on smoothly from one of them, over those that `is_left`.
template <typename IsLeft>
std::vector<Surface::Index> smooth_facets_around(const Face_search& search, Surface::Index facet,
                                                 std::vector<std::uint8_t>& is_reached,
                                                 const IsLeft& is_left)
{
  using Index = Surface::Index;
  const Tessellation& mesh = search.mesh;
  std::vector<Index> result{facet};
  is_reached[facet] = 1;
  for (std::size_t next = 0; next < result.size(); ++next)
    for (const Index f : mesh.faces_of_facet(result[next]))
      if (is_left(f))
        for_each_neighbor(search.surface, f, [&](Index g, Index, Index) {
          const Index other = mesh.facet_of(g);
          if (is_left(g) && !is_reached[other] &&
              mesh.surely_meet_within(most_angle_of_freeform, f, g)) {
            is_reached[other] = 1;
            result.push_back(other);
          }
        });
  return result;
}

/// Which facets are planes of the part, of those that no curved face has: those of four and more
/// vertices that do not go on to others. Of the rest, what goes on smoothly is freeform, unless it
/// is of few facets.
inline std::vector<std::uint8_t> find_planes(const Face_search& search)
{
  using Index = Surface::Index;
  constexpr std::size_t fewest_vertices = 4, few_facets = 2;
  const Tessellation& mesh = search.mesh;
  std::vector<std::uint8_t> result(mesh.number_of_facets());
  for (Index i = 0; i < result.size(); ++i)
    result[i] = !search.is_freeform[i] && mesh.facet(i).number_of_vertices >= fewest_vertices &&
                search.stands_alone(i, most_angle_of_freeform);
  const std::vector<std::uint8_t> alone = result;
  const auto is_left = [&](Index f) { return !search.is_found(f) && !alone[mesh.facet_of(f)]; };
  std::vector<std::uint8_t> is_reached(result.size(), 0);
  for (Index i = 0; i < result.size(); ++i) {
    if (is_reached[i] || alone[i])
      continue;
    const std::vector<Index> facets = smooth_facets_around(search, i, is_reached, is_left);
    const bool is_freeform = std::any_of(facets.begin(), facets.end(),
                                         [&](Index j) { return search.is_freeform[j] != 0; });
    if (facets.size() <= few_facets && !is_freeform)
      for (const Index j : facets)
        result[j] = 1;
  }
  return result;
}

/// Adds the facets that no curved face has and that are planes of the part.
inline void add_planes(Face_search& search)
{
  const std::vector<std::uint8_t> is_plane = find_planes(search);
  std::vector<Surface::Index> faces;
  for (std::size_t i = 0; i < is_plane.size(); ++i) {
    faces.clear();
    bool has_normal = false; // slivers alone are no plane
    if (is_plane[i])
      for (const Surface::Index f : search.mesh.faces_of_facet(i))
        if (!search.is_found(f)) {
          faces.push_back(f);
          has_normal = has_normal || search.mesh.has_normal(f);
        }
    if (has_normal)
      search.add(search.mesh.facet(i).plane, faces);
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_PLANES_H
