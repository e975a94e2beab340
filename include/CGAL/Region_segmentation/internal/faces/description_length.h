// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_DESCRIPTION_LENGTH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_DESCRIPTION_LENGTH_H

#include <CGAL/Region_segmentation/Segments/Surface_faces.h>
#include <CGAL/Region_segmentation/internal/faces/labels_of_vertices.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// How long a description of the surface by its faces is: 1/8 for each face, and the mean over
/// their vertices of the bits that tell where these are, up to `accuracy`: the logarithm of the
/// standard deviation of those of a face from its surface. Vertices of freeform faces count as if
/// they deviated by 1/250 of the size of the surface.
inline double description_length(const Surface& surface, const Surface_faces& faces,
                                 double accuracy)
{
  constexpr double of_face = 0.125;
  const double freeform = 0.004 * surface.length_unit();
  struct Sum
  {
    double squares = 0, vertices = 0;
  };
  std::vector<Sum> sums(faces.surfaces.size());
  const std::vector<Surface_distance> distances(faces.surfaces.begin(), faces.surfaces.end());
  for (const auto& [face, vertex] : labels_of_vertices(surface, faces.partition)) {
    const Fitted_surface<>& s = faces.surfaces[face];
    const double d = s.kind == Surface_kind::FREEFORM ? freeform
                                                      : distances[face](surface.point(vertex));
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
