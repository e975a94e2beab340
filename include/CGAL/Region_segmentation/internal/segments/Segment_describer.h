// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H

#include <CGAL/Region_segmentation/Segments/Segment_description.h>
#include <CGAL/Region_segmentation/internal/segments/Mesh_geometry.h>
#include <CGAL/Region_segmentation/internal/segments/Primitive_fitter.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/segment_volumes.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Describes the segments of a mesh.
///
/// \tparam Kernel that of the results
template <typename FaceGraph, typename Label, typename Kernel>
class Segment_describer
{
  using Index = Halfedge_table::Index;

public:
  using Description = Segment_description<Label, Kernel>;

  Segment_describer(const Segmented_mesh<FaceGraph, Label>& segmented,
                    const Mesh_geometry& geometry)
    : m_segmented(segmented)
    , m_geometry(geometry)
    , m_faces(segmented.faces_of_segments())
    , m_descriptions(segmented.number_of_segments)
  {}

  std::vector<Description> describe()
  {
    for (std::size_t s = 0; s < m_descriptions.size(); ++s)
      describe_surface(s);
    describe_volumes();
    describe_neighbors();
    return std::move(m_descriptions);
  }

private:
  using Points = std::vector<Eigen::Vector3d>;

  static Eigen::Vector3d to_eigen(const Double_3& v) { return {v.x, v.y, v.z}; }
  static typename Kernel::Vector_3 to_vector(const Eigen::Vector3d& v)
  {
    using FT = typename Kernel::FT;
    return typename Kernel::Vector_3(FT(v[0]), FT(v[1]), FT(v[2]));
  }
  static typename Kernel::Point_3 to_point(const Eigen::Vector3d& v)
  {
    return CGAL::ORIGIN + to_vector(v);
  }

  /// Calls `f(face, corners)` for the faces of a segment; a corner is (p - origin) / unit.
  template <typename F>
  void for_each_face(std::size_t segment, const Eigen::Vector3d& origin, double unit,
                     const F& f) const
  {
    Points corners;
    for (Index face : m_faces[segment]) {
      corners.clear();
      for (Index h = m_segmented.first[face]; h < m_segmented.first[face + 1]; ++h)
        corners.push_back((to_eigen(m_geometry.point(m_segmented.source[h])) - origin) / unit);
      f(face, corners);
    }
  }

  /// Area, centroid, axes, extents and primitive.
  void describe_surface(std::size_t segment)
  {
    const Index first_face = *m_faces[segment].begin();
    // Relative to a point nearby, so that nothing cancels far from the origin.
    const Eigen::Vector3d origin = to_eigen(
      m_geometry.point(m_segmented.source[m_segmented.first[first_face]]));
    double area = 0;
    Eigen::Vector3d first_moment = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second_moment = Eigen::Matrix3d::Zero();
    for_each_face(segment, origin, 1, [&](Index, const Points& p) {
      add_moments(p, area, first_moment, second_moment);
    });
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    if (area > 0) {
      center = first_moment / area;
      second_moment = second_moment / area - center * center.transpose();
    }
    Description& d = m_descriptions[segment];
    const double unit = m_geometry.unit();
    d.segment = m_segmented.labels[segment];
    d.number_of_faces = m_faces[segment].size();
    d.area = area * unit * unit; // one by one: the square of the unit may be infinite, the area 0
    d.centroid = to_point(unit * (origin + center));
    describe_extents(segment, origin + center, principal_axes(second_moment));
    fit_primitive(segment, origin + center, area > 0 ? std::sqrt(area) : 1);
  }

