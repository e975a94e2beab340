// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_TESSELLATION_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_TESSELLATION_H

#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The face across the i-th side of a face, if that is an edge without a constraint, or none.
inline Surface::Index face_across(const Surface& surface, Surface::Index face, std::size_t i)
{
  const Surface::Index a = surface.adjacency(face, i);
  if (a == Surface::none || surface.has_flag(a, Surface::barrier))
    return Surface::none;
  const Surface::Index lower = surface.lower_face(a);
  return lower == face ? surface.higher_face(a) : lower;
}

/// Calls `f(other, v, w)` for the faces across the sides of a face that are edges without
/// constraints: the side runs from vertex v to vertex w.
template <typename F>
void for_each_neighbor(const Surface& surface, Surface::Index face, const F& f)
{
  const std::size_t n = surface.number_of_corners(face);
  for (std::size_t i = 0; i < n; ++i) {
    const Surface::Index other = face_across(surface, face, i);
    if (other != Surface::none)
      f(other, surface.corner(face, i), surface.corner(face, i + 1 < n ? i + 1 : 0));
  }
}

/// The height of a face over its longest side, if it is a triangle; twice its area over that side.
inline double height_of_face(const Surface& surface, Surface::Index face)
{
  double longest = 0;
  for_each_side(surface, face, [&](Surface::Index v, Surface::Index w) {
    longest = (std::max)(longest, squared_norm(surface.point(w) - surface.point(v)));
  });
  return longest > 0 && !surface.is_degenerate(face) ? 2 * surface.area(face) / std::sqrt(longest)
                                                     : 0;
}

/// The faces around `seed` in breadth first order until they have `wanted` vertices: those across
/// the sides for which `may_cross(face, other, v, w)`.
template <typename Faces, typename MayCross>
void collect_patch(Faces& patch, const Surface& surface, Surface::Index seed, std::size_t wanted,
                   const MayCross& may_cross)
{
  patch.clear();
  patch.add(seed);
  for (std::size_t next = 0; next < patch.faces().size() && patch.points().size() < wanted;
       ++next) {
    const Surface::Index face = patch.faces()[next];
    for_each_neighbor(surface, face, [&](Surface::Index other, Surface::Index v, Surface::Index w) {
      if (!patch.has(other) && patch.points().size() < wanted && may_cross(next, other, v, w))
        patch.add(other);
    });
  }
}

/// A plane facet of a tessellation: faces of the mesh that are coplanar.
struct Facet
{
  Fitted_surface<> plane;
  Double_3 center{0, 0, 0};
  double area = 0;
  std::size_t number_of_vertices = 0;
};

/// A mesh of a machine part whose vertices deviate from the surfaces of the part by some standard
/// deviation: what the normals of its faces tell, and its facets.
class Tessellation
{
public:
  using Index = Surface::Index;
  static constexpr Index none = Surface::none;
  /// Half the width of a prediction interval, in standard deviations.
  static constexpr double interval = 5;
  /// The largest angle between neighboring facets of a curved face: a cylinder has at least 8.
  static constexpr double smooth_angle = 0.804; // 46 degrees

  Tessellation(const Surface& s, double standard_deviation)
    : surface(s)
    , sigma(standard_deviation)
    , m_angle_errors(s.number_of_faces())
    , m_by_area(s.number_of_faces())
    , m_facet_of(s.number_of_faces(), none)
  {
    constexpr double of_normal = 6; // sigma over the height of a face: 3 standard deviations
    for (Index f = 0; f < s.number_of_faces(); ++f) {
      const double height = height_of_face(s, f);
      m_angle_errors[f] = height > 0 ? of_normal * sigma / height
                                     : std::numeric_limits<double>::infinity();
    }
    find_facets();
  }

  const Surface& surface;
  const double sigma;
  /// The largest distance of a vertex from the surface of its face.
  double tolerance() const { return interval * sigma; }
  /// The root mean square distance below which a fit is good enough.
  double good_fit() const { return 0.05 * sigma; }

