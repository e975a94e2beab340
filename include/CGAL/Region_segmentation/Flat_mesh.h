// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_FLAT_MESH_H
#define CGAL_REGION_SEGMENTATION_FLAT_MESH_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Mesh_data.h>
#include <CGAL/Region_segmentation/Mesh_patches.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Region_segmentation {

namespace internal {
class Flat_mesh_builder;
}

/// \ingroup PkgRegionSegmentationData
/// The points of the vertices of a mesh, and the corners of its faces.
///
/// Bytes: 4 per face, 4 per corner and 24 per vertex, so 28 per face on a closed triangle mesh.
class Mesh_points
{
public:
  using Index = std::uint32_t;

  std::size_t number_of_points() const { return m_points.size(); }
  std::size_t number_of_corners(std::size_t face) const
  {
    return m_first_corners[face + 1] - m_first_corners[face];
  }
  /// The vertex at a corner of a face. The first corner is the vertex of lowest index.
  Index corner(std::size_t face, std::size_t i) const { return m_corners[m_first_corners[face] + i]; }
  /// The point of a vertex, in units of `Flat_mesh::unit()`.
  const Double_3& operator[](std::size_t vertex) const { return m_points[vertex]; }
  /// The mean of the corners of a face.
  Double_3 centroid(std::size_t face) const
  {
    const std::size_t n = number_of_corners(face);
    Double_3 sum{};
    for (std::size_t i = 0; i < n; ++i)
      sum = sum + m_points[corner(face, i)];
    return (1.0 / double(n)) * sum;
  }

private:
  friend class internal::Flat_mesh_builder;

  internal::Large_array<Double_3> m_points;     // 24 bytes a vertex
  internal::Large_array<Index> m_first_corners; // 4 bytes a face, and one more at the end
  internal::Large_array<Index> m_corners;       // 4 bytes a corner
};

/// \ingroup PkgRegionSegmentationData
/// A mesh as arrays. All stages after reading work on it, so that they do not depend on the mesh type.
///
/// Faces and vertices are numbered in iteration order. The dual edges (one for each edge with two different faces) are
/// sorted by their higher, then by their lower face; several edges between the same two faces follow the boundary of
/// the higher one from its vertex of lowest index. Borders of the mesh have no dual edge. Both faces are stored with
/// each dual edge: nested loops over the few edges of each face would mispredict their branches.
///
/// Points and lengths are in units of `unit()`, areas in squared ones. It is 1, unless areas might exceed the range of double;
/// then it is a power of two, so that results do not depend on it.
///
/// The dual edges of a face to lower faces are `first_edge(f)` to `first_edge(f + 1) - 1`. A part usually iterates over all
/// dual edges, once; one that needs all neighbors of a face collects them in such a pass, from `lower_face()` and
/// `higher_face()`.
///
/// A closed component whose signed volume is below 0 is inside out: its faces are turned. Without `Mesh_data::PATCHES`, for
/// speed, components are looked at only if the surface as a whole is closed and its signed volume is below 0. Open
/// components are read as they are.
///
/// Bytes: 32 per face and 17 per dual edge, so 57.5 per face on a closed triangle mesh; 28 per face more with the points and 24
/// with the centroids, which with `Mesh_data::PATCHES` are computed from the points above 1,572,864 faces.
class Flat_mesh
{
public:
  using Index = std::uint32_t;

  /// Properties of a dual edge that are known before any angle is compared.
  enum Edge_flag : std::uint8_t {
    CONVEX = 1,      ///< (N_i x N_j) . d > 0
    CONCAVE = 2,     ///< (N_i x N_j) . d < 0
    CONSTRAINED = 4, ///< always a border, never merged across
    JOINING = 8,     ///< the longest edge of a degenerate face: growing always crosses it
    CLOSED = 16,     ///< another edge of a degenerate face: has no angle, growing never crosses it
    NEARLY_FLAT = 32, ///< N_i . N_j > `nearly_flat`
    NOT_FLAT = 64     ///< N_i . N_j < `not_flat`
  };
  static constexpr int number_of_flags = 7;

  /// The cosines of 1 and 1.5 degrees, which enclose the usual bound of feature edges: for most edges the flags alone
  /// decide the comparison, and no normals are fetched.
  static constexpr double nearly_flat = 0.99984769515639124, not_flat = 0.99965732497555726;

  std::size_t number_of_faces() const { return m_normals.size(); }
  /// Of dual edges: they have the indices below it.
  std::size_t number_of_edges() const { return m_higher_faces.size(); }

  /// The unit of points and lengths, as a multiple of that of the mesh.
  double unit() const { return m_unit; }

  /// \name Faces
  /// @{