  /// Of the triangles of a fan, each with its area as seen along the normal, so that a face may be
  /// concave. The integral of x x^T over a triangle a, b, c of area A is
  /// A / 12 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
  static void add_moments(const Points& p, double& area, Eigen::Vector3d& first,
                          Eigen::Matrix3d& second)
  {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 2; i < p.size(); ++i)
      normal += (p[i - 1] - p[0]).cross(p[i] - p[0]);
    normal.stableNormalize();
    for (std::size_t i = 2; i < p.size(); ++i) {
      const double a = normal.dot((p[i - 1] - p[0]).cross(p[i] - p[0])) / 2;
      const Eigen::Vector3d sum = p[0] + p[i - 1] + p[i];
      area += a;
      first += a / 3 * sum;
      for (const Eigen::Vector3d& v : {p[0], p[i - 1], p[i], sum})
        second += a / 12 * v * v.transpose();
    }
  }

  static Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& covariance)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance); // eigenvalues increase
    Eigen::Matrix3d axes = solver.eigenvectors().rowwise().reverse();
    for (Eigen::Index i = 0; i < 2; ++i) {
      Eigen::Index largest;
      axes.col(i).cwiseAbs().maxCoeff(&largest);
      if (axes(largest, i) < 0)
        axes.col(i) = -axes.col(i);
    }
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
  }

  void describe_extents(std::size_t segment, const Eigen::Vector3d& center,
                        const Eigen::Matrix3d& axes)
  {
    Eigen::Array3d lowest = Eigen::Array3d::Constant((std::numeric_limits<double>::max)()),
                   highest = -lowest;
    for_each_face(segment, center, 1, [&](Index, const Points& corners) {
      for (const Eigen::Vector3d& p : corners) {
        lowest = lowest.min((axes.transpose() * p).array());
        highest = highest.max((axes.transpose() * p).array());
      }
    });
    for (std::size_t i = 0; i < 3; ++i) {
      m_descriptions[segment].axes[i] = to_vector(axes.col(Eigen::Index(i)));
      m_descriptions[segment].extents[i] = (highest - lowest)[Eigen::Index(i)] * m_geometry.unit();
    }
  }

  void fit_primitive(std::size_t segment, const Eigen::Vector3d& center, double size)
  {
    Primitive_fitter fitter(m_faces[segment].size());
    for_each_face(segment, center, size, [&](Index f, const Points& corners) {
      fitter.add_face(corners, to_eigen(m_geometry.normal(f)), m_geometry.surface().area(f));
    });
    const Fitted_surface surface = fitter.fit();
    const double unit = m_geometry.unit();
    Fitted_primitive<Kernel>& result = m_descriptions[segment].primitive;
    result.type = type_of(surface.kind);
    Double_3 point = surface.point, direction = surface.direction;
    if (result.type == Primitive_type::CYLINDER)
      point = point - dot(point, direction) * direction; // next to the center
    else if (result.type == Primitive_type::CONE)
      point = surface.apex();
    else if (result.type == Primitive_type::SPHERE)
      direction = {0, 0, 0};
    result.point = to_point(unit * (center + size * to_eigen(point)));
    result.direction = to_vector(to_eigen(direction));
    result.radius = result.type == Primitive_type::CONE ? 0 : surface.radius * size * unit;
    result.half_angle = surface.angle;
    for (std::size_t i = 0; i < result.errors.size(); ++i)
      result.errors[i] = fitter.errors()[i] * size * unit;
    result.error = result.error_of(result.type);
  }

  void describe_volumes()
  {
    const double unit = m_geometry.unit();
    const std::vector<double> volumes = segment_volumes(m_segmented, m_geometry);
    double area = 0, volume = 0;
    for (Index f = 0; f < m_segmented.number_of_faces(); ++f)
      area += m_geometry.surface().area(f);
    for (double v : volumes)
      volume += v;
    for (std::size_t s = 0; s < m_descriptions.size(); ++s) {
      m_descriptions[s].volume = volumes[s] * unit * unit * unit;
      m_descriptions[s].volume_share = volume > 1e-12 * std::pow(area, 1.5) ? volumes[s] / volume
                                                                            : 0;
    }
  }

  void describe_neighbors()
  {
    struct Joint
    {
      double length = 0, weighted_deviation = 0;
    };
    std::map<std::pair<Index, Index>, Joint> joints; // of a segment with its neighbors
    const double unit = m_geometry.unit();
    for (Index h = 0; h < m_segmented.size(); ++h) {
      const Index segment = m_segmented.segment(h);
      if (segment == m_segmented.none || !m_segmented.is_on_border(h))
        continue;
      const double length = m_geometry.length(h);
      if (m_segmented.opposite[h] == m_segmented.none)
        m_descriptions[segment].boundary_length += length * unit;
      else {
        Joint& joint = joints[{segment, m_segmented.segment_across(h)}];
        joint.length += length;
        joint.weighted_deviation += length * m_geometry.signed_deviation(h);
      }
    }
    for (const auto& [segments, joint] : joints) {
      Description& d = m_descriptions[segments.first];
      const double mean = joint.length > 0 ? joint.weighted_deviation / joint.length : 0;
      d.neighbors.push_back({m_segmented.label(segments.second), joint.length * unit, mean});
      d.border_length += joint.length * unit;
    }
  }

  const Segmented_mesh<FaceGraph, Label>& m_segmented;
  const Mesh_geometry& m_geometry;
  const Grouped_items<Index> m_faces; // by segment
  std::vector<Description> m_descriptions;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H
