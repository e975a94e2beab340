// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SURFACE_BUILDER_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SURFACE_BUILDER_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Large_array.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Mesh_order.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An adjacency that is added to those across edges.
struct Added_adjacency
{
  Surface::Index lower, higher; ///< faces
  double squared_length;
  std::uint8_t flags;
  Surface::Index face = Surface::none; ///< the face whose side between `v` and `w` has it, if any
  Surface::Index v = 0, w = 0;         ///< vertices
};

/// Two vertices.
using Vertex_pair = std::pair<Surface::Index, Surface::Index>;

/// A point of any kernel, or of any type with `operator[]` for its coordinates, in doubles.
template <typename Point>
Double_3 to_double_3(const Point& p)
{
  return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
}

/// A void is bounded by a closed component of negative volume. Its *body* is the innermost closed
/// component around it, which has a positive volume.
struct Voids
{
  Face_tree tree; ///< of the surface
  /// By component the body whose void it bounds; `Surface::none`, if it bounds none.
  std::vector<Surface::Index> bodies;
};

/// A surface while it is made. It owns the arrays until `finish()`. Its phases are the member
/// functions, which `build_surface()` calls.
///
/// A *side* of a face leads from one of its corners to the next one, and has the index of that
/// corner. A side is *open* if the face across it is not known.
class Surface_builder : public Surface
{
public:
  static constexpr Index at_seam = none - 1;
  static bool is_face(Index neighbor) { return neighbor < at_seam; }

  Surface_builder() = default;
  /// Begins with a surface whose points or constraints are to be changed.
  explicit Surface_builder(Surface surface)
    : Surface(std::move(surface))
  {}

  /// \name Reading
  /// @{

  /// Lets the finished surface know the adjacencies by the sides of the mesh that is read.
  void keep_sides_of_mesh() { m_keeps_sides_of_mesh = true; }

  /// Reads the points of the vertices, the corners of the faces and the faces across their sides. A
  /// vertex point map may return points by value.
  template <typename FaceGraph, typename Pack>
  void read_face_graph(const Mesh_order<FaceGraph, Pack>& order, const Pack& np,
                       const Execution& execution)
  {
    const auto point_map = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
      get_const_property_map(vertex_point, order.mesh()));
    m_points.resize(order.number_of_vertices());
    for_each_index(execution, m_points.size(), [&](std::size_t i) {
      m_points[i] = to_double_3(get(point_map, order.ordered_vertices()[i]));
    });
    read_corners(order, execution);
    set_unit();
  }

  /// Reads points and the corners of polygons. All sides are open.
  /// \throws Invalid_input if a polygon has no corner or one that is not a point, or a point is not
  ///         finite
  template <typename PointRange, typename PolygonRange>
  void read_polygons(const PointRange& points, const PolygonRange& polygons,
                     const Execution& execution)
  {
    const auto size = std::size_t(std::distance(std::begin(polygons), std::end(polygons)));
    m_points.reserve(std::size_t(std::distance(std::begin(points), std::end(points))));
    m_first_corners.reserve(size + 1);
    m_corners.reserve(3 * size); // enough for triangles
    for (const auto& p : points)
      m_points.push_back(to_double_3(p));
    for (const auto& polygon : polygons)
      read_polygon(polygon);
    m_neighbors.assign(m_corners.size(), none);
    begin_at_lowest_vertices(execution);
    set_unit();
  }
  /// @}

  bool has_open_sides() const
  {
    return std::find(m_neighbors.begin(), m_neighbors.end(), none) != m_neighbors.end();
  }

  /// \name Sewing of open sides, in open_sides.h and sew_sides.h
  /// @{
  void merge_vertices_of_open_sides();
  void separate_doubled_faces();
  void match_open_sides();
  /// @}

  /// Turns faces so that neighbors across edges run in opposite directions along them, in
  /// orient_faces.h.
  void orient_faces();

  /// \name Normals and adjacencies, in collect_adjacencies.h
  /// @{
  void compute_normals(const Execution& execution);
  void collect_adjacencies(const Execution& execution);
  void insert_adjacencies(const std::vector<Added_adjacency>& added);
  void set_signs();
  void mark_constraints(std::vector<Vertex_pair> pairs);
  void join_degenerate_faces();
  std::vector<Index> remove_faces(const std::vector<bool>& is_removed);
  /// @}

  /// Turns closed components that are inside out, in orient_faces.h. Returns the voids, if some
  /// component had a negative volume.
  std::optional<Voids> orient_components();

  /// Links the faces of voids with the bodies around them, in voids.h.
  void link_voids(const Voids& voids, const Execution& execution);

  /// Links components and marks crumbs, in find_links.h.
  void link_components(const Execution& execution);

  /// The points, until others are set.
  Large_array<Double_3> take_points() { return std::move(m_points); }

  /// Moves the vertices to other points. Normals, areas and signs of angles follow them; lengths
  /// and links stay. A degenerate face stays degenerate, with its area.
  void set_points(Large_array<Double_3> points, const Execution& execution)
  {
    std::vector<std::pair<std::size_t, double>> degenerate; // faces and their areas
    for (std::size_t f = 0; f < number_of_faces(); ++f)
      if (is_degenerate(f))
        degenerate.push_back({f, m_areas[f]});
    m_points = std::move(points);
    compute_normals(execution);
    for (const auto& [face, area] : degenerate) {
      m_normals[face] = {0, 0, 0};
      m_areas[face] = area;
    }
    set_signs();
  }

  /// The surface. The builder is empty afterwards.
  Surface finish()
  {
    join_degenerate_faces();
    m_area = 0;
    for (std::size_t f = 0; f < number_of_faces(); ++f)
      m_area += weight(f);
    for (std::size_t f = 0; f < number_of_faces() && !m_places_in_mesh.empty(); ++f)
      for (Index side = m_first_corners[f]; side < m_first_corners[f + 1]; ++side)
        m_adjacencies_in_mesh[m_first_corners[f] + m_places_in_mesh[side]] = m_adjacencies[side];
    return std::move(static_cast<Surface&>(*this));
  }

