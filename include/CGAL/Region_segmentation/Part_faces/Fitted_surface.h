// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_FITTED_SURFACE_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_FITTED_SURFACE_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Partition.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

struct Kernel_of_doubles
{
  using FT = double;
  using Point_3 = Double_3;
  using Vector_3 = Double_3;
};

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// The kinds of surfaces of which machine parts are made, from the simplest on.
enum class Surface_kind { PLANE, CYLINDER, CONE, SPHERE, TORUS, FREEFORM };

/// \ingroup PkgRegionSegmentationSegments
/// What a face of a machine part is for. `BLEND`: it rounds an edge or a corner between other
/// faces, and meets most of what it borders on smoothly along it. `HOLE`: the wall of a hole, a
/// concave cylinder or cone, or a bottom that borders on walls alone. `BOSS`: the wall of a boss, a
/// convex cylinder or cone with a concave edge or blend around one end, its foot, and none around
/// the other; or a top that borders on such walls alone.
enum class Face_role { NONE, BLEND, HOLE, BOSS };

/// \ingroup PkgRegionSegmentationSegments
/// A surface that is fitted to a face or a segment. Each kind but the last is a surface of
/// revolution: with z the coordinate of a point along the axis, from `point`, and r its distance to
/// the axis, its signed distance to the surface is
/// - z for a plane,
/// - r - `radius` for a cylinder,
/// - (r - `radius`) cos `angle` - z sin `angle` for a cone, an approximation on the far side of the
///   apex,
/// - sqrt(r^2 + z^2) - `radius` for a sphere,
/// - sqrt((r - `radius`)^2 + z^2) - `minor_radius` for a torus.
///
/// \tparam Kernel has the types of `point` and `direction`: a model of `Kernel`; by
///         default `Double_3`
template <typename Kernel = internal::Kernel_of_doubles>
struct Fitted_surface
{
  Surface_kind kind = Surface_kind::FREEFORM;

  /// A point of the plane, the center of the sphere or torus, a point of the axis of the cylinder
  /// or cone.
  typename Kernel::Point_3 point{0, 0, 0};
  /// Of length 1: the normal of the plane, on the side of those of the faces; the axis of the
  /// cylinder or torus; the axis of the cone, in the direction in which it widens. Without meaning
  /// for a sphere.
  typename Kernel::Vector_3 direction{0, 0, 1};
  double radius = 0; ///< of the cylinder or sphere; of the cone at `point`; the major radius of the
                     ///< torus
  double minor_radius = 0; ///< of the tube of the torus
  double angle = 0;        ///< between axis and surface of the cone, in radians, in (0, pi/2)
  /// 1 if the normals of the faces point away from the axis (of the sphere: center; of the torus:
  /// circle in the tube), as on a shaft; -1 if they point to it, as in a hole.
  int side = 1;
  /// The largest distance of a vertex of the face to the surface.
  double deviation = 0;
  /// The least and the greatest z of the vertices of the face.
  double lowest = 0, highest = 0;

  /// Whether the surface determines its axis: a cylinder, a cone or a torus does.
  bool has_axis() const
  {
    return kind == Surface_kind::CYLINDER || kind == Surface_kind::CONE ||
           kind == Surface_kind::TORUS;
  }

  /// The apex of the cone.
  typename Kernel::Point_3 apex() const
  {
    return point - typename Kernel::FT(radius / std::tan(angle)) * direction;
  }
};

/// \ingroup PkgRegionSegmentationSegments
/// The surface with all lengths and coordinates times a factor, in the types of a kernel: from the
/// unit of a `Surface` to that of its mesh.
template <typename Kernel = internal::Kernel_of_doubles>
Fitted_surface<Kernel> scaled(const Fitted_surface<>& s, double factor)
{
  using FT = typename Kernel::FT;
  const Double_3 p = factor * s.point, d = s.direction;
  Fitted_surface<Kernel> result;
  result.kind = s.kind;
  result.point = typename Kernel::Point_3{FT(p.x), FT(p.y), FT(p.z)};
  result.direction = typename Kernel::Vector_3{FT(d.x), FT(d.y), FT(d.z)};
  result.radius = factor * s.radius;
  result.minor_radius = factor * s.minor_radius;
  result.angle = s.angle;
  result.side = s.side;
  result.deviation = factor * s.deviation;
  result.lowest = factor * s.lowest;
  result.highest = factor * s.highest;
  return result;
}

