// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_TORI_TO_FREEFORM_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_TORI_TO_FREEFORM_H

#include <CGAL/Region_segmentation/internal/faces/merge_equal_surfaces.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether two tori osculate one tube along a curve: the tubes are equally thick, and the circles
/// along them nearly the same. Neighbors among faces that are drawn as tori differ more.
inline bool are_of_one_tube(const Fitted_surface& s, const Fitted_surface& t)
{
  constexpr double same_thickness = 0.03, nearly = 0.25;
  return s.kind == Surface_kind::TORUS && t.kind == Surface_kind::TORUS && s.side == t.side &&
         std::fabs(s.minor_radius - t.minor_radius) < same_thickness * s.minor_radius &&
         std::fabs(s.radius - t.radius) < nearly * s.radius &&
         norm(s.point - t.point) < nearly * s.radius &&
         std::fabs(dot(s.direction, t.direction)) > 1 - nearly * nearly;
}

/// A fillet or tube along a curve is freeform, but osculated by tori. Where one of them was found,
/// the freeform face beside it goes on with nearly the same curvature, and is the same face; so
/// does the next torus.
inline void join_tori_to_freeform(Face_search& search)
{
  using Index = Surface::Index;
  struct Border
  {
    Index torus, freeform;
    double length, gradual;
  };
  const Surface& surface = search.surface;
  std::vector<Border> borders;
  const auto add = [&](Index f, Index g, std::size_t a) {
    const Index i = search.labels[f], j = search.labels[g];
    if (search.surfaces[i].kind == Surface_kind::TORUS &&
        search.surfaces[j].kind == Surface_kind::FREEFORM)
      borders.push_back({i, j, surface.length(a),
                         departs_gradually(surface, search.test, search.surfaces[i], f, g)
                           ? surface.length(a)
                           : 0});
  };
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (!surface.has_flag(a, Surface::LINK)) {
      add(surface.lower_face(a), surface.higher_face(a), a);
      add(surface.higher_face(a), surface.lower_face(a), a);
    }
  const auto key = [](const Border& b) { return std::tie(b.torus, b.freeform); };
  std::stable_sort(borders.begin(), borders.end(),
                   [&](const Border& a, const Border& b) { return key(a) < key(b); });

  std::vector<double> areas(search.surfaces.size(), 0);
  for (Index f = 0; f < search.labels.size(); ++f)
    areas[search.labels[f]] += surface.area(f);
  Lowest_root_forest joined(search.surfaces.size());
  std::vector<bool> is_freeform(search.surfaces.size(), false);
  for (const auto& pair : smooth_neighbors(search))
    if (are_of_one_tube(search.surfaces[pair.first], search.surfaces[pair.second])) {
      joined.unite(pair.first, pair.second);
      is_freeform[pair.first] = is_freeform[pair.second] = true;
    }
  for (std::size_t first = 0, last; first < borders.size(); first = last) {
    const Index torus = borders[first].torus, freeform = borders[first].freeform;
    double length = 0, gradual = 0;
    for (last = first; last < borders.size() && key(borders[last]) == key(borders[first]); ++last) {
      length += borders[last].length;
      gradual += borders[last].gradual;
    }
    if (gradual > 0.7 * length && (is_freeform[torus] || areas[freeform] > 0.3 * areas[torus])) {
      joined.unite(torus, freeform);
      is_freeform[torus] = true;
    }
  }
  std::vector<Index> now = search.unchanged_labels();
  for (Index i = 0; i < now.size(); ++i) {
    now[i] = joined.root(i);
    if (is_freeform[i])
      search.surfaces[now[i]] = Fitted_surface();
  }
  search.relabel(now);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_TORI_TO_FREEFORM_H
