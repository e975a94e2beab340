// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_GROWER_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_GROWER_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_neighbors.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether a face lies on a surface: its vertices do, within a tolerance, and its normal is that of
/// the surface, within some 37 degrees.
class Face_test
{
public:
  Face_test(const Surface& surface, const Face_neighbors& neighbors, double tolerance)
    : m_surface(surface)
    , m_neighbors(neighbors)
    , m_tolerance(tolerance)
  {}

  double tolerance() const { return m_tolerance; }

  bool operator()(const Fitted_surface<>& s, std::size_t face) const
  {
    return has_vertices_on(s, face) && has_normal_of(s, face);
  }

  bool has_vertices_on(const Fitted_surface<>& s, std::size_t face) const
  {
    const Surface_distance distance(s);
    for (std::size_t i = 0; i < m_surface.number_of_corners(face); ++i)
      if (!(std::fabs(distance(corner(face, i))) <= m_tolerance))
        return false;
    return true;
  }

  bool has_normal_of(const Fitted_surface<>& s, std::size_t face,
                     double cosine = usual_cosine) const
  {
    return dot(m_surface.normal(face), surface_normal(s, m_surface.centroid(face))) > cosine;
  }

  /// The distance of the center of its facet from a surface: that of facets of one tessellation is
  /// alike, but a cap, or the flat of a shaft, deviates more though its vertices lie on the
  /// surface. Of a facet that leaves the surface, where faces meet smoothly, that of the face
  /// itself.
  double deviation_of_facet(const Fitted_surface<>& s, std::size_t face) const
  {
    const Surface_distance distance(s);
    const bool is_on = std::fabs(distance(m_neighbors.end_of_facet(face, 0))) <= m_tolerance &&
                       std::fabs(distance(m_neighbors.end_of_facet(face, 1))) <= m_tolerance;
    return std::fabs(
      distance(is_on ? m_neighbors.center_of_facet(face) : m_surface.centroid(face)));
  }

  /// The largest `deviation_of_facet()` of the facets of a face of the part, of which some are
  /// known.
  double largest_deviation(const Fitted_surface<>& s,
                           const std::vector<Surface::Index>& faces) const
  {
    constexpr double much = 10, least = 0.01, most = 0.16; // 1 - cos of 8 and 33 degrees
    std::vector<std::pair<double, Surface::Index>> deviations;
    for (const Surface::Index f : faces)
      deviations.push_back({deviation_of_facet(s, f), m_neighbors.facet(f)});
    std::sort(deviations.begin(), deviations.end());
    deviations.erase(std::unique(deviations.begin(), deviations.end()), deviations.end());
    const double radius = s.radius + s.minor_radius,
                 typical = (std::max)({much * deviations[deviations.size() * 3 / 4].first,
                                       least * radius, m_tolerance});
    return s.kind == Surface_kind::SPHERE ? (std::min)(typical, most * radius) : typical;
  }

  /// The mean distance of the midpoints of the edges of a face to a surface: how much the face
  /// deviates from it.
  double deviation(const Fitted_surface<>& s, std::size_t face) const
  {
    const Surface_distance distance(s);
    const std::size_t n = m_surface.number_of_corners(face);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += std::fabs(distance(0.5 * (corner(face, i) + corner(face, (i + 1) % n))));
    return sum / double(n);
  }

private:
  static constexpr double usual_cosine = 0.8;

  const Double_3& corner(std::size_t face, std::size_t i) const
  {
    return m_surface.point(m_surface.corner(face, i));
  }

  const Surface& m_surface;
  const Face_neighbors& m_neighbors;
  double m_tolerance;
};

/// The vertex of a face that is farthest from its side to another face, as the foot of the
/// perpendicular on the line of that side, and the perpendicular.
struct Perpendicular
{
  Double_3 foot, vector{0, 0, 0};

  Perpendicular(const Surface& surface, Surface::Index face, Surface::Index other)
  {
    const Shared_side side(surface, face, other);
    for (std::size_t i = 0; i < surface.number_of_corners(face); ++i) {
      const Double_3 p = surface.point(surface.corner(face, i)), d = p - side.middle,
                     across = d - dot(d, side.along) * side.along;
      if (i == 0 || squared_norm(across) > squared_norm(vector)) {
        foot = p - across;
        vector = across;
      }
    }
  }
};

/// Whether the neighbor of a face that is on a curved surface leaves it little by little: it
/// departs from the surface less than a plane that is tangent to it where they meet would, and more
/// than the tolerance. Else its curvature is another one.
inline bool departs_gradually(const Surface& surface, const Face_test& test,
                              const Fitted_surface<>& s, Surface::Index face,
                              Surface::Index neighbor)
{
  constexpr double much_less = 0.7, along_tube = 0.02;
  if (s.kind == Surface_kind::PLANE || !test.has_normal_of(s, neighbor))
    return false;
  const Perpendicular p(surface, neighbor, face);
  const double height = norm(p.vector);
  const Double_3 normal = surface_normal(s, p.foot),
                 tangent = p.vector - dot(p.vector, normal) * normal;
  const Surface_distance distance(s);
  const double apart = std::fabs(distance(p.foot + p.vector));
  if (!(norm(tangent) > 0) || apart <= test.tolerance())
    return false;
  const double radius = s.kind == Surface_kind::TORUS ? s.minor_radius : s.radius,
               of_plane = std::fabs(distance(p.foot + (height / norm(tangent)) * tangent) -
                                    distance(p.foot)),
               of_tube = std::sqrt(height * height + radius * radius) - radius;
  return apart < (std::max)(much_less * of_plane, along_tube * of_tube);
}

