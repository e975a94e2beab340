// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PROPOSE_SURFACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PROPOSE_SURFACES_H

#include <CGAL/Region_segmentation/internal/faces/fit_surface.h>
#include <CGAL/Region_segmentation/internal/faces/initial_surfaces.h>

#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Fits a surface of a kind to points near `origin` with approximate normal `normal`, from several initial values; until one
/// has a root mean square distance below `stop`. Returns the smallest one.
class Surface_proposer
{
public:
  /// \param axis to which the normals are most orthogonal; 0 if not known
  Surface_proposer(const std::vector<Double_3>& points, const Double_3& origin, const Double_3& normal, const Double_3& axis,
                   double stop)
    : m_points(points), m_axis(axis), m_fitter(points, stop), m_stop(stop), m_number_of_points(points.size()), m_origin(origin), m_normal(normal)
    , m_paraboloid(osculating_paraboloid(points, origin, normal))
  {}

  double operator()(Surface_kind kind, Fitted_surface& best) const
  {
    double least = 1e300;
    if (int(m_number_of_points) < degrees_of_freedom(kind) + 2)
      return least;
    const auto attempt = [&](const Fitted_surface& initial) {
      Fitted_surface s = initial;
      const double error = m_fitter(s);
      if (error < least) {
        least = error;
        best = s;
      }
      return least <= m_stop;
    };
    from_initial_values(kind, attempt);
    return least;
  }

private:
  template <typename Attempt>
  void from_initial_values(Surface_kind kind, const Attempt& attempt) const
  {
    constexpr double angles[] = {0, 0.5, -0.5, 1.0, -1.0};
    const Osculating_paraboloid& o = m_paraboloid;
    switch (kind) {
    case Surface_kind::PLANE:
      attempt(surface_of_kind(Surface_kind::PLANE, m_origin, m_normal));
      break;
    case Surface_kind::CYLINDER:
      if (!attempt(initial_cylinder(o)) && squared_norm(m_axis) > 0)
        attempt(cylinder_along(m_axis, m_points, m_origin));
      break;
    case Surface_kind::SPHERE:
      attempt(initial_sphere(o));
      break;
    case Surface_kind::CONE:
      for (const double angle : {0.1, 0.5, -0.5, 1.0, -1.0})
        if (attempt(initial_cone(o, angle)))
          return;
      break;
    case Surface_kind::TORUS:
      for (int meridian = 0; meridian < 2; ++meridian)
        for (const double angle : angles)
          if (std::fabs(o.curvature[meridian]) > 0.05 * std::fabs(o.curvature[0]) && attempt(initial_torus(o, meridian, angle)))
            return;
      break;
    default:
      break;
    }
  }

  const std::vector<Double_3>& m_points;
  Double_3 m_axis;
  Surface_fitter m_fitter;
  double m_stop;
  std::size_t m_number_of_points;
  Double_3 m_origin, m_normal;
  Osculating_paraboloid m_paraboloid;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_PROPOSE_SURFACES_H
