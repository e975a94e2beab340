// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_H

#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Vector_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {

namespace internal {
class Flat_mesh_builder;
}

/// A mesh as arrays: what every stage after reading works on, so that none depends on the mesh type.
///
/// Faces are numbered in iteration order. The dual edges (one for each edge with two different faces)
/// are sorted by their higher, then by their lower face; several edges between the same two faces
/// follow the boundary of the higher one from its vertex of lowest index. Borders of the mesh have no
/// dual edge. Both faces are stored with each dual edge: a loop over the edges of every face would be as
/// short as its end is hard to predict. Bytes: 32 a face and 17 a dual edge, so 57.5 a face on a closed
/// triangle mesh; with the points 4 a face, 4 a corner and 24 a vertex more, so 85.5.
class Flat_mesh
{
public:
  using Index = std::uint32_t;

  /// What is read of a mesh: the points only where somebody needs them.
  enum class Content { ANGLES, ANGLES_AND_POINTS };

  /// What is known of a dual edge before any angle is compared.
  enum Edge_flag : std::uint8_t {
    CONVEX = 1,      ///< (N_i x N_j) . d > 0
    CONCAVE = 2,     ///< (N_i x N_j) . d < 0
    CONSTRAINED = 4, ///< always a border, never merged across
    JOINING = 8,     ///< the longest edge of a degenerate face: always a way for growing
    CLOSED = 16,     ///< another edge of a degenerate face: has no angle, never a way for growing
    NEARLY_FLAT = 32, ///< N_i . N_j > `nearly_flat`
    NOT_FLAT = 64     ///< N_i . N_j < `not_flat`
  };
  static constexpr int number_of_flags = 7;

  /// The cosines of 1 and 1.5 degrees, on both sides of the usual bound of feature edges: so most often the
  /// flags alone say which side an edge is on, and its normals are not fetched.
  static constexpr double nearly_flat = 0.99984769515639124, not_flat = 0.99965732497555726;

  std::size_t number_of_faces() const { return m_normals.size(); }
  std::size_t number_of_edges() const { return m_higher_faces.size(); }

  /// The unit normal; the zero vector for a degenerate face.
  const internal::Vector_3& normal(std::size_t face) const { return m_normals[face]; }
  /// The area, in squared units of the mesh; 0 where it overflows.
  double area(std::size_t face) const { return m_areas[face]; }
  bool is_degenerate(std::size_t face) const
  {
    const internal::Vector_3& n = m_normals[face];
    return n.x == 0 && n.y == 0 && n.z == 0;
  }

  /// The first dual edge whose higher face is not below `face`. O(log F).
  std::size_t first_edge(std::size_t face) const
  {
    return std::size_t(std::lower_bound(m_higher_faces.begin(), m_higher_faces.end(), face) - m_higher_faces.begin());
  }

  Index lower_face(std::size_t edge) const { return m_lower_faces[edge]; }
  Index higher_face(std::size_t edge) const { return m_higher_faces[edge]; }
  /// The length of the mesh edge, in units of the mesh.
  double length(std::size_t edge) const
  {
    const double square = m_squared_lengths[edge];
    return square >= 0 ? std::sqrt(square) : -square;
  }
  std::uint8_t flags(std::size_t edge) const { return m_flags[edge]; }
  bool has_flag(std::size_t edge, std::uint8_t any) const { return (m_flags[edge] & any) != 0; }

  /// The cosine of the deviation, N_i . N_j, in [-1, 1]; 1 beside a degenerate face.
  double cosine(std::size_t lower, std::size_t edge) const
  {
    if (has_flag(edge, JOINING | CLOSED))
      return 1;
    const double c = internal::dot(m_normals[lower], m_normals[m_higher_faces[edge]]);
    return (std::max)(-1.0, (std::min)(1.0, c));
  }

  /// The deviation of an edge in radians, in [0, pi].
  double deviation(std::size_t lower, std::size_t edge) const
  {
    return std::acos(cosine(lower, edge));
  }

  /// \name Points
  /// With `Content::ANGLES_AND_POINTS` alone.
  /// @{
  std::size_t number_of_points() const { return m_points.size(); }
  std::size_t number_of_corners(std::size_t face) const
  {
    return m_first_corners[face + 1] - m_first_corners[face];
  }
  /// The vertex at a corner of a face; that of lowest index is the first.
  Index corner(std::size_t face, std::size_t i) const
  {
    return m_corners[m_first_corners[face] + i];
  }
  const internal::Vector_3& point(std::size_t vertex) const { return m_points[vertex]; }
  /// The mean of the corners of a face.
  internal::Vector_3 centroid(std::size_t face) const
  {
    internal::Vector_3 sum{};
    for (Index c = m_first_corners[face]; c < m_first_corners[face + 1]; ++c)
      sum = sum + m_points[m_corners[c]];
    return (1.0 / double(number_of_corners(face))) * sum;
  }
  /// @}

private:
  friend class internal::Flat_mesh_builder;

  internal::Large_array<internal::Vector_3> m_normals;   // 24 bytes a face
  internal::Large_array<double> m_areas;                 // 8 bytes a face
  internal::Large_array<Index> m_lower_faces;            // 4 bytes a dual edge
  internal::Large_array<Index> m_higher_faces;           // 4 bytes a dual edge
  internal::Large_array<double> m_squared_lengths;       // 8 bytes a dual edge; less 0: the length, negated
  internal::Large_array<std::uint8_t> m_flags;           // 1 byte a dual edge
  internal::Large_array<internal::Vector_3> m_points;    // 24 bytes a vertex
  internal::Large_array<Index> m_first_corners;          // 4 bytes a face, and one more at the end
  internal::Large_array<Index> m_corners;                // 4 bytes a corner
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FLAT_MESH_H
