// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_SURFACE_EVIDENCE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_SURFACE_EVIDENCE_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/part_faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/part_faces/fit_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The pairs of labels and vertices of their faces, each once, in order.
template <typename Labels>
std::vector<std::pair<Surface::Index, Surface::Index>> labels_of_vertices(const Surface& surface,
                                                                          const Labels& labels)
{
  std::vector<std::pair<Surface::Index, Surface::Index>> pairs;
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
      pairs.push_back({Surface::Index(labels[f]), surface.corner(f, i)});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

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

/// The number of different angles that points have around the circle in the tube of a torus, up to
/// 1/1000 of their range.
inline int number_of_parallels(const Fitted_surface<>& torus, const std::vector<Double_3>& points)
{
  std::vector<double> angles;
  for (const Double_3& p : points) {
    const Meridian_point m = meridian_point(torus, p);
    angles.push_back(std::atan2(m.z, m.r - torus.radius));
  }
  std::sort(angles.begin(), angles.end());
  const double same = 1e-3 * (angles.back() - angles.front());
  int number = 1;
  for (std::size_t i = 1; i < angles.size(); ++i)
    number += angles[i] - angles[i - 1] > same;
  return number;
}

/// How much a surface says of its faces: few vertices lie on one by chance where the part is
/// freeform.
enum class Evidence : std::uint8_t { NONE, WEAK, STRONG };

/// The vertices of each label of a surface.
struct Label_vertices
{
  int number = 0, inside = 0;   ///< inside: all faces around it have the label
  std::vector<Double_3> points; ///< of tori
};

inline std::vector<Label_vertices> vertices_of_labels(const Face_search& search)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  const std::vector<std::pair<Index, Index>> pairs = labels_of_vertices(surface, search.labels);
  std::vector<Index> number_of_labels(surface.number_of_vertices(), 0);
  for (const auto& pair : pairs)
    ++number_of_labels[pair.second];
  std::vector<Label_vertices> result(search.surfaces.size());
  for (const auto& [label, vertex] : pairs) {
    ++result[label].number;
    result[label].inside += number_of_labels[vertex] == 1;
    if (search.surfaces[label].kind == Surface_kind::TORUS)
      result[label].points.push_back(surface.point(vertex));
  }
  return result;
}

/// By label, of the vertices alone. Places of freeform faces lie on surfaces by chance: three
/// vertices on a plane, those of two circles on a cone, sphere or torus, and of three of its
/// parallels on a torus. With fewer than 4 vertices for each degree of freedom, they may.
inline std::vector<Evidence> evidence_of_vertices(const Face_search& search,
                                                  const std::vector<Label_vertices>& vertices)
{
  const auto is_by_chance = [&](std::size_t label) {
    const Label_vertices& v = vertices[label];
    switch (search.surfaces[label].kind) {
    case Surface_kind::PLANE:
    case Surface_kind::CYLINDER:
      return v.number < 4;
    case Surface_kind::TORUS:
      return v.inside == 0 || number_of_parallels(search.surfaces[label], v.points) <= 3;
    default:
      return v.inside == 0;
    }
  };
  std::vector<Evidence> result(vertices.size(), Evidence::NONE);
  for (std::size_t label = 0; label < result.size(); ++label) {
    const Surface_kind kind = search.surfaces[label].kind;
    if (kind != Surface_kind::FREEFORM && !is_by_chance(label))
      result[label] = vertices[label].number < 4 * degrees_of_freedom(kind) ? Evidence::WEAK
                                                                            : Evidence::STRONG;
  }
  return result;
}

/// By label: the share of its border across which it may go on smoothly to labels whose evidence is
/// not strong.
inline std::vector<double> shares_of_uncertain_border(const Face_search& search,
                                                      const std::vector<Evidence>& evidence)
{
  const Surface& surface = search.surface;
  std::vector<double> uncertain(evidence.size(), 0), all(evidence.size(), 0);
  for_each_border(surface, search.labels, [&](std::size_t a, std::size_t i, std::size_t j) {
    const double length = surface.length(a),
                 smooth = search.neighbors.may_be_smooth(a) ? length : 0;
    all[i] += length;
    all[j] += length;
    uncertain[i] += evidence[j] == Evidence::STRONG ? 0 : smooth;
    uncertain[j] += evidence[i] == Evidence::STRONG ? 0 : smooth;
  });
  for (std::size_t label = 0; label < all.size(); ++label)
    uncertain[label] /= all[label] > 0 ? all[label] : 1;
  return uncertain;
}

/// By label. Places of freeform faces border on them: where most of the border is sharp, or meets
/// surfaces of strong evidence, 4 vertices are enough, as for a chamfer along planes and arcs.
inline std::vector<Evidence> evidence_of_surfaces(const Face_search& search)
{
  constexpr double little = 0.25;
  constexpr int fewest_vertices = 4;
  const std::vector<Label_vertices> vertices = vertices_of_labels(search);
  std::vector<Evidence> result = evidence_of_vertices(search, vertices);
  const std::vector<double> uncertain = shares_of_uncertain_border(search, result);
  for (std::size_t label = 0; label < result.size(); ++label)
    if (search.surfaces[label].kind != Surface_kind::FREEFORM && uncertain[label] < little &&
        vertices[label].number >= fewest_vertices)
      result[label] = Evidence::STRONG;
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_SURFACE_EVIDENCE_H
