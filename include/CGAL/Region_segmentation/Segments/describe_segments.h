// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_DESCRIBE_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_DESCRIBE_SEGMENTS_H

/// \file describe_segments.h
/// Requires Eigen 3; so it is not part of region_segmentation.h.

#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/initial_surfaces.h>
#include <CGAL/Region_segmentation/Segments/Segment_description.h>
#include <CGAL/Region_segmentation/Segments/internal/Segment_caps.h>
#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/Origin.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Points of a segment, weighted by area: the corners of its faces, and the middle of each face.
/// The centroid of the segment is the origin, and its area is 1.
class Segment_samples
{
public:
  /// `normal`: zero for a degenerate face.
  void add_face(const std::vector<Double_3>& corners, const Double_3& middle,
                const Double_3& normal, double weight)
  {
    const double share = weight / double(corners.size());
    for (const Double_3& p : corners) {
      m_corners.push_back(p);
      m_corner_weights.push_back(share);
      m_moments.add(share, p);
    }
    m_middles.push_back(middle);
    m_weights.push_back(weight);
    m_normals.push_back(normal);
    m_normal_moments.add(weight, normal);
  }

  /// The length of the faces along an axis.
  double extent(const Double_3& axis) const
  {
    Fitted_surface<> plane = surface_of_kind(Surface_kind::PLANE, {0, 0, 0}, axis);
    measure(plane, m_corners);
    return plane.highest - plane.lowest;
  }

  /// The plane, sphere, cylinder or cone of the segment: each kind, in this order, replaces the one
  /// chosen before if it fits much better. `errors`: by kind, the root mean square distance of the
  /// corners to the best surface; infinite where none was found.
  ///
  /// Surfaces are compared by the misfit: the root mean square distance of corners and middles of
  /// faces together. Corners alone do not tell a cylinder or a cone from a sphere if they lie on
  /// two circles, as on many machine parts.
  Fitted_surface<> best_surface(std::array<double, 4>& errors) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Surface_fitter corners(m_corners, 0, m_corner_weights), middles(m_middles, 0, m_weights);
    Fitted_surface<> best;
    double least = infinity;
    const auto accept = [&](const Fitted_surface<>& s) {
      double& error = errors[std::size_t(s.kind)];
      error = corners.root_mean_square(s);
      const double misfit = std::hypot(error, middles.root_mean_square(s)) / std::sqrt(2.0);
      if (least > tolerance && misfit < worthwhile * least) {
        least = misfit;
        best = s;
      }
    };
    errors.fill(infinity);
    accept(plane());
    if (least > rounding) // else the points tell no other surface
      for (const Fitted_surface<>& s : other_surfaces())
        accept(s);
    move_along_axis(best, {0, 0, 0});
    measure(best, m_corners);
    best.side = has_outward_normals(best) ? 1 : -1;
    return best;
  }

private:
  static constexpr std::size_t most_fitted = 1000; // corners; errors are those of all
  static constexpr double rounding = 1e-12;        // the misfit of points on a plane
  static constexpr double tolerance = 1e-4;        // misfits below are as good as none
  static constexpr double worthwhile = 0.8; // what another parameter multiplies the misfit with
  static constexpr int most_iterations = 100, most_slow_iterations = 20; // often no surface fits

  Fitted_surface<> plane() const
  {
    const Double_3 normal = eigenvectors(m_moments.covariance())[0];
    return surface_of_kind(Surface_kind::PLANE, m_moments.centroid(),
                           dot(normal, m_normal_moments.first) < 0 ? -1.0 * normal : normal);
  }

  /// The sphere, cylinder and cone with the least squared distances of the corners. The normals of
  /// a cylinder are perpendicular to its axis, those of a cone lie on a circle around it.
  std::vector<Fitted_surface<>> other_surfaces() const
  {
    const Double_3 origin{0, 0, 0};
    const std::vector<Double_3> points = evenly_spread(m_corners, most_fitted);
    const Surface_fitter fitter(points, 0, evenly_spread(m_corner_weights, most_fitted));
    std::vector<Fitted_surface<>> result;
    for (Fitted_surface<> s :
         {sphere_with_axis({0, 0, 1}, points, origin),
          cylinder_along(eigenvectors(m_normal_moments.second)[0], points, origin),
          cone_along(eigenvectors(m_normal_moments.covariance())[0], points, origin)})
      if (std::isfinite(fitter(s, most_iterations, most_slow_iterations)))
        result.push_back(s);
    return result;
  }

  bool has_outward_normals(const Fitted_surface<>& s) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < m_normals.size(); ++i)
      sum += m_weights[i] * dot(m_normals[i], surface_normal(s, m_middles[i]));
    return sum >= 0;
  }

  std::vector<Double_3> m_corners, m_middles, m_normals; // middles and normals by face
  std::vector<double> m_corner_weights, m_weights;
  Second_moments m_moments, m_normal_moments; // of corners and of normals
};