namespace internal {

inline Fitted_surface<> surface_of_kind(Surface_kind kind, const Double_3& point,
                                        const Double_3& direction)
{
  Fitted_surface<> s;
  s.kind = kind;
  s.point = point;
  s.direction = direction;
  return s;
}

/// A point in the half plane through the axis of a surface of revolution, and the direction of r in
/// space.
struct Meridian_point
{
  double r, z;
  Double_3 outward;
};

inline Meridian_point meridian_point(const Fitted_surface<>& s, const Double_3& p)
{
  const Double_3 d = p - s.point;
  const double z = dot(d, s.direction);
  const Double_3 radial = d - z * s.direction;
  const double r = norm(radial);
  return {r, z, r > 0 ? (1 / r) * radial : Double_3{0, 0, 0}};
}

/// The signed distance as a function of r and z, and its derivatives: by r and z, and by the two
/// shape parameters, which are `radius`, and `angle` or `minor_radius`.
struct Profile
{
  double value, by_r, by_z, by_radius, by_second;
};

/// The distances of many points to one surface.
class Surface_distance
{
public:
  explicit Surface_distance(const Fitted_surface<>& s)
    : m_surface(s)
    , m_cosine(std::cos(s.angle))
    , m_sine(std::sin(s.angle))
  {}

  /// Positive away from the axis.
  double operator()(const Double_3& p) const
  {
    const Meridian_point m = meridian_point(m_surface, p);
    return profile(m.r, m.z).value;
  }

  Profile profile(double r, double z) const
  {
    const Fitted_surface<>& s = m_surface;
    switch (s.kind) {
    case Surface_kind::CYLINDER:
      return {r - s.radius, 1, 0, -1, 0};
    case Surface_kind::CONE: {
      const double x = r - s.radius;
      return {x * m_cosine - z * m_sine, m_cosine, -m_sine, -m_cosine, -x * m_sine - z * m_cosine};
    }
    case Surface_kind::SPHERE: {
      const double d = std::sqrt(r * r + z * z), inverse = d > 0 ? 1 / d : 0;
      return {d - s.radius, r * inverse, z * inverse, -1, 0};
    }
    case Surface_kind::TORUS: {
      const double x = r - s.radius, d = std::sqrt(x * x + z * z), inverse = d > 0 ? 1 / d : 0;
      return {d - s.minor_radius, x * inverse, z * inverse, -x * inverse, -1};
    }
    default:
      return {z, 0, 1, 0, 0};
    }
  }

private:
  const Fitted_surface<>& m_surface;
  double m_cosine, m_sine;
};

/// The unit normal of the surface at the point of it next to `p`, on the side of those of the
/// faces.
inline Double_3 surface_normal(const Fitted_surface<>& s, const Double_3& p)
{
  const Meridian_point m = meridian_point(s, p);
  const Profile f = Surface_distance(s).profile(m.r, m.z);
  return double(s.side) * (f.by_r * m.outward + f.by_z * s.direction);
}

/// Sets the deviation and the extent of a surface to those of points.
inline void measure(Fitted_surface<>& s, const std::vector<Double_3>& points)
{
  s.deviation = 0;
  s.lowest = std::numeric_limits<double>::infinity();
  s.highest = -s.lowest;
  const Surface_distance distance(s);
  for (const Double_3& p : points) {
    const double z = dot(p - s.point, s.direction);
    s.deviation = (std::max)(s.deviation, std::fabs(distance(p)));
    s.lowest = (std::min)(s.lowest, z);
    s.highest = (std::max)(s.highest, z);
  }
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// A neighbor of a face of a machine part.
struct Part_face_neighbor
{
  std::size_t face;
  double length;  ///< of the border between them
  bool is_smooth; ///< whether their surfaces meet smoothly along most of it
};

/// \ingroup PkgRegionSegmentationSegments
/// A face of a machine part. Lengths and areas are in units of the mesh.
///
/// \tparam Kernel a model of `Kernel`: that of the points of the mesh, see `find_part_faces()`
template <typename Kernel>
struct Part_face
{
  Fitted_surface<Kernel> surface;
  Face_role role = Face_role::NONE;
  double area = 0; ///< of its facets
  /// The first face on the same surface, and the first one with the same axis; itself if no earlier
  /// one is.
  std::size_t first_on_surface = 0, first_on_axis = 0;
  std::vector<Part_face_neighbor> neighbors; ///< by face
};

/// \ingroup PkgRegionSegmentationSegments
/// The faces of a machine part: a partition of the faces of its mesh, and what is known of each
/// part. Their neighbors, and which of these they meet smoothly, are a graph:
/// `build_region_adjacency_graph<Surface_face_region_data, Surface_face_section_data>()`, filled by
/// `annotate_surface_faces()`.
struct Surface_faces
{
  Partition partition;                    ///< of the faces of the mesh
  std::vector<Fitted_surface<>> surfaces; ///< by part, in units of the surface
  std::vector<Face_role> roles;           ///< by part
  double tolerance = 0;                   ///< that was used, in units of the surface
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_FITTED_SURFACE_H
