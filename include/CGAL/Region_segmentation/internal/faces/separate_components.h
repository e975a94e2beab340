// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SEPARATE_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SEPARATE_COMPONENTS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether an edge between faces that fit no surface is a crease: its deviation stands out among
/// those of the edges near it.
inline bool is_crease(const Face_search& search, std::size_t adjacency)
{
  constexpr double largest_smooth = 0.5; // radians
  const Surface& surface = search.surface;
  if (!search.neighbors.may_be_smooth(adjacency))
    return true;
  const double deviation = surface.deviation(adjacency);
  if (deviation < largest_smooth)
    return false;
  double largest = 0;
  for (const Surface::Index f : {surface.lower_face(adjacency), surface.higher_face(adjacency)})
    for (const Face_neighbors::Neighbor& n : search.neighbors[f])
      if (n.adjacency != adjacency && search.neighbors.may_be_smooth(n.adjacency))
        largest = (std::max)(largest, surface.deviation(n.adjacency));
  return deviation > 2.5 * largest;
}

/// Joins each of some labels to the neighbor with the longest border.
inline void join_to_neighbors(Face_search& search, const std::vector<std::uint8_t>& is_joined)
{
  struct Border
  {
    Surface::Index label, neighbor;
    double length;
  };
  const Surface& surface = search.surface;
  std::vector<Border> borders;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Surface::Index i = search.labels[surface.lower_face(a)],
                         j = search.labels[surface.higher_face(a)];
    if (i == j || surface.has_flag(a, Surface::LINK))
      continue;
    if (is_joined[i])
      borders.push_back({i, j, surface.length(a)});
    if (is_joined[j])
      borders.push_back({j, i, surface.length(a)});
  }
  const auto key = [](const Border& b) { return std::tie(b.label, b.neighbor); };
  std::stable_sort(borders.begin(), borders.end(),
                   [&](const Border& a, const Border& b) { return key(a) < key(b); });
  std::vector<Surface::Index> now = search.unchanged_labels();
  const auto current = [&](Surface::Index i) {
    while (now[i] != i)
      i = now[i] = now[now[i]];
    return i;
  };
  for (std::size_t first = 0, last; first < borders.size(); first = last) {
    Border longest = borders[first];
    longest.length = -1;
    for (last = first; last < borders.size() && borders[last].label == longest.label;) {
      Border border = borders[last++];
      for (; last < borders.size() && key(borders[last]) == key(border); ++last)
        border.length += borders[last].length;
      if (border.length > longest.length)
        longest = border;
    }
    if (current(longest.neighbor) != current(longest.label))
      now[current(longest.label)] = current(longest.neighbor);
  }
  search.relabel(now);
}

/// Makes each connected component of a label a face of its own, and those of what was not found
/// freeform faces, which end at creases. Tiny components join a neighbor, but for the largest one
/// of a surface.
inline void separate_components(Face_search& search, const Execution& execution)
{
  constexpr double tiny = 1e-6; // of the area of the surface
  const Surface& surface = search.surface;
  const Partition components = label_components(
    surface,
    [&](std::size_t a) {
      const Surface::Index label = search.labels[surface.lower_face(a)];
      return label == search.labels[surface.higher_face(a)] &&
             !surface.has_flag(a, Surface::LINK) &&
             (label != Face_search::none || !is_crease(search, a));
    },
    execution);
  const std::size_t number = components.number_of_parts();
  std::vector<double> areas(number, 0);
  std::vector<Surface::Index> label_of(number);
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    areas[components[f]] += surface.area(f);
    label_of[components[f]] = search.labels[f];
  }
  std::vector<double> largest(search.surfaces.size(), 0); // by label
  for (std::size_t c = 0; c < number; ++c)
    if (label_of[c] != Face_search::none)
      largest[label_of[c]] = (std::max)(largest[label_of[c]], areas[c]);
  std::vector<Fitted_surface> surfaces(number);
  std::vector<std::uint8_t> is_joined(number);
  for (std::size_t c = 0; c < number; ++c) {
    const bool is_surface = label_of[c] != Face_search::none;
    surfaces[c] = is_surface ? search.surfaces[label_of[c]] : Fitted_surface();
    is_joined[c] = areas[c] < tiny * surface.area() &&
                   !(is_surface && areas[c] == largest[label_of[c]]);
  }
  search.labels.assign(components.begin(), components.end());
  search.surfaces = std::move(surfaces);
  join_to_neighbors(search, is_joined);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SEPARATE_COMPONENTS_H
