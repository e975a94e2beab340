// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_MERGE_EQUAL_SURFACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_MERGE_EQUAL_SURFACES_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_faces_from_patches.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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
  std::vector<std::pair<Surface::Index, Surface::Index>> pairs;
  for_each_border(
    search.surface, search.labels, [&](std::size_t a, Surface::Index i, Surface::Index j) {
      if (i != Face_search::none && j != Face_search::none && search.neighbors.is_smooth(a))
        pairs.push_back({(std::min)(i, j), (std::max)(i, j)});
    });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Merges neighbors of which one's surface is also that of the other. The faces of the smaller one
/// are tested first, and tests end at the first that fails.
inline void merge_equal_surfaces(Face_search& search)
{
  using Index = Surface::Index;
  constexpr double tolerance_of_tori = 30; // those that are nearly equal osculate one fillet along
                                           // a line that is nearly an arc
  const Face_test test_of_tori(search.surface, search.neighbors,
                               tolerance_of_tori * search.test.tolerance());
  std::vector<std::vector<Index>> faces(search.surfaces.size());
  for (Index f = 0; f < search.labels.size(); ++f)
    if (search.is_found(f))
      faces[search.labels[f]].push_back(f);
  std::vector<Index> now(search.surfaces.size()); // the labels that labels become
  std::iota(now.begin(), now.end(), Index(0));
  const auto current = [&](Index i) { return root_in_forest(now, i); };
  for (const auto& pair : smooth_neighbors(search)) {
    Index i = current(pair.first), j = current(pair.second);
    const Surface_kind kinds[] = {search.surfaces[i].kind, search.surfaces[j].kind};
    if (i == j)
      continue;
    if (degrees_of_freedom(kinds[1]) < degrees_of_freedom(kinds[0]))
      std::swap(i, j);
    const bool are_tori = kinds[0] == Surface_kind::TORUS && kinds[1] == Surface_kind::TORUS;
    const Face_test& test = are_tori ? test_of_tori : search.test;
    const auto has_all = [&](Index of, Index others) {
      return std::all_of(faces[others].begin(), faces[others].end(), [&](Index f) {
        return test(search.surfaces[of], f) && !search.is_flat(of, f);
      });
    };
    if (!has_all(i, j)) {
      std::swap(i, j);
      if (!has_all(i, j))
        continue;
    }
    now[j] = i;
    if (faces[i].size() < faces[j].size())
      faces[i].swap(faces[j]);
    faces[i].insert(faces[i].end(), faces[j].begin(), faces[j].end());
    faces[j].clear();
  }
  for (Index& label : search.labels)
    if (label != Face_search::none)
      label = current(label);
}

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
    if (share_of_smooth_border(search) < (search.grower.points().size() < few_points ? 0.1 : 0.5)) {
      search.add(s, faces);
      find_whole_beside(search, std::vector<Surface::Index>(faces));
    } else
      for (const Surface::Index f : faces)
        search.is_tried[f] = 1;
  }
}

/// Two facets do not make a curved face: what is left of a component of at most two is planes.
inline void find_pairs_of_planes(Face_search& search, const Execution& execution)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  const Partition components = smooth_components_left(search, execution);
  std::vector<Index> largest; // of each facet, the face that is left
  std::vector<std::uint8_t> is_counted(surface.number_of_faces(), 0); // by facet
  for (const Index f : search.seeds())
    if (!std::exchange(is_counted[search.neighbors.facet(f)], std::uint8_t(1)))
      largest.push_back(f);
  std::vector<std::size_t> number(components.number_of_parts(), 0); // of facets
  for (const Index f : largest)
    ++number[components[f]];
  for (const Index f : largest)
    if (!search.is_found(f) && number[components[f]] <= 2) {
      Fitted_surface<> s = surface_of_kind(Surface_kind::PLANE, surface.centroid(f),
                                           surface.normal(f));
      search.grower.grow(s, {f}, [&](Index g) { return !search.is_found(g); });
      search.add(s, search.grower.faces());
    }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_MERGE_EQUAL_SURFACES_H
