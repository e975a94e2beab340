// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_FACES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Segments/Surface_faces.h>
#include <CGAL/Region_segmentation/internal/faces/compete_at_borders.h>
#include <CGAL/Region_segmentation/internal/faces/description_length.h>
#include <CGAL/Region_segmentation/internal/faces/find_face_roles.h>
#include <CGAL/Region_segmentation/internal/faces/find_faces_from_patches.h>
#include <CGAL/Region_segmentation/internal/faces/find_small_planes.h>
#include <CGAL/Region_segmentation/internal/faces/join_by_curvature.h>
#include <CGAL/Region_segmentation/internal/faces/join_crossing_faces.h>
#include <CGAL/Region_segmentation/internal/faces/merge_equal_surfaces.h>
#include <CGAL/Region_segmentation/internal/faces/separate_components.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The faces of a surface as it is, without deviations and extents. `tolerance`: in units of the
/// surface
inline Surface_faces find_faces_within(const Surface& surface, double tolerance,
                                       const Execution& execution)
{
  Face_search search(surface, tolerance);
  find_faces_from_patches(search, execution.step(0, 0.7));
  if (!search.is_exact())
    join_crossing_faces(search);
  find_small_planes(search, execution.step(0.7, 0.85));
  find_pairs_of_planes(search, execution.step(0.85, 0.9));
  merge_equal_surfaces(search);
  compete_at_borders(search);
  separate_components(search, execution.step(0.9, 1));
  join_by_curvature(search);

  Surface_faces result;
  result.partition = Partition::from_labels(search.labels);
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    if (result.partition[f] == result.surfaces.size()) // parts are numbered by their first faces
      result.surfaces.push_back(search.surface_of(f));
  result.roles = find_face_roles(surface, result.partition, result.surfaces);
  result.tolerance = search.test.tolerance();
  return result;
}

/// The areas of faces on planes, on other surfaces, and of freeform ones.
struct Areas_of_kinds
{
  double plane = 0, curved = 0, freeform = 0;

  Areas_of_kinds(const Surface& surface, const Surface_faces& faces)
  {
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      const Surface_kind kind = faces.surfaces[faces.partition[f]].kind;
      (kind == Surface_kind::PLANE      ? plane
       : kind == Surface_kind::FREEFORM ? freeform
                                        : curved) += surface.area(f);
    }
  }

  /// Of what is not plane; 1 if there is nothing else.
  double share_of_curved() const { return freeform > 0 ? curved / (curved + freeform) : 1; }
  double share_of_freeform() const { return freeform / (plane + curved + freeform); }
};

/// The share of the edges of faces on curved surfaces of which the ends are on opposite sides of
/// the surface, 1 if there is none: about half of them where vertices deviate by chance, few where
/// the mesh is of another smooth surface.
inline double share_of_opposite_sides(const Surface& surface, const Surface_faces& faces)
{
  double opposite = 0, all = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    const Fitted_surface<>& s = faces.surfaces[faces.partition[f]];
    if (s.kind == Surface_kind::PLANE || s.kind == Surface_kind::FREEFORM)
      continue;
    const Surface_distance distance(s);
    const std::size_t n = surface.number_of_corners(f);
    for (std::size_t i = 0; i < n; ++i)
      opposite += distance(surface.point(surface.corner(f, i))) *
                    distance(surface.point(surface.corner(f, (i + 1) % n))) <
                  0;
    all += double(n);
  }
  return all > 0 ? opposite / all : 1;
}

/// The faces of a surface as it is, for that tolerance above rounding with which their description
/// is shortest.
inline Surface_faces find_inexact_faces(const Surface& surface, double rounding,
                                        const Execution& execution)
{
  constexpr int tolerances = 7;
  constexpr double largest = 6400, // times rounding
    too_long = 2;
  Surface_faces best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < tolerances; ++i) {
    Surface_faces faces = find_faces_within(
      surface, std::ldexp(largest * rounding, -i),
      execution.step(double(i) / tolerances, double(i + 1) / tolerances));
    const double length = description_length(surface, faces, rounding);
    // Below the noise most patches fail, which takes time.
    const Areas_of_kinds areas(surface, faces);
    const bool is_below_noise = areas.share_of_freeform() > 0.5 || length > too_long * least;
    if (length <= least) {
      least = length;
      best = std::move(faces);
    }
    if (is_below_noise)
      break;
  }
  return best;
}

/// Whether vertices deviate from `inexact` faces by chance, rather than that a freeform part is
/// covered by them: the description is shorter, and either about half of the edges have ends on
/// opposite sides, or, as where vertices were moved along facets, some do, and there are hardly
/// more faces.
inline bool is_noise(const Surface& surface, const Surface_faces& exact,
                     const Surface_faces& inexact, double rounding)
{
  constexpr double half = 0.45, some = 0.1, hardly_more = 1.3;
  const auto bits = [&](const Surface_faces& faces) {
    return description_length(surface, faces, rounding);
  };
  const double opposite = share_of_opposite_sides(surface, inexact);
  return bits(inexact) < bits(exact) &&
         (opposite >= half || (opposite >= some && double(inexact.surfaces.size()) <=
                                                     hardly_more * double(exact.surfaces.size())));
}

/// The faces of a surface as it is. `tolerance`: in units of the surface; 0: that which its
/// vertices ask for.
inline Surface_faces find_faces(const Surface& surface, double tolerance,
                                const Execution& execution)
{
  if (tolerance > 0)
    return find_faces_within(surface, tolerance, execution);
  constexpr double much = 0.5, more = 0.1, little = 0.05;
  const double rounding = 1e-6 * surface.length_unit();
  const auto curved = [&](const Surface_faces& found) {
    return Areas_of_kinds(surface, found).share_of_curved();
  };
  Surface_faces faces = find_faces_within(surface, rounding, execution.step(0, 0.2));
  const double curved_exactly = curved(faces);
  if (curved_exactly < much) {
    Surface_faces rounded = find_faces_within(surface, 10 * rounding, execution.step(0.2, 0.4));
    if (curved(rounded) > curved_exactly + more)
      faces = std::move(rounded);
    else if (curved_exactly <= little) {
      Surface_faces inexact = find_inexact_faces(surface, rounding, execution.step(0.4, 1));
      if (is_noise(surface, faces, inexact, rounding))
        faces = std::move(inexact);
    }
  }
  execution.report(1);
  return faces;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_FACES_H