  /// Whether the normal of a face tells anything: that of a sliver does not.
  bool has_normal(Index face) const { return m_angle_errors[face] < 1; }
  /// Whether two faces meet within an angle, as far as their normals tell.
  bool meet_within(double angle, Index f, Index g) const
  {
    return !has_normal(f) || !has_normal(g) ||
           dot(surface.normal(f), surface.normal(g)) >
             cosine(angle + m_angle_errors[f] + m_angle_errors[g]);
  }
  /// The same of two faces whose normals tell something.
  bool surely_meet_within(double angle, Index f, Index g) const
  {
    return has_normal(f) && has_normal(g) && meet_within(angle, f, g);
  }
  /// Whether two adjacent faces may be facets of one curved face. Others meet at a crease, which no
  /// face crosses.
  bool is_smooth(Index f, Index g) const { return meet_within(smooth_angle, f, g); }
  /// Whether the facet of a face is tangent to a surface of that normal, within an angle.
  bool is_tangent(Index f, const Double_3& normal, double angle) const
  {
    return dot(m_facets[m_facet_of[f]].plane.direction, normal) > std::cos(angle);
  }
  /// Whether the vertices of a face are within the tolerance of a surface.
  bool has_vertices_on(const Fitted_surface<>& s, Index face) const
  {
    const Surface_distance distance(s);
    for (const Index v : surface.corners(face))
      if (!(std::fabs(distance(surface.point(v))) <= tolerance()))
        return false;
    return true;
  }
  /// Whether the normal of a face may be that of a facet of a surface.
  bool has_normal_of(const Fitted_surface<>& s, Index face) const
  {
    constexpr double most = 0.6435; // 37 degrees
    return !has_normal(face) ||
           dot(surface.normal(face), surface_normal(s, surface.centroid(face))) >
             cosine(most + m_angle_errors[face]);
  }
  bool lies_on(const Fitted_surface<>& s, Index face) const
  {
    return has_vertices_on(s, face) && has_normal_of(s, face);
  }

  /// The largest first, so that what is found does not depend on the order of the faces.
  const std::vector<Index>& faces_by_area() const { return m_by_area; }
  std::size_t number_of_facets() const { return m_facets.size(); }
  const Facet& facet(std::size_t i) const { return m_facets[i]; }
  Index facet_of(Index face) const { return m_facet_of[face]; }
  /// The facets of those of some faces that have normals, and the areas of these, by facet.
  std::vector<std::pair<Index, double>> facets_of(const std::vector<Index>& faces) const
  {
    std::vector<std::pair<Index, double>> result;
    for (const Index f : faces)
      if (has_normal(f))
        result.push_back({m_facet_of[f], surface.area(f)});
    std::sort(result.begin(), result.end());
    std::size_t number = 0;
    for (const auto& [facet, area] : result)
      if (number > 0 && result[number - 1].first == facet)
        result[number - 1].second += area;
      else
        result[number++] = {facet, area};
    result.resize(number);
    return result;
  }
  Iterator_range<const Index*> faces_of_facet(std::size_t i) const { return m_faces[i]; }

private:
  static double cosine(double angle) { return std::cos((std::min)(angle, CGAL_PI)); }

  void find_facets()
  {
    std::iota(m_by_area.begin(), m_by_area.end(), Index(0));
    std::stable_sort(m_by_area.begin(), m_by_area.end(),
                     [&](Index a, Index b) { return surface.area(a) > surface.area(b); });
    Face_set faces(surface);
    for (const Index seed : m_by_area)
      if (m_facet_of[seed] == none) {
        m_facets.push_back(grow_facet(faces, seed));
        for (const Index f : faces.faces())
          m_facet_of[f] = Index(m_facets.size() - 1);
      }
    m_faces = Grouped_items<Index>(m_facets.size(), [&](const auto& add) {
      for (Index f = 0; f < m_facet_of.size(); ++f)
        add(m_facet_of[f], f);
    });
  }

  /// Grows from a seed over faces that no facet has. `faces`: those of the facet
  Facet grow_facet(Face_set& faces, Index seed) const
  {
    constexpr std::size_t few_points = 12;
    constexpr double growth = 1.25;
    Facet facet{surface_of_kind(Surface_kind::PLANE, surface.centroid(seed), surface.normal(seed))};
    std::size_t fitted = 0; // points
    const auto fit = [&] {
      Second_moments moments;
      for (const Double_3& p : faces.points())
        moments.add(1, p - surface.centroid(seed));
      const Double_3 normal = eigenvectors(moments.covariance())[0];
      facet.plane.point = surface.centroid(seed) + moments.centroid();
      facet.plane.direction = dot(normal, facet.plane.direction) < 0 ? -1.0 * normal : normal;
      fitted = faces.points().size();
    };
    faces.clear();
    faces.add(seed);
    fit();
    for (std::size_t before = 0; has_normal(seed) && before < faces.faces().size(); fit()) {
      before = faces.faces().size();
      for (std::size_t next = 0; next < faces.faces().size(); ++next)
        for_each_neighbor(surface, faces.faces()[next], [&](Index other, Index, Index) {
          if (m_facet_of[other] != none || faces.has(other) || !lies_on(facet.plane, other))
            return;
          faces.add(other);
          if (fitted < few_points || double(faces.points().size()) >= growth * double(fitted))
            fit();
        });
    }
    for (const Index f : faces.faces())
      facet.center = facet.center + surface.area(f) * surface.centroid(f);
    facet.area = faces.area();
    facet.center = facet.area > 0 ? (1 / facet.area) * facet.center : facet.plane.point;
    facet.number_of_vertices = faces.points().size();
    return facet;
  }

  std::vector<double> m_angle_errors; // by face
  std::vector<Index> m_by_area;
  std::vector<Facet> m_facets;
  std::vector<Index> m_facet_of; // by face
  Grouped_items<Index> m_faces;  // by facet
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_TESSELLATION_H
