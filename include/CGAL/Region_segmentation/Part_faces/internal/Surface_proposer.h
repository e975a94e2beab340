// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_SURFACE_PROPOSER_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_SURFACE_PROPOSER_H

#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/initial_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A plane piece of a surface.
struct Oriented_piece
{
  Double_3 center, normal;
  double area;
};

/// Fits surfaces of all kinds to points: from the initial surfaces of a kind that are nearest to
/// them, the nearest first, until one has a root mean square distance below `stop`.
class Surface_proposer
{
public:
  static constexpr std::size_t most_points = 80; ///< that are fitted

  /// \param pieces of the surface around the points: not none, and with normals
  Surface_proposer(const std::vector<Double_3>& points, const std::vector<Oriented_piece>& pieces,
                   double stop)
    : m_points(evenly_spread(points, most_points))
    , m_fitter(m_points, stop)
    , m_stop(stop)
    , m_origin(pieces[0].center)
  {
    Symmetric_3 squares, around_mean;
    Double_3 sum{0, 0, 0};
    double area = 0;
    std::vector<Double_3> centers, normals;
    for (const Oriented_piece& piece : pieces) {
      squares.add_square(piece.area, piece.normal);
      sum = sum + piece.area * piece.normal;
      area += piece.area;
      centers.push_back(piece.center);
      normals.push_back(std::sqrt(piece.area) * piece.normal);
    }
    around_mean = squares;
    around_mean.add_square(-1 / area, sum);
    m_normal = norm(sum) > 1e-9 * area ? (1 / norm(sum)) * sum : pieces[0].normal;
    m_orthogonal = eigenvectors(squares)[0];
    m_equal_angles = eigenvectors(around_mean)[0];
    m_line = axis_line(centers, normals, m_origin);
    if (!is_finite(m_line.point) || !is_finite(m_line.direction))
      m_line = {m_origin, m_normal};
    m_paraboloid = osculating_paraboloid(m_points, m_origin, m_normal);
  }

  /// Returns the root mean square distance of the best surface, infinity if there is none.
  /// \param wanted see `Surface_fitter`
  double operator()(Surface_kind kind, double wanted, Fitted_surface<>& best) const
  {
    constexpr std::size_t most_tried = 3;
    constexpr int iterations = 30;
    const int slow_iterations = kind == Surface_kind::TORUS ? 6 : 3; // tori converge slowly
    double least = std::numeric_limits<double>::infinity();
    if (int(m_points.size()) <= degrees_of_freedom(kind))
      return least;
    std::vector<std::pair<double, Fitted_surface<>>> initial; // with their distances to the points
    for (const Fitted_surface<>& s : initial_surfaces(kind))
      if (const double error = m_fitter.root_mean_square(s); std::isfinite(error))
        initial.push_back({error, s});
    std::stable_sort(initial.begin(), initial.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    initial.resize((std::min)(initial.size(), most_tried));
    for (auto& candidate : initial) {
      const double error = m_fitter(candidate.second, iterations, slow_iterations, wanted);
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
    std::vector<Fitted_surface<>> result;
    switch (kind) {
    case Surface_kind::PLANE:
      return {surface_of_kind(Surface_kind::PLANE, m_origin, m_normal)};
    case Surface_kind::CYLINDER:
      for (const Double_3& axis : {m_orthogonal, m_equal_angles, m_line.direction})
        result.push_back(cylinder_along(axis, m_points, m_origin));
      return result;
    case Surface_kind::CONE:
      for (const Double_3& axis : {m_equal_angles, m_line.direction, m_orthogonal})
        result.push_back(cone_along(axis, m_points, m_origin));
      return result;
    case Surface_kind::SPHERE:
      return {sphere_with_axis(m_line.direction, m_points, m_origin)};
    default:
      result.push_back(torus_around(m_line, m_points));
      for (int meridian = 0; meridian < 2; ++meridian)
        for (const double angle : {0.0, 0.5, -0.5, 1.0, -1.0})
          if (std::fabs(m_paraboloid.curvature[meridian]) >
              0.05 * std::fabs(m_paraboloid.curvature[0]))
            result.push_back(initial_torus(m_paraboloid, meridian, angle));
      return result;
    }
  }

  std::vector<Double_3> m_points;
  Surface_fitter m_fitter;
  double m_stop;
  Double_3 m_origin, m_normal;
  Osculating_paraboloid m_paraboloid;
  Axis_line m_line;                      ///< that the normals meet
  Double_3 m_orthogonal, m_equal_angles; ///< to the normals, with the normals
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_SURFACE_PROPOSER_H
