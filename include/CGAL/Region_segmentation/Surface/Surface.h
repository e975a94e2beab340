// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_SURFACE_H
#define CGAL_REGION_SEGMENTATION_SURFACE_SURFACE_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Large_array.h>
#include <CGAL/Region_segmentation/Support/Partition.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// A surface as arrays: all that the stages after reading know of a mesh, so that they depend
/// neither on its type nor on its being a manifold. `make_surface()` makes one from a face graph,
/// or from points and polygons.
///
/// Faces and vertices are numbered in the order of the input. Points and lengths are in units of
/// `unit()`, areas in squared ones.
///
/// Two faces are *adjacent* across
/// - an *edge*: an edge with exactly two faces, or two border edges that coincide;
/// - a *seam*: an edge where a half-edge data structure would be torn. An edge with m > 2 faces has
///   m seams, each between two faces that follow each other around it, and of half its length.
///   Neighbors that cannot be oriented consistently have one seam;
/// - a *link*: two faces of components that touch, cross or come near each other, with the length
///   of contact.
///
/// Adjacencies are sorted by their higher, then by their lower face; several between the same two
/// faces follow the boundary of the higher one from its first corner, edges first. The adjacencies
/// of a face f to lower faces are `first_adjacency(f)` to `first_adjacency(f + 1) - 1`. A stage
/// usually iterates over all adjacencies, once.
///
/// The corners of a face run counterclockwise, seen from the side to which its normal points.
/// Closed components that are inside out are turned, see `make_surface()`.
///
/// Bytes: 64 per face, 4 per side and 17 per adjacency, so 101.5 per face on a closed triangle
/// mesh; and 4 per side of a face graph that `make_surface()` reads.
class Surface
{
public:
  using Index = std::uint32_t;

  /// Properties of an adjacency.
  enum Flag : std::uint8_t {
    CONVEX = 1,      ///< (N_i x N_j) . d > 0
    CONCAVE = 2,     ///< (N_i x N_j) . d < 0
    JOINING = 4,     ///< the longest edge of a degenerate face: growing always crosses it
    CLOSED = 8,      ///< another edge of a degenerate face: has no angle, growing never crosses it
    SEAM = 16,       ///< growing never crosses it; has an angle where its two faces are oriented
                     ///< consistently
    LINK = 32,       ///< growing never crosses it; has no angle
    CONSTRAINED = 64 ///< always is a border, and is never merged across
  };
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  /// No region grows across an adjacency with one of these flags.
  static constexpr std::uint8_t barrier = SEAM | LINK | CONSTRAINED;
  static constexpr std::uint8_t without_angle = JOINING | CLOSED | LINK; ///< a seam without a sign
                                                                         ///< has no angle, either

  std::size_t number_of_faces() const { return m_first_corners.size() - 1; }
  std::size_t number_of_vertices() const { return m_points.size(); }
  std::size_t number_of_adjacencies() const { return m_higher_faces.size(); }
  /// The number of vertices that were merged with a vertex at another point, since their
  /// coordinates differ by the rounding of single precision alone; see `make_surface()`.
  std::size_t number_of_vertices_apart_by_rounding() const { return m_number_apart; }

  /// The unit of points and lengths, as a multiple of the unit of the mesh. It is 1, unless areas
  /// might exceed the range of double; then it is a power of two, so that results do not depend on
  /// it.
  double unit() const { return m_unit; }
  /// The sum of the weights of the faces, in their order.
  double area() const { return m_area; }
  /// The square root of the area of the surface; 1 if the area is 0.
  double length_unit() const { return m_area > 0 ? std::sqrt(m_area) : 1; }

