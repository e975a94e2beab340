// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_DROP_OSCULATING_SURFACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_DROP_OSCULATING_SURFACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>
#include <CGAL/Region_segmentation/Part_faces/internal/surface_evidence.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// By label: whether it is of a curved surface.
inline std::vector<std::uint8_t> curved_labels(const Face_search& search)
{
  std::vector<std::uint8_t> result;
  for (const Fitted_surface<>& s : search.surfaces)
    result.push_back(s.kind != Surface_kind::PLANE);
  return result;
}

/// By label: whether it is of a curved surface, and no vertex is inside its face.
inline std::vector<std::uint8_t> single_rows(const Face_search& search)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  std::vector<Index> last(surface.number_of_vertices(), Face_search::none); // label of a face
  std::vector<std::uint8_t> is_border(surface.number_of_vertices(), 0);
  std::vector<std::uint8_t> is_used(surface.number_of_vertices(), 0);
  for (Index f = 0; f < search.labels.size(); ++f)
    for (const Index v : surface.corners(f)) {
      is_border[v] |= is_used[v] && last[v] != search.labels[f];
      is_used[v] = 1;
      last[v] = search.labels[f];
    }
  std::vector<std::uint8_t> result = curved_labels(search);
  for (Index v = 0; v < last.size(); ++v)
    if (!is_border[v] && last[v] != Face_search::none)
      result[last[v]] = 0;
  return result;
}

/// The curvature of a surface of revolution at a point of it, along a direction of length 1 that is
/// tangent to it there; positive where it bends away from the normal of the faces.
inline double curvature_along(const Fitted_surface<>& s, const Double_3& p,
                              const Double_3& direction)
{
  const Meridian_point m = meridian_point(s, p);
  const Profile f = Surface_distance(s).profile(m.r, m.z);
  const double of_parallel = m.r > 0 ? f.by_r / m.r : 0,
               of_meridian = s.kind == Surface_kind::SPHERE  ? 1 / s.radius
                             : s.kind == Surface_kind::TORUS ? 1 / s.minor_radius
                                                             : 0;
  const double c = dot(direction, cross(s.direction, m.outward));
  return s.side * (c * c * of_parallel + (1 - c * c) * of_meridian);
}

/// Whether two curved surfaces have nearly the same curvature across the side from vertex v to w,
/// as two that osculate one freeform face have.
inline bool have_equal_curvature(const Surface& surface, const Fitted_surface<>& s,
                                 const Fitted_surface<>& t, Surface::Index v, Surface::Index w)
{
  constexpr double most = 0.3; // relative difference
  const Double_3 p = surface.point(v), side = surface.point(w) - p, middle = p + 0.5 * side,
                 across = cross(surface_normal(s, middle), side);
  const double length = norm(across);
  if (!(length > 0))
    return true;
  const double a = curvature_along(s, middle, (1 / length) * across),
               b = curvature_along(t, middle, (1 / length) * across);
  return std::fabs(a - b) <= most * (std::max)(std::fabs(a), std::fabs(b));
}

/// Which labels of `among` only osculate a freeform face, as .4 of their border tells: it goes on
/// smoothly to others of `among` of nearly the same curvature; or to facets that are not found and
/// not much larger, which leave the surface little by little, or are beside a single row of facets.
/// `rows`: the single rows
inline std::vector<std::uint8_t> osculating_labels(const Face_search& search,
                                                   const std::vector<std::uint8_t>& rows,
                                                   const std::vector<std::uint8_t>& among)
{
  using Index = Surface::Index;
  constexpr double most = 0.4, much_larger = 8;
  const Tessellation& mesh = search.mesh;
  const auto goes_on = [&](Index f, Index g, Index v, Index w) {
    const Index label = search.labels[f];
    const Fitted_surface<>& s = search.surfaces[label];
    if (!mesh.is_smooth(f, g))
      return false;
    if (search.is_found(g))
      return among[search.labels[g]] &&
             have_equal_curvature(search.surface, s, search.surfaces[search.labels[g]], v, w);
    return !search.is_sure_plane(g) &&
           mesh.facet(mesh.facet_of(g)).area <= much_larger * mesh.facet(mesh.facet_of(f)).area &&
           (rows[label] || departs_gradually(mesh, s, g, v, w));
  };
  std::vector<double> share(among.size(), 0), all(among.size(), 0);
  for (Index f = 0; f < search.labels.size(); ++f)
    if (const Index label = search.labels[f]; search.is_found(f) && among[label])
      for_each_neighbor(search.surface, f, [&](Index g, Index v, Index w) {
        if (search.labels[g] == label)
          return;
        const double length = norm(search.surface.point(w) - search.surface.point(v));
        all[label] += length;
        share[label] += goes_on(f, g, v, w) ? length : 0;
      });
  std::vector<std::uint8_t> result(among.size());
  for (std::size_t label = 0; label < result.size(); ++label)
    result[label] = among[label] && share[label] > most * all[label];
  return result;
}

/// Drops curved surfaces that only osculate a freeform face, between others that do.
inline void drop_osculating_surfaces(Face_search& search)
{
  for (bool some = true; some;) {
    const std::vector<std::uint8_t> rows = single_rows(search),
                                    dropped = osculating_labels(
                                      search, rows,
                                      osculating_labels(search, rows, curved_labels(search)));
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
