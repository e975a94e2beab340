// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/coordinate_resolution.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_face_roles.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_faces_from_patches.h>
#include <CGAL/Region_segmentation/Part_faces/internal/merge_equal_surfaces.h>
#include <CGAL/Region_segmentation/Part_faces/internal/surface_evidence.h>
#include <CGAL/Region_segmentation/Support/Execution.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The faces of a surface as it is, without deviations and extents. `tolerance`: in units of the
/// surface
inline Surface_faces find_faces_within(const Surface& surface, double tolerance, double resolution,
                                       const Execution& execution)
{
  Face_search search(surface, tolerance, resolution);
  find_faces_from_patches(search, execution.step(0, 0.7));
  join_remaining_faces(search);
  find_small_planes(search, execution.step(0.7, 0.85));
  find_pairs_of_planes(search, execution.step(0.85, 0.9));
  while (search.is_exact && drop_uncertain_surfaces(search)) {
  }
  compete_at_borders(search);
  merge_equal_surfaces(search);
  separate_components(search, execution.step(0.9, 1));

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

/// Faces of a surface, and how long its description by them is.
struct Described_faces
{
  Surface_faces faces;
  double length = std::numeric_limits<double>::infinity();
};

/// Those for that tolerance above rounding with which their description is shortest. `of_exact`:
/// the length of that for rounding
inline Described_faces find_inexact_faces(const Surface& surface, double rounding, double of_exact,
                                          const Execution& execution)
{
  constexpr int tolerances = 7;
  constexpr double largest = 6400, // times rounding
    too_long = 1.8;
  Described_faces best;
  for (int i = 0; i < tolerances; ++i) {
    Surface_faces faces = find_faces_within(
      surface, std::ldexp(largest * rounding, -i), 0,
      execution.step(double(i) / tolerances, double(i + 1) / tolerances));
    const double length = description_length(surface, faces, rounding);
    // Where vertices are not noisy, or below the noise, most patches fail, which takes time.
    const bool is_in_vain = Areas_of_kinds(surface, faces).share_of_freeform() > 0.5 ||
                            length > too_long * (std::min)(best.length, of_exact);
    if (length <= best.length)
      best = {std::move(faces), length};
    if (is_in_vain)
      break;
  }
  return best;
}

/// Whether vertices deviate from `inexact` faces by chance, rather than that a freeform part is
/// covered by them: the description is shorter, and either about half of the edges have ends on
/// opposite sides, or, as where vertices were moved along facets, some do, and there are hardly
/// more faces.
inline bool is_noise(const Surface& surface, const Described_faces& exact,
                     const Described_faces& inexact)
{
  constexpr double half = 0.45, some = 0.1, hardly_more = 1.6;
  const double opposite = share_of_opposite_sides(surface, inexact.faces);
  return inexact.length < exact.length &&
         (opposite >= half ||
          (opposite >= some && double(inexact.faces.surfaces.size()) <=
                                 hardly_more * double(exact.faces.surfaces.size())));
}

/// The faces of a surface as it is. `tolerance`: in units of the surface; 0: that which its
/// vertices ask for.
inline Surface_faces find_faces(const Surface& surface, double tolerance,
                                const Execution& execution)
{
  constexpr double little = 0.05;
  const double resolution = coordinate_resolution(surface), rounding = 1e-6 * surface.length_unit(),
               exact = (std::max)(rounding, resolution);
  if (tolerance > 0)
    return find_faces_within(surface, tolerance, resolution, execution);
  Described_faces found{find_faces_within(surface, exact, resolution, execution.step(0, 0.4))};
  found.length = description_length(surface, found.faces, rounding);
  const bool is_freeform = Areas_of_kinds(surface, found.faces).share_of_curved() <= little;
  if (is_freeform || resolution > 10 * rounding) { // or facets may be as small as steps
    Described_faces inexact = find_inexact_faces(surface, rounding, found.length,
                                                 execution.step(0.4, 1));
    const bool are_few = 2 * inexact.faces.surfaces.size() < found.faces.surfaces.size();
    if (is_noise(surface, found, inexact) && (is_freeform || are_few))
      found = std::move(inexact);
  }
  execution.report(1);
  return std::move(found.faces);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H
