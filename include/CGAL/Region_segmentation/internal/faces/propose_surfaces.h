// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PROPOSE_SURFACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PROPOSE_SURFACES_H

#include <CGAL/Region_segmentation/internal/faces/fit_surface.h>
#include <CGAL/Region_segmentation/internal/faces/initial_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

inline constexpr Surface_kind kinds_of_surfaces[] = {Surface_kind::PLANE, Surface_kind::CYLINDER,
                                                     Surface_kind::CONE, Surface_kind::SPHERE,
                                                     Surface_kind::TORUS};

/// Fits a surface of a kind to points near `origin` with approximate normal `normal`, from the
/// three initial surfaces that are nearest to them, the nearest first; until one has a root mean
/// square distance below `stop`. Returns the smallest one.
class Surface_proposer
{
public:
  /// \param axis to which the normals are most orthogonal; 0 if not known
  Surface_proposer(const std::vector<Double_3>& points, const Double_3& origin,
                   const Double_3& normal, const Double_3& axis, double stop)
    : m_points(points)
    , m_axis(axis)
    , m_fitter(points, stop)
    , m_stop(stop)
    , m_origin(origin)
    , m_normal(normal)
    , m_paraboloid(osculating_paraboloid(points, origin, normal))
  {}

  double operator()(Surface_kind kind, Fitted_surface<>& best) const
  {
    constexpr std::size_t most_tried = 3;
    double least = 1e300;
    if (int(m_points.size()) < degrees_of_freedom(kind) + 2)
      return least;
    std::vector<std::pair<double, Fitted_surface<>>> initial; // with their distances to the points
    for (const Fitted_surface<>& s : initial_surfaces(kind))
      initial.push_back({m_fitter.root_mean_square(s), s});
    std::stable_sort(initial.begin(), initial.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    initial.resize((std::min)(initial.size(), most_tried));
    for (auto& candidate : initial) {
      const double error = m_fitter(candidate.second);
      if (error < least) {
        least = error;
        best = candidate.second;
      }
      if (least <= m_stop)
        break;
    }
    return least;
  }

private:
  std::vector<Fitted_surface<>> initial_surfaces(Surface_kind kind) const
  {
    const Osculating_paraboloid& o = m_paraboloid;
    std::vector<Fitted_surface<>> result;
    switch (kind) {
    case Surface_kind::PLANE:
      result.push_back(surface_of_kind(Surface_kind::PLANE, m_origin, m_normal));
      break;
    case Surface_kind::CYLINDER:
      result.push_back(initial_cylinder(o));
      if (squared_norm(m_axis) > 0)
        result.push_back(cylinder_along(m_axis, m_points, m_origin));
      break;
    case Surface_kind::SPHERE:
      result.push_back(initial_sphere(o));
      break;
    case Surface_kind::CONE:
      for (const double angle : {0.1, 0.5, -0.5, 1.0, -1.0})
        result.push_back(initial_cone(o, angle));
      break;
    case Surface_kind::TORUS:
      for (int meridian = 0; meridian < 2; ++meridian)
        for (const double angle : {0.0, 0.5, -0.5, 1.0, -1.0})
          if (std::fabs(o.curvature[meridian]) > 0.05 * std::fabs(o.curvature[0]))
            result.push_back(initial_torus(o, meridian, angle));
      break;
    default:
      break;
    }
    return result;
  }

  const std::vector<Double_3>& m_points;
  Double_3 m_axis;
  Surface_fitter m_fitter;
  double m_stop;
  Double_3 m_origin, m_normal;
  Osculating_paraboloid m_paraboloid;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PROPOSE_SURFACES_H