  /// \name Vertices and corners
  /// @{
  const Double_3& point(std::size_t vertex) const { return m_points[vertex]; }
  /// The points of all vertices.
  const Large_array<Double_3>& points() const { return m_points; }
  /// The vertex that stands for a vertex of the input: the lowest one that was merged with it.
  Index merged_vertex(std::size_t vertex) const
  {
    return m_merged_vertices.empty() ? Index(vertex) : m_merged_vertices[vertex];
  }
  std::size_t number_of_corners(std::size_t face) const
  {
    return m_first_corners[face + 1] - m_first_corners[face];
  }
  /// The vertex at a corner of a face. The first corner is the vertex of lowest index.
  Index corner(std::size_t face, std::size_t i) const
  {
    return m_corners[m_first_corners[face] + i];
  }
  /// The vertices at the corners of a face, in order.
  Iterator_range<const Index*> corners(std::size_t face) const
  {
    return {m_corners.data() + m_first_corners[face], m_corners.data() + m_first_corners[face + 1]};
  }
  /// @}

  /// \name Faces
  /// @{

  /// The unit normal of a face, which is the zero vector if the face is degenerate.
  const Double_3& normal(std::size_t face) const { return m_normals[face]; }
  double area(std::size_t face) const { return m_areas[face]; }
  /// Whether the face belongs to a crumb: a component of less than 1/1000 of the area of the
  /// largest one, where components are linked.
  bool is_crumb(std::size_t face) const
  {
    return !m_crumbs.empty() && m_crumbs[m_component_of[face]];
  }
  /// The components: sets of faces that are connected by edges.
  const Partition& components() const { return m_component_of; }
  std::size_t number_of_components() const { return m_component_of.number_of_parts(); }
  std::size_t number_of_crumbs() const
  {
    return std::size_t(std::count(m_crumbs.begin(), m_crumbs.end(), true));
  }
  bool has_voids() const { return !m_bodies.empty(); }
  /// The component around the void that a face bounds, see `make_surface()`; `none`, if it bounds
  /// no void or components are not linked.
  Index body_around(std::size_t face) const
  {
    return m_bodies.empty() ? none : m_bodies[m_component_of[face]];
  }
  /// The area of a face; but 0 for a face of a crumb, so that crumbs do not change how the rest is
  /// segmented.
  double weight(std::size_t face) const { return is_crumb(face) ? 0 : m_areas[face]; }
  /// Whether the area of a face is so small that its normal has no meaning, see \ref
  /// RegionSegmentationSurface, or the face is a copy of a lower one.
  bool is_degenerate(std::size_t face) const
  {
    const Double_3& n = m_normals[face];
    return n.x == 0 && n.y == 0 && n.z == 0;
  }
  /// The mean of the corners of a face; its members are `x`, `y` and `z`, whatever the kernel of
  /// the mesh.
  Double_3 centroid(std::size_t face) const
  {
    Double_3 sum{};
    for (const Index v : corners(face))
      sum = sum + point(v);
    return (1.0 / double(number_of_corners(face))) * sum;
  }
  /// @}

  /// \name Adjacencies
  /// @{

  /// The adjacency across a side of a face, which leads from its i-th corner to the next one;
  /// `none` at a border. Of an edge with three and more faces each side has one of the seams.
  Index adjacency(std::size_t face, std::size_t i) const
  {
    return m_adjacencies[m_first_corners[face] + i];
  }
  /// The adjacency across the i-th halfedge of a face in its mesh, counted from `halfedge(face,
  /// mesh)`. (Sides of the surface begin at another corner, and run in the opposite direction if it
  /// has turned the face.)
  /// \pre the surface was made by `make_surface()` of a face graph
  Index adjacency_in_mesh(std::size_t face, std::size_t i) const
  {
    return m_adjacencies_in_mesh[m_first_corners[face] + i];
  }

  /// The first adjacency whose higher face is not below `face`. O(log F).
  std::size_t first_adjacency(std::size_t face) const
  {
    return std::size_t(std::lower_bound(m_higher_faces.begin(), m_higher_faces.end(), face) -
                       m_higher_faces.begin());
  }
  Index lower_face(std::size_t adjacency) const { return m_lower_faces[adjacency]; }
  Index higher_face(std::size_t adjacency) const { return m_higher_faces[adjacency]; }
  /// The length of an edge, half the length of a seam of three and more faces, or the length of
  /// contact of a link.
  double length(std::size_t adjacency) const { return std::sqrt(m_squared_lengths[adjacency]); }
  double squared_length(std::size_t adjacency) const { return m_squared_lengths[adjacency]; }
  /// The sum of the `Flag`s of an adjacency.
  std::uint8_t flags(std::size_t adjacency) const { return m_flags[adjacency]; }
  /// Whether an adjacency has one of several flags.
  bool has_flag(std::size_t adjacency, std::uint8_t any) const
  {
    return (m_flags[adjacency] & any) != 0;
  }