/// Describes the segments of a mesh.
///
/// \tparam Kernel that of the results
template <typename FaceGraph, typename Label, typename Kernel>
class Segment_describer
{
  using Index = Segmented_halfedges::Index;

public:
  using Description = Segment_description<Label, Kernel>;

  Segment_describer(const Segmented_mesh<FaceGraph, Label>& segmented, const Surface& surface)
    : m_segmented(segmented)
    , m_surface(surface)
    , m_faces(segmented.number_of_segments + 1,
              [&](const auto& add) {
                for (Index f = 0; f < segmented.number_of_faces(); ++f)
                  add(segmented.segment_of_face[f], f);
              })
    , m_descriptions(segmented.number_of_segments)
  {}

  std::vector<Description> describe()
  {
    for (std::size_t s = 0; s < m_descriptions.size(); ++s)
      describe_shape(s);
    describe_volumes();
    describe_neighbors();
    return std::move(m_descriptions);
  }

private:
  using Points = std::vector<Double_3>;

  static typename Kernel::Vector_3 to_vector(const Double_3& v)
  {
    using FT = typename Kernel::FT;
    return typename Kernel::Vector_3(FT(v.x), FT(v.y), FT(v.z));
  }

  /// Calls `f(face, corners)` for the faces of a segment; a corner is factor (p - origin).
  template <typename F>
  void for_each_face(std::size_t segment, const Double_3& origin, double factor, const F& f) const
  {
    Points corners;
    for (Index face : m_faces[segment]) {
      corners.clear();
      for (const Index v : m_surface.corners(face))
        corners.push_back(factor * (m_surface.point(v) - origin));
      f(face, corners);
    }
  }

  /// Describes area, centroid, axes, extents and surface.
  void describe_shape(std::size_t segment)
  {
    const double unit = m_surface.unit();
    // Coordinates are relative to a point nearby, so that nothing cancels far from the origin.
    const Double_3 origin = m_surface.point(m_surface.corner(*m_faces[segment].begin(), 0));
    Second_moments moments;
    for_each_face(segment, origin, 1, [&](Index, const Points& p) { add_moments(p, moments); });
    const Double_3 center = origin + moments.centroid();
    const double area = moments.weight, size = area > 0 ? std::sqrt(area) : 1;
    Segment_samples samples;
    for_each_face(segment, center, 1 / size, [&](Index f, const Points& corners) {
      samples.add_face(corners, 1 / size * (m_surface.centroid(f) - center), m_surface.normal(f),
                       area > 0 ? m_surface.area(f) : 1);
    });
    Description& d = m_descriptions[segment];
    d.segment = m_segmented.labels[segment];
    d.number_of_faces = m_faces[segment].size();
    d.area = area * unit * unit; // the square of the unit may be infinite where the area is 0
    d.centroid = CGAL::ORIGIN + to_vector(unit * center);
    const std::array<Double_3, 3> axes = principal_axes(moments.covariance());
    for (std::size_t i = 0; i < 3; ++i) {
      d.axes[i] = to_vector(axes[i]);
      d.extents[i] = samples.extent(axes[i]) * size * unit;
    }
    Fitted_surface<> surface = samples.best_surface(d.surface_errors);
    surface.point = surface.point + 1 / size * center;
    d.surface = scaled<Kernel>(surface, size * unit);
    for (double& error : d.surface_errors)
      error *= size * unit;
  }

  /// Adds the moments of a face: those of the triangles of a fan, each with its area as seen along
  /// the normal, so that the face may be concave. The integral of x x^T over a triangle a, b, c of
  /// area A is A / 12 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
  static void add_moments(const Points& p, Second_moments& moments)
  {
    Double_3 normal{0, 0, 0};
    for (std::size_t i = 2; i < p.size(); ++i)
      normal = normal + cross(p[i - 1] - p[0], p[i] - p[0]);
    const double length = norm(normal);
    for (std::size_t i = 2; length > 0 && i < p.size(); ++i) {
      const double a = dot(normal, cross(p[i - 1] - p[0], p[i] - p[0])) / length / 2;
      const Double_3 sum = p[0] + p[i - 1] + p[i];
      moments.weight += a;
      moments.first = moments.first + a / 3 * sum;
      for (const Double_3& v : {p[0], p[i - 1], p[i], sum})
        moments.second.add_square(a / 12, v);
    }
  }

  static std::array<Double_3, 3> principal_axes(const Symmetric_3& covariance)
  {
    std::array<Double_3, 3> axes = eigenvectors(covariance);
    std::swap(axes[0], axes[2]); // from the largest to the smallest moment
    const auto is_smaller = [](double x, double y) { return std::fabs(x) < std::fabs(y); };
    for (Double_3& a : axes)
      if ((std::max)({a.x, a.y, a.z}, is_smaller) < 0)
        a = -1.0 * a;
    axes[2] = cross(axes[0], axes[1]);
    return axes;
  }

