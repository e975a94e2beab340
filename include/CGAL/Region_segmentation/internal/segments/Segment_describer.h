// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Segments/Segment_description.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/part_faces/fit_surface.h>
#include <CGAL/Region_segmentation/internal/segments/Segment_caps.h>
#include <CGAL/Region_segmentation/internal/segments/Segment_fitter.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The volume of each segment with its caps, and at the end that of the faces without a segment.
/// They add up to the volume of the mesh.
///
/// By the divergence theorem, as the sum of the tetrahedra from a point of the segment to its
/// triangles.
inline std::vector<double> segment_volumes(const Segmented_halfedges& mesh, const Surface& surface)
{
  using Index = Halfedge_table::Index;
  std::vector<Double_3> points;
  for (Index v = 0; v < mesh.number_of_vertices; ++v)
    points.push_back(surface.point(v));
  const Segment_caps caps(mesh, std::move(points),
                          [&](Index f) { return is_turned(mesh, surface, f); });
  std::vector<double> volumes(mesh.number_of_segments + 1, 0);
  std::vector<Index> origins(volumes.size(), Halfedge_table::none); // vertices
  const auto add = [&](std::size_t segment, const std::array<Index, 3>& corners, int orientation) {
    const Double_3 origin = caps.points()[origins[segment]];
    const Double_3 a = caps.points()[corners[0]] - origin, b = caps.points()[corners[1]] - origin,
                   c = caps.points()[corners[2]] - origin;
    volumes[segment] += orientation * dot(a, cross(b, c)) / 6;
  };
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    const Index first = mesh.source[mesh.first[f]];
    const std::size_t segment = caps.numbered(mesh.segment_of_face[f]);
    if (origins[segment] == mesh.none)
      origins[segment] = first;
    for (Index h = mesh.first[f] + 2; h < mesh.first[f + 1]; ++h)
      add(segment, {first, mesh.source[h - 1], mesh.source[h]},
          is_turned(mesh, surface, f) ? -1 : 1);
  }
  for (const Cap_triangle& t : caps.triangles()) {
    add(t.lower, t.corners, 1);
    if (t.higher < volumes.size()) // not beyond the border of the mesh
      add(t.higher, t.corners, -1);
  }
  return volumes;
}

/// Describes the segments of a mesh.
///
/// \tparam Kernel that of the results
template <typename FaceGraph, typename Label, typename Kernel>
class Segment_describer
{
  using Index = Halfedge_table::Index;

public:
  using Description = Segment_description<Label, Kernel>;

  Segment_describer(const Segmented_mesh<FaceGraph, Label>& segmented, const Surface& surface)
    : m_segmented(segmented)
    , m_surface(surface)
    , m_faces(segmented.faces_of_segments())
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
      for (Index h = m_segmented.first[face]; h < m_segmented.first[face + 1]; ++h)
        corners.push_back(factor * (m_surface.point(m_segmented.source[h]) - origin));
      f(face, corners);
    }
  }

  /// Area, centroid, axes, extents and surface.
  void describe_shape(std::size_t segment)
  {
    const Index first_face = *m_faces[segment].begin();
    // Relative to a point nearby, so that nothing cancels far from the origin.
    const Double_3 origin = m_surface.point(m_segmented.source[m_segmented.first[first_face]]);
    Second_moments moments;
    for_each_face(segment, origin, 1, [&](Index, const Points& p) { add_moments(p, moments); });
    const double area = moments.weight, unit = m_surface.unit();
    const Double_3 center = origin + moments.centroid();
    Description& d = m_descriptions[segment];
    d.segment = m_segmented.labels[segment];
    d.number_of_faces = m_faces[segment].size();
    d.area = area * unit * unit; // one by one: the square of the unit may be infinite, the area 0
    d.centroid = CGAL::ORIGIN + to_vector(unit * center);
    describe_extents(segment, center, principal_axes(moments.covariance()));
    fit_surface(segment, center, area);
  }

  /// Of the triangles of a fan, each with its area as seen along the normal, so that a face may be
  /// concave. The integral of x x^T over a triangle a, b, c of area A is
  /// A / 12 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
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
    std::swap(axes[0], axes[2]); // now from the largest to the smallest
    for (Double_3& a : axes) {
      const double x = std::fabs(a.x), y = std::fabs(a.y), z = std::fabs(a.z);
      if ((x >= y && x >= z ? a.x : y >= z ? a.y : a.z) < 0)
        a = -1.0 * a;
    }
    axes[2] = cross(axes[0], axes[1]);
    return axes;
  }

  void describe_extents(std::size_t segment, const Double_3& center,
                        const std::array<Double_3, 3>& axes)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> lowest{infinity, infinity, infinity},
      highest{-infinity, -infinity, -infinity};
    for_each_face(segment, center, 1, [&](Index, const Points& corners) {
      for (const Double_3& p : corners)
        for (std::size_t i = 0; i < 3; ++i) {
          lowest[i] = (std::min)(lowest[i], dot(axes[i], p));
          highest[i] = (std::max)(highest[i], dot(axes[i], p));
        }
    });
    for (std::size_t i = 0; i < 3; ++i) {
      m_descriptions[segment].axes[i] = to_vector(axes[i]);
      m_descriptions[segment].extents[i] = (highest[i] - lowest[i]) * m_surface.unit();
    }
  }

  void fit_surface(std::size_t segment, const Double_3& center, double area)
  {
    const double size = area > 0 ? std::sqrt(area) : 1, unit = m_surface.unit();
    Segment_fitter fitter(m_faces[segment].size());
    for_each_face(segment, center, 1 / size, [&](Index f, const Points& corners) {
      fitter.add_face(corners, m_surface.normal(f), area > 0 ? m_surface.area(f) : 1);
    });
    Description& d = m_descriptions[segment];
    Fitted_surface<> surface = fitter.fit(d.surface_errors);
    surface.point = surface.point + 1 / size * center;
    double outwards = 0;
    for (Index f : m_faces[segment])
      outwards += m_surface.area(f) *
                  dot(m_surface.normal(f),
                      surface_normal(surface, 1 / size * m_surface.centroid(f)));
    surface.side = outwards < 0 ? -1 : 1;
    d.surface = scaled<Kernel>(surface, size * unit);
    for (double& error : d.surface_errors)
      error *= size * unit;
  }

  void describe_volumes()
  {
    const double unit = m_surface.unit();
    const std::vector<double> volumes = segment_volumes(m_segmented, m_surface);
    double area = 0, volume = 0;
    for (Index f = 0; f < m_segmented.number_of_faces(); ++f)
      area += m_surface.area(f);
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
    const double unit = m_surface.unit();
    for (Index h = 0; h < m_segmented.size(); ++h) {
      const Index segment = m_segmented.segment(h);
      if (segment == m_segmented.none || !m_segmented.is_on_border(h))
        continue;
      const double length = norm(direction(m_segmented, m_surface, h));
      if (m_segmented.opposite[h] == m_segmented.none)
        m_descriptions[segment].boundary_length += length * unit;
      else {
        Joint& joint = joints[{segment, m_segmented.segment_across(h)}];
        joint.length += length;
        joint.weighted_deviation += length * signed_deviation(m_segmented, m_surface, h);
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
  const Surface& m_surface;
  const Grouped_items<Index> m_faces; // by segment
  std::vector<Description> m_descriptions;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_DESCRIBER_H