  /// The cosine of the deviation, N_i . N_j, in [-1, 1]; 1 where there is no angle.
  double cosine(std::size_t adjacency) const
  {
    if (!has_angle(adjacency))
      return 1;
    const double c = dot(m_normals[m_lower_faces[adjacency]], m_normals[m_higher_faces[adjacency]]);
    return (std::max)(-1.0, (std::min)(1.0, c));
  }
  /// The deviation in radians, in [0, pi]; 0 where there is no angle.
  double deviation(std::size_t adjacency) const { return std::acos(cosine(adjacency)); }

  /// The deviation if the sign is that of a concave edge, else 0.
  double concave_deviation(std::size_t adjacency) const
  {
    return has_flag(adjacency, CONCAVE) ? deviation(adjacency) : 0;
  }

  /// Whether some adjacency is a seam or a link.
  bool has_seams_or_links() const { return m_has_seams_or_links; }

  bool has_angle(std::size_t adjacency) const
  {
    const std::uint8_t f = m_flags[adjacency];
    return (f & without_angle) == 0 && !((f & SEAM) && (f & (CONVEX | CONCAVE)) == 0);
  }
  /// @}

protected:                                                       // is written by Surface_builder
  Large_array<Double_3> m_points;                                // 24 bytes a vertex
  Large_array<Index> m_first_corners = Large_array<Index>(1, 0); // 4 bytes a face, and 4 more
  Large_array<Index> m_corners;                                  // 4 bytes a corner
  Large_array<Double_3> m_normals;                               // 24 bytes a face
  Large_array<double> m_areas;                                   // 8 bytes a face
  Large_array<Index> m_lower_faces;                              // 4 bytes an adjacency
  Large_array<Index> m_higher_faces;                             // 4 bytes an adjacency
  Large_array<double> m_squared_lengths;                         // 8 bytes an adjacency
  Large_array<std::uint8_t> m_flags;                             // 1 byte an adjacency
  Large_array<Index> m_adjacencies; // 4 bytes a corner: that across the side which leaves it
  Large_array<Index> m_adjacencies_in_mesh; // the same in the order of the mesh, or empty
  std::vector<Index> m_merged_vertices; // by vertex: that which stands for it; empty: each itself
  std::size_t m_number_apart = 0;
  Partition m_component_of;    // 4 bytes a face
  std::vector<bool> m_crumbs;  // by component: whether it is a crumb; empty: none is
  std::vector<Index> m_bodies; // by component: that whose void it bounds, or `none`; empty: no
                               // voids
  double m_unit = 1, m_area = 0;
  bool m_has_seams_or_links = false;
};

namespace internal {

/// Calls `f(v, w)` for the sides of a face, which run from vertex v to vertex w, in order.
template <typename F>
void for_each_side(const Surface& surface, std::size_t face, const F& f)
{
  const auto [first, end] = surface.corners(face);
  for (const Surface::Index* corner = first; corner != end; ++corner)
    f(*corner, corner + 1 != end ? corner[1] : *first);
}

/// Calls `f(face, v, w, adjacency)` for the sides of all faces, which run from vertex v to vertex
/// w. The adjacency across a side on the border is `Surface::none`.
template <typename F>
void for_each_side_of_surface(const Surface& surface, const F& f)
{
  for (Surface::Index face = 0; face < surface.number_of_faces(); ++face) {
    std::size_t i = 0;
    for_each_side(surface, face, [&](Surface::Index v, Surface::Index w) {
      f(face, v, w, surface.adjacency(face, i++));
    });
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_SURFACE_H