  void describe_volumes()
  {
    const double unit = m_surface.unit();
    const std::vector<double> volumes = segment_volumes(m_segmented, m_surface);
    const double whole = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    const bool has_volume = whole > 1e-12 * std::pow(m_surface.area(), 1.5);
    for (std::size_t s = 0; s < m_descriptions.size(); ++s) {
      m_descriptions[s].volume = volumes[s] * unit * unit * unit;
      m_descriptions[s].volume_share = has_volume ? volumes[s] / whole : 0;
    }
  }

  void describe_neighbors()
  {
    struct Joint
    {
      double length = 0, weighted_deviation = 0;
    };
    std::map<std::pair<Index, Index>, Joint> joints; // of a segment with what is across its border
    for (Index h = 0; h < m_segmented.size(); ++h) {
      if (!m_segmented.has_segment(h) || !m_segmented.is_on_border(h))
        continue;
      const double length = norm(m_surface.point(m_segmented.target(h)) -
                                 m_surface.point(m_segmented.source[h]));
      const Index adjacency = adjacency_across(m_surface, m_segmented, h);
      Joint& joint = joints[{m_segmented.segment(h), m_segmented.segment_across(h)}];
      joint.length += length;
      if (adjacency != Surface::none)
        joint.weighted_deviation += length * signed_deviation(m_surface, adjacency);
    }
    for (const auto& [segments, joint] : joints) {
      Description& d = m_descriptions[segments.first];
      const double length = joint.length * m_surface.unit(),
                   mean = joint.length > 0 ? joint.weighted_deviation / joint.length : 0;
      if (segments.second > m_segmented.number_of_segments) {
        d.boundary_length = length;
        continue;
      }
      d.neighbors.push_back({m_segmented.label(segments.second), length, mean});
      d.border_length += length;
    }
  }

  const Segmented_mesh<FaceGraph, Label>& m_segmented;
  const Surface& m_surface;
  const Grouped_items<Index> m_faces; // by segment
  std::vector<Description> m_descriptions;
};

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// describes every segment: area, volume, centroid, principal axes, neighbors, and the primitive
/// that fits best. See `Segment_description`.
///
/// `#include <CGAL/Region_segmentation/Segments/describe_segments.h>`, which requires Eigen.
///
/// A plane, a sphere, a cylinder and a cone are fitted to the corners of the faces, weighted by
/// area. The axis of a cylinder or cone that the normals determine, and the least algebraic
/// distance, give a start, from which Levenberg and Marquardt's method minimizes the mean square
/// distance; of more than 1000 corners, at most 1000 are fitted, spread evenly. The plane is exact,
/// the other minima are local. The misfit of a primitive is the root mean square distance of the
/// corners and of the middles of the faces together, since corners on two circles alone could be
/// those of a sphere. From the simplest to the most complex, a primitive replaces the previous
/// choice if its misfit is below 0.8 of it, and that one was more than \f$10^{-4}\f$ of the square
/// root of the area. Spheres and cylinders whose radius is more than 100 times the extent of the
/// segment are not considered; where all corners are on a plane, to rounding, nothing but this is.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam DescriptionOutputIterator a model of `OutputIterator` that takes
///         `Segment_description<Label, Kernel>`: `Label` is the value type of `FaceSegmentMap`,
///         `Kernel` the kernel of the points, `CGAL::Kernel_traits<Point>::Kernel` where `Point` is
///         the value type of the vertex point map; `CGAL::Simple_cartesian<double>` if that has
///         none
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` belong to none
/// \param descriptions receives the descriptions, in the order of the first faces of the segments
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the output iterator
/// \throws Invalid_input if a point is not finite
///
/// Complexity: O(F log F). Deterministic: the same numbers from every mesh type. Read-only;
/// concurrent calls are safe. Areas and volumes in units of the mesh may exceed the range of
/// `double` if coordinates are extreme.
template <typename FaceGraph, typename FaceSegmentMap, typename DescriptionOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
DescriptionOutputIterator
describe_segments(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                  DescriptionOutputIterator descriptions,
                  const NamedParameters& np = parameters::default_values())
{
  using Label = typename boost::property_traits<FaceSegmentMap>::value_type;
  const auto& pack = internal::pack(np);
  using Pack = std::decay_t<decltype(pack)>;
  using Kernel = internal::Kernel_of_points<
    typename GetVertexPointMap<FaceGraph, Pack>::const_type>;
  internal::check_parameters<Pack, internal::Tag_list<>>();
  const auto segmented = internal::read_segmented_mesh(mesh, segment_map, pack);
  const Surface surface = internal::make_surface(mesh, pack, internal::Adjacent::NEIGHBORS,
                                                 Execution());
  const auto result = internal::Segment_describer<FaceGraph, Label, Kernel>(segmented, surface)
                        .describe();
  return std::copy(result.begin(), result.end(), descriptions);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_DESCRIBE_SEGMENTS_H