private:
  class Side_matcher;

  template <typename FaceGraph, typename Pack>
  void read_corners(const Mesh_order<FaceGraph, Pack>& order, const Execution& execution)
  {
    const FaceGraph& mesh = order.mesh();
    m_first_corners.resize(order.number_of_faces() + 1);
    m_corners.resize(num_halfedges(mesh));
    m_neighbors.resize(num_halfedges(mesh));
    const auto halfedges_of = [&](std::size_t face) {
      return CGAL::halfedges_around_face(halfedge(order.ordered_faces()[face], mesh), mesh);
    };
    const std::size_t number = for_each_block_of_output(
      execution, order.number_of_faces(),
      [&](std::size_t, std::size_t begin, std::size_t end) {
        std::size_t result = 0;
        for (std::size_t f = begin; f < end; ++f)
          result += halfedges_of(f).size();
        return result;
      },
      [&](std::size_t, std::size_t begin, std::size_t end, std::size_t corner) {
        for (std::size_t f = begin; f < end; ++f) {
          m_first_corners[f] = Index(corner);
          for (auto h : halfedges_of(f)) {
            m_corners[corner] = order.vertex_rank(source(h, mesh));
            m_neighbors[corner++] = order.face_rank(opposite(h, mesh));
          }
        }
        return corner;
      });
    m_first_corners.back() = Index(number);
    m_corners.resize(number);
    m_neighbors.resize(number);
    // A loop of its own: the search for the lowest vertex, whose branches are random, would make
    // the loop above wait for memory.
    begin_at_lowest_vertices(execution);
  }

  template <typename Polygon>
  void read_polygon(const Polygon& polygon)
  {
    const auto place = [&] { return "polygon " + std::to_string(number_of_faces()); };
    for (const auto& v : polygon) {
      static_assert(std::is_integral<std::decay_t<decltype(v)>>::value,
                    "polygons are ranges of indices of points: of an integral type");
      if (!(v >= 0 && std::size_t(v) < m_points.size()))
        throw Invalid_input(place() + " has a corner " + std::to_string(v) + ", but there are " +
                            std::to_string(m_points.size()) + " points");
      m_corners.push_back(Index(v));
    }
    if (m_corners.size() == m_first_corners.back())
      throw Invalid_input(place() + " has no corners");
    if (m_corners.size() >= none)
      throw Invalid_input("the polygons have fewer than 2^32 - 1 corners");
    m_first_corners.push_back(Index(m_corners.size()));
  }

  /// Lets the boundary of each face begin at its vertex of lowest index.
  void begin_at_lowest_vertices(const Execution& execution)
  {
    if (m_keeps_sides_of_mesh && m_places_in_mesh.empty()) {
      m_adjacencies_in_mesh.resize(m_corners.size());
      for (std::size_t f = 0; f < number_of_faces(); ++f)
        for (std::size_t i = 0; i < number_of_corners(f); ++i)
          m_places_in_mesh.push_back(Index(i));
    }
    for_each_index(execution, number_of_faces(), [&](std::size_t f) {
      const auto first = m_corners.begin() + m_first_corners[f],
                 past = m_corners.begin() + m_first_corners[f + 1],
                 lowest = std::min_element(first, past);
      const auto from = first - m_corners.begin(), to = past - m_corners.begin(),
                 middle = lowest - m_corners.begin();
      std::rotate(first, lowest, past);
      std::rotate(m_neighbors.begin() + from, m_neighbors.begin() + middle,
                  m_neighbors.begin() + to);
      if (m_keeps_sides_of_mesh)
        std::rotate(m_places_in_mesh.begin() + from, m_places_in_mesh.begin() + middle,
                    m_places_in_mesh.begin() + to);
    });
  }

  /// Chooses the unit of the points, and scales them. A point that no face uses becomes the origin.
  /// \throws Invalid_input if a point of a face is not finite
  void set_unit()
  {
    std::vector<bool> is_used(m_points.size());
    for (const Index v : m_corners)
      is_used[v] = true;
    double largest = 0;
    for (std::size_t v = 0; v < m_points.size(); ++v) {
      Double_3& p = m_points[v];
      if (!is_used[v])
        p = {0, 0, 0};
      if (!is_finite(p))
        throw Invalid_input("the point of vertex " + std::to_string(v) + " is not finite");
      largest = (std::max)({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    m_unit = unit_of_coordinates(largest);
    if (m_unit != 1)
      for (Double_3& p : m_points)
        p = (1 / m_unit) * p;
    m_largest_coordinate = largest / m_unit;
  }

  /// Reverses the boundary of a face, which still begins at its vertex of lowest index.
  void turn_face(std::size_t face)
  {
    const auto first = std::ptrdiff_t(m_first_corners[face]),
               past = std::ptrdiff_t(m_first_corners[face + 1]);
    m_normals[face] = -1.0 * m_normals[face];
    std::reverse(m_corners.begin() + first + 1, m_corners.begin() + past);
    for (Large_array<Index>* by_side : {&m_neighbors, &m_adjacencies, &m_places_in_mesh})
      if (!by_side->empty())
        std::reverse(by_side->begin() + first, by_side->begin() + past);
  }

  /// The corner of a face that follows another one around it.
  Index next_corner(std::size_t face, std::size_t corner) const
  {
    return Index(corner + 1 == m_first_corners[face + 1] ? m_first_corners[face] : corner + 1);
  }

  /// The side of the neighbor across a side of a face.
  /// \pre there is a neighbor
  Index side_across(Index face, Index side) const
  {
    const Index neighbor = m_neighbors[side], v = m_corners[side],
                w = m_corners[next_corner(face, side)];
    Index s = m_first_corners[neighbor];
    for (; s < m_first_corners[neighbor + 1]; ++s) {
      const Index from = m_corners[s], to = m_corners[next_corner(neighbor, s)];
      if (m_neighbors[s] == face && ((from == w && to == v) || (from == v && to == w)))
        break;
    }
    return s;
  }

  /// The corner from which the side of a face between two vertices leaves, in either direction;
  /// `none` if there is no such side. O(n) for n corners.
  Index side_between(Index face, Index v, Index w) const
  {
    Index side = m_first_corners[face], result = none;
    for_each_side(*this, face, [&](Index from, Index to) {
      result = std::minmax(from, to) == std::minmax(v, w) ? side : result;
      ++side;
    });
    return result;
  }

  /// Whether two faces are on the same points, as faces of two bodies that touch.
  bool are_twins(Index f, Index g) const
  {
    const auto twin = m_twins.find(f);
    return twin != m_twins.end() && twin->second == g;
  }

  template <typename F>
  void for_each_open_edge(const F& f) const;
  std::vector<double> shortest_open_sides() const;
  std::vector<bool> sides_between_bodies() const;
  void separate_from_neighbors(Index face);
  Added_adjacency seam_between(Index f, Index g, Index v, Index w, double share) const;
  void resize_adjacencies(std::size_t size);
  void collect_edges(const Execution& execution);
  void set_sides(const std::vector<Added_adjacency>& added, const Index* places);

  /// By side: the face across it; `none`, if the side is open; or `at_seam`. Empty after the
  /// adjacencies are collected.
  Large_array<Index> m_neighbors;
  std::vector<bool> m_is_parallel;      // by side: whether that of its neighbor runs alike
  std::vector<Added_adjacency> m_added; // seams, and adjacencies of doubled faces
  Large_array<Index> m_places_in_mesh; // by side: its place among those that the mesh has; or empty
  std::map<Index, Index> m_twins;
  double m_largest_coordinate = 0;
  bool m_keeps_sides_of_mesh = false;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SURFACE_BUILDER_H