  /// The unit normal; the zero vector for a degenerate face.
  const Double_3& normal(std::size_t face) const { return m_normals[face]; }
  /// In squared units of `unit()`.
  double area(std::size_t face) const { return m_areas[face]; }
  /// Whether the area is so small that the normal has no meaning, see \ref RegionSegmentationTwoStep.
  bool is_degenerate(std::size_t face) const
  {
    const Double_3& n = m_normals[face];
    return n.x == 0 && n.y == 0 && n.z == 0;
  }
  /// @}

  /// \name Dual edges
  /// @{

  /// The first dual edge whose higher face is not below `face`. O(log F).
  std::size_t first_edge(std::size_t face) const
  {
    return std::size_t(std::lower_bound(m_higher_faces.begin(), m_higher_faces.end(), face) - m_higher_faces.begin());
  }

  Index lower_face(std::size_t edge) const { return m_lower_faces[edge]; }
  Index higher_face(std::size_t edge) const { return m_higher_faces[edge]; }
  /// The length of the mesh edge, in units of `unit()`.
  double length(std::size_t edge) const { return std::sqrt(m_squared_lengths[edge]); }
  /// The sum of the `Edge_flag`s of an edge.
  std::uint8_t flags(std::size_t edge) const { return m_flags[edge]; }
  /// Whether an edge has one of several flags.
  bool has_flag(std::size_t edge, std::uint8_t any) const { return (m_flags[edge] & any) != 0; }

  /// The cosine of the deviation, N_i . N_j, in [-1, 1]; 1 beside a degenerate face. `lower` is `lower_face(edge)`.
  double cosine(std::size_t lower, std::size_t edge) const
  {
    if (has_flag(edge, JOINING | CLOSED))
      return 1;
    const double c = dot(m_normals[lower], m_normals[m_higher_faces[edge]]);
    return (std::max)(-1.0, (std::min)(1.0, c));
  }

  /// The deviation of an edge in radians, in [0, pi]. `lower` is `lower_face(edge)`.
  double deviation(std::size_t lower, std::size_t edge) const
  {
    return std::acos(cosine(lower, edge));
  }

  /// Makes an edge a border that is never merged across.
  void constrain(std::size_t edge) { m_flags[edge] |= CONSTRAINED; }
  /// Undoes `constrain()`.
  void release(std::size_t edge) { m_flags[edge] &= std::uint8_t(~CONSTRAINED); }
  /// @}

  /// \name Data that must be requested
  /// \throws Invalid_method if the mesh was read without them
  /// @{
  Mesh_data data() const { return m_data; }

  /// `Mesh_data::POINTS`
  const Mesh_points& points() const
  {
    require(Mesh_data::POINTS, "POINTS");
    return m_points;
  }

  /// The mean of the corners of a face, in units of `unit()`. `Mesh_data::CENTROIDS`
  Double_3 centroid(std::size_t face) const
  {
    require(Mesh_data::CENTROIDS, "CENTROIDS");
    return m_centroids.empty() ? m_points.centroid(face) : m_centroids[face];
  }

  /// The sum of the areas of the faces, in their order, in squared units of `unit()`. `Mesh_data::SURFACE_AREA`
  double surface_area() const
  {
    require(Mesh_data::SURFACE_AREA, "SURFACE_AREA");
    return m_surface_area;
  }

  /// The square root of the area of the surface, in units of `unit()`; 1 if that is 0. `Mesh_data::SURFACE_AREA`
  double relative_unit() const
  {
    const double area = surface_area();
    return area > 0 ? std::sqrt(area) : 1;
  }

  /// Small patches of faces, which respect the constraints that the mesh was read with. `Mesh_data::PATCHES`
  const Mesh_patches& patches() const
  {
    require(Mesh_data::PATCHES, "PATCHES");
    return m_patches;
  }
  /// @}

private:
  friend class internal::Flat_mesh_builder;

  void require(Mesh_data wanted, const char* name) const
  {
    if (!includes(m_data, wanted))
      throw_missing(name);
  }

  [[noreturn]] static void throw_missing(const char* name)
  {
    throw Invalid_method(std::string("a part of the method reads data of the mesh that it did not ask for: its "
                                     "required_mesh_data lacks Mesh_data::") +
                         name);
  }

  internal::Large_array<Double_3> m_normals;         // 24 bytes a face
  internal::Large_array<double> m_areas;             // 8 bytes a face
  internal::Large_array<Index> m_lower_faces;        // 4 bytes a dual edge
  internal::Large_array<Index> m_higher_faces;       // 4 bytes a dual edge
  internal::Large_array<double> m_squared_lengths;   // 8 bytes a dual edge
  internal::Large_array<std::uint8_t> m_flags;       // 1 byte a dual edge
  internal::Large_array<Double_3> m_centroids;       // 24 bytes a face; empty: computed from the points
  Mesh_points m_points;
  Mesh_patches m_patches;
  double m_unit = 1, m_surface_area = 0;
  Mesh_data m_data = Mesh_data::NOTHING_MORE;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_FLAT_MESH_H