/// Grows a face over all that lies on its surface, and fits the surface again whenever the face has
/// doubled, and at the end: then those that did not lie on the former surface are tested again.
class Face_grower
{
public:
  using Index = Surface::Index;

  /// \param is_noisy whether vertices deviate from surfaces by more than rounding: then normals of
  ///        small faces tell little, and creases are crossed
  /// \param stop see `Surface_fitter`
  Face_grower(const Surface& surface, const Face_neighbors& neighbors, const Face_test& test,
              bool is_noisy, double stop)
    : m_surface(surface)
    , m_neighbors(neighbors)
    , m_test(test)
    , m_is_noisy(is_noisy)
    , m_stop(stop)
    , m_taken(surface)
    , m_visited(surface.number_of_faces())
  {}

  /// From those of the faces `seeds` that lie on `s`, over faces that `is_free(face)`. Improves
  /// `s`.
  template <typename IsFree>
  void grow(Fitted_surface<>& s, const std::vector<Index>& seeds, const IsFree& is_free)
  {
    m_taken.clear();
    m_visited.clear();
    m_rejected.clear();
    m_area = 0;
    m_largest_deviation = m_is_noisy ? std::numeric_limits<double>::infinity()
                                     : m_test.largest_deviation(s, seeds);
    for (const Index f : seeds)
      visit(s, f);
    std::size_t next_fit = 2 * points().size();
    for (std::size_t next = 0, tested = faces().size(); next < faces().size();) {
      for (; next < faces().size(); ++next) {
        if (points().size() >= next_fit) {
          refine(s);
          next_fit = 2 * points().size();
        }
        for (const Face_neighbors::Neighbor& n : m_neighbors[faces()[next]])
          if (!m_visited.has(n.face) && is_free(n.face) &&
              (m_is_noisy || m_neighbors.is_smooth(n.adjacency)))
            visit(s, n.face);
      }
      refine(s);
      if (faces().size() > tested) { // the surface is another one now
        tested = faces().size();
        std::vector<Index> rejected;
        rejected.swap(m_rejected);
        for (const Index f : rejected)
          take_if_on(s, f);
      }
    }
  }

  /// The share of the border between a face that was taken and a neighbor for which `f(face,
  /// neighbor)`.
  template <typename F>
  double share_of_border(const F& f) const
  {
    double share = 0, all = 0;
    for (const Index face : faces())
      for (const Face_neighbors::Neighbor& n : m_neighbors[face])
        if (!is_taken(n.face)) {
          const double length = m_surface.length(n.adjacency);
          all += length;
          share += f(face, n) ? length : 0;
        }
    return all > 0 ? share / all : 0;
  }

  /// The share of the border where the mesh leaves the surface little by little: growing has
  /// stopped in the middle of a face that is not on this surface, but only osculated by it.
  double gradual_border(const Fitted_surface<>& s) const
  {
    return share_of_border([&](Index face, const Face_neighbors::Neighbor& n) {
      return departs_gradually(m_surface, m_test, s, face, n.face);
    });
  }

  /// The share of the area that is coplanar with the largest face.
  double share_of_largest_facet() const
  {
    Index largest = faces()[0];
    for (const Index f : faces())
      if (m_surface.area(f) > m_surface.area(largest))
        largest = f;
    double area = 0;
    for (const Index f : faces())
      if (dot(m_surface.normal(f), m_surface.normal(largest)) > 1 - 1e-9)
        area += m_surface.area(f);
    return area / m_area;
  }

  const std::vector<Index>& faces() const { return m_taken.faces(); }
  bool is_taken(Index face) const { return m_taken.has(face); }
  const std::vector<Double_3>& points() const { return m_taken.points(); }
  double area() const { return m_area; }
  /// See `Face_test`.
  double largest_deviation() const { return m_largest_deviation; }

private:
  void visit(const Fitted_surface<>& s, Index face)
  {
    if (m_visited.mark(face))
      take_if_on(s, face);
  }

  void take_if_on(const Fitted_surface<>& s, Index face)
  {
    if (!m_test(s, face) || m_test.deviation_of_facet(s, face) > m_largest_deviation) {
      m_rejected.push_back(face);
      return;
    }
    m_taken.add(face);
    m_area += m_surface.area(face);
  }

  /// Where vertices lie on surfaces to rounding, those that were taken stay within the tolerance.
  void refine(Fitted_surface<>& s) const
  {
    Fitted_surface<> better = s;
    refine_surface(better, points(), m_test.tolerance(), m_stop);
    if (m_is_noisy || largest_distance(better, points()) <= m_test.tolerance())
      s = better;
  }

  const Surface& m_surface;
  const Face_neighbors& m_neighbors;
  const Face_test& m_test;
  bool m_is_noisy;
  double m_stop;
  Face_set m_taken;
  Element_marks m_visited;
  std::vector<Index> m_rejected;
  double m_area = 0, m_largest_deviation = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_GROWER_H
