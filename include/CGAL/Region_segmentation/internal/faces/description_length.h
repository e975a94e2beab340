// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_DESCRIPTION_LENGTH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_DESCRIPTION_LENGTH_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segments/Fitted_surface.h>
#include <CGAL/Region_segmentation/internal/faces/labels_of_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The areas of faces on planes, on other surfaces, and of freeform ones.
struct Areas_of_kinds
{
  double plane = 0, curved = 0, freeform = 0;

  Areas_of_kinds(const Surface& surface, const Partition& faces,
                 const std::vector<Fitted_surface<>>& surfaces)
  {
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      const Surface_kind kind = surfaces[faces[f]].kind;
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
inline double share_of_opposite_sides(const Surface& surface, const Partition& faces,
                                      const std::vector<Fitted_surface<>>& surfaces)
{
  double opposite = 0, all = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    const Fitted_surface<>& s = surfaces[faces[f]];
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

/// How long a description of the surface by its faces is: 1/8 for each face, and the mean over
/// their vertices of the bits that tell where these are, up to `accuracy`: the logarithm of the
/// standard deviation of those of a face from its surface. Vertices of freeform faces count as if
/// they deviated by 1/250 of the size of the surface.
inline double description_length(const Surface& surface, const Partition& faces,
                                 const std::vector<Fitted_surface<>>& surfaces, double accuracy)
{
  constexpr double of_face = 0.125;
  const double freeform = 0.004 * surface.length_unit();
  struct Sum
  {
    double squares = 0, vertices = 0;
  };
  std::vector<Sum> sums(surfaces.size());
  for (const auto& [face, vertex] : labels_of_vertices(surface, faces)) {
    const Fitted_surface<>& s = surfaces[face];
    const double d = s.kind == Surface_kind::FREEFORM ? freeform
                                                      : Surface_distance(s)(surface.point(vertex));
    sums[face].squares += d * d;
    ++sums[face].vertices;
  }
  double bits = 0, vertices = 0;
  for (const Sum& s : sums) {
    bits += s.vertices * std::log2((std::max)(1.0, std::sqrt(s.squares / s.vertices) / accuracy));
    vertices += s.vertices;
  }
  return of_face * double(sums.size()) + bits / vertices;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_DESCRIPTION_LENGTH_H
