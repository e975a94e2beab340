// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_READ_SURFACE_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_READ_SURFACE_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A surface as it is read: its points and corners, and the face across each side, as far as this
/// is known.
///
/// A *side* of a face leads from one of its corners to the next one, and has the index of that
/// corner.
struct Raw_surface
{
  using Index = Surface::Index;
  static constexpr Index none = Surface::none, at_seam = none - 1;

  Surface surface;
  /// By side: the face across it, or `none`, if the side is at a border or its face is not known,
  /// or `at_seam`.
  Large_array<Index> neighbors;

  static bool is_face(Index neighbor) { return neighbor < at_seam; }
};

/// Lets the boundary of each face begin at its vertex of lowest index.
inline void begin_at_lowest_vertices(Raw_surface& raw, const Execution& execution)
{
  Surface_arrays& arrays = arrays_of(raw.surface);
  for_each_index(execution, arrays.first_corners.size() - 1, [&](std::size_t f) {
    const std::size_t first = arrays.first_corners[f], past = arrays.first_corners[f + 1];
    Surface::Index *const corners = arrays.corners.data(), *const neighbors = raw.neighbors.data();
    const auto lowest = std::min_element(corners + first, corners + past) - corners;
    std::rotate(corners + first, corners + lowest, corners + past);
    std::rotate(neighbors + first, neighbors + lowest, neighbors + past);
  });
}

/// A point of any kernel, or of any type with `operator[]` for its coordinates, in doubles.
template <typename Point>
Double_3 to_double_3(const Point& p)
{
  return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
}

/// The corner of a face that follows another one around it.
inline Surface::Index next_corner(const Surface_arrays& arrays, std::size_t face,
                                  std::size_t corner)
{
  return Surface::Index(corner + 1 == arrays.first_corners[face + 1] ? arrays.first_corners[face]
                                                                     : corner + 1);
}

/// The side of the neighbor across a side of a face.
/// \pre there is a neighbor
inline Surface::Index side_across(const Raw_surface& raw, Surface::Index face, Surface::Index side)
{
  const Surface_arrays& arrays = arrays_of(raw.surface);
  const Surface::Index neighbor = raw.neighbors[side], v = arrays.corners[side],
                       w = arrays.corners[next_corner(arrays, face, side)];
  Surface::Index s = arrays.first_corners[neighbor];
  for (; s < arrays.first_corners[neighbor + 1]; ++s) {
    const Surface::Index from = arrays.corners[s],
                         to = arrays.corners[next_corner(arrays, neighbor, s)];
    if (raw.neighbors[s] == face && ((from == w && to == v) || (from == v && to == w)))
      break;
  }
  return s;
}

/// Chooses the unit of the points, and scales them. A point that no face uses becomes the origin.
/// \throws Invalid_input if a point of a face is not finite
inline void set_unit(Surface& surface)
{
  Surface_arrays& arrays = arrays_of(surface);
  std::vector<bool> is_used(arrays.points.size());
  for (const Surface::Index v : arrays.corners)
    is_used[v] = true;
  double largest = 0;
  for (std::size_t v = 0; v < arrays.points.size(); ++v) {
    Double_3& p = arrays.points[v];
    if (!is_used[v])
      p = {0, 0, 0};
    if (!is_finite(p))
      throw Invalid_input("the point of vertex " + std::to_string(v) + " is not finite");
    largest = (std::max)({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  arrays.unit = unit_of_coordinates(largest);
  if (arrays.unit != 1)
    for (Double_3& p : arrays.points)
      p = (1 / arrays.unit) * p;
}

/// Reads points and the corners of polygons. No neighbor is known yet.
/// \throws Invalid_input if a polygon has no corner or one that is not a point, or a point is not
///         finite
template <typename PointRange, typename PolygonRange>
Raw_surface read_polygons(const PointRange& points, const PolygonRange& polygons,
                          const Execution& execution)
{
  using Index = Surface::Index;
  Raw_surface raw;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const auto size = std::size_t(std::distance(std::begin(polygons), std::end(polygons)));
  arrays.points.reserve(std::size_t(std::distance(std::begin(points), std::end(points))));
  arrays.first_corners.reserve(size + 1);
  arrays.corners.reserve(3 * size); // enough for triangles
  for (const auto& p : points)
    arrays.points.push_back(to_double_3(p));
  arrays.first_corners.push_back(0);
  for (const auto& polygon : polygons) {
    const auto place = [&] { return "polygon " + std::to_string(arrays.first_corners.size() - 1); };
    for (const auto& v : polygon) {
      static_assert(std::is_integral<std::decay_t<decltype(v)>>::value,
                    "polygons are ranges of indices of points: of an integral type");
      if (!(v >= 0 && std::size_t(v) < arrays.points.size()))
        throw Invalid_input(place() + " has a corner " + std::to_string(v) + ", but there are " +
                            std::to_string(arrays.points.size()) + " points");
      arrays.corners.push_back(Index(v));
    }
    if (arrays.corners.size() == arrays.first_corners.back())
      throw Invalid_input(place() + " has no corners");
    if (arrays.corners.size() >= Raw_surface::none)
      throw Invalid_input("the polygons have fewer than 2^32 - 1 corners");
    arrays.first_corners.push_back(Index(arrays.corners.size()));
  }
  set_unit(raw.surface);
  raw.neighbors.assign(arrays.corners.size(), Raw_surface::none);
  begin_at_lowest_vertices(raw, execution);
  return raw;
}

/// The elements of a range by position, and the position of each element, which is found by an
/// index map of any numbering. It takes a descriptor per element, and 4 bytes unless the index is
/// the position. (If these were always taken, a mesh of 320,000 faces in random order would be read
/// in twice the time.)
///
/// The descriptors are stored since the latencies of traversing a linked list add up, while those
/// of several handles overlap.
template <typename IndexMap, typename Descriptor>
class Iteration_ranks
{
public:
  /// `capacity`: an upper bound of the indices, removed elements of the mesh included.
  template <typename Range>
  Iteration_ranks(IndexMap index_map, const Range& range, std::size_t capacity)
    : m_index_map(index_map)
  {
    bool is_identity = true;
    m_elements.reserve(capacity);
    for (const Descriptor& d : range) {
      is_identity &= std::size_t(get(m_index_map, d)) == size();
      m_elements.push_back(d);
    }
    if (!is_identity)
      m_ranks.resize(capacity);
    for (std::size_t rank = 0; rank < size() && !is_identity; ++rank) {
      const std::size_t index = get(m_index_map, m_elements[rank]);
      CGAL_precondition_msg(index < capacity, "an index map has values from 0 to the size - 1");
      m_ranks[index] = Surface::Index(rank);
    }
  }

  std::size_t size() const { return m_elements.size(); }
  Surface::Index operator[](const Descriptor& d) const
  {
    const std::size_t index = get(m_index_map, d);
    return m_ranks.empty() ? Surface::Index(index) : m_ranks[index];
  }
  const std::vector<Descriptor>& elements() const { return m_elements; }

private:
  IndexMap m_index_map;
  Large_array<Surface::Index> m_ranks; // by index; empty if each rank is the index
  std::vector<Descriptor> m_elements;
};

/// The order of the elements of a face graph, which does not depend on its type: faces and vertices
/// are numbered by iteration, and the boundary of a face begins at its vertex of lowest number.
template <typename FaceGraph, typename Pack>
class Mesh_order
{
  using Traits = boost::graph_traits<FaceGraph>;
  using Face_index_map = typename GetInitializedFaceIndexMap<FaceGraph, Pack>::const_type;
  using Vertex_index_map = typename GetInitializedVertexIndexMap<FaceGraph, Pack>::const_type;

public:
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  static constexpr Surface::Index none = (std::numeric_limits<Surface::Index>::max)();

  /// \throws Invalid_input if there are too many halfedges
  Mesh_order(const FaceGraph& mesh, const Pack& np)
    : m_mesh(mesh)
    , m_faces(get_initialized_face_index_map(mesh, np), faces(mesh), num_faces(mesh))
    , m_vertices(get_initialized_vertex_index_map(mesh, np), vertices(mesh), num_vertices(mesh))
  {
    if (num_halfedges(mesh) >= none) // corners are counted in 32 bits
      throw Invalid_input("a mesh has fewer than 2^32 - 1 halfedges");
  }

  const FaceGraph& mesh() const { return m_mesh; }
  std::size_t number_of_faces() const { return m_faces.size(); }
  std::size_t number_of_vertices() const { return m_vertices.size(); }

  Surface::Index vertex_rank(vertex_descriptor v) const { return m_vertices[v]; }
  /// The number of the face of a halfedge; `none` at a border.
  Surface::Index face_rank(halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_mesh);
    return f == Traits::null_face() ? none : m_faces[f];
  }

  /// The halfedge of a face that leaves its vertex of lowest number.
  halfedge_descriptor first_halfedge(face_descriptor f) const
  {
    halfedge_descriptor first = halfedge(f, m_mesh);
    Surface::Index lowest = none;
    for (halfedge_descriptor h : CGAL::halfedges_around_face(first, m_mesh))
      if (const Surface::Index rank = vertex_rank(source(h, m_mesh)); rank < lowest) {
        lowest = rank;
        first = h;
      }
    return first;
  }

  const auto& ordered_faces() const { return m_faces.elements(); }
  const auto& ordered_vertices() const { return m_vertices.elements(); }

private:
  const FaceGraph& m_mesh;
  Iteration_ranks<Face_index_map, face_descriptor> m_faces;
  Iteration_ranks<Vertex_index_map, vertex_descriptor> m_vertices;
};

/// Reads the corners of the faces, and the faces across their sides.
template <typename FaceGraph, typename Pack>
void read_corners(const Mesh_order<FaceGraph, Pack>& order, Raw_surface& raw,
                  const Execution& execution)
{
  const FaceGraph& mesh = order.mesh();
  Surface_arrays& arrays = arrays_of(raw.surface);
  arrays.first_corners.resize(order.number_of_faces() + 1);
  arrays.corners.resize(num_halfedges(mesh));
  raw.neighbors.resize(num_halfedges(mesh));
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
        arrays.first_corners[f] = Surface::Index(corner);
        for (auto h : halfedges_of(f)) {
          arrays.corners[corner] = order.vertex_rank(source(h, mesh));
          raw.neighbors[corner++] = order.face_rank(opposite(h, mesh));
        }
      }
      return corner;
    });
  arrays.first_corners.back() = Surface::Index(number);
  arrays.corners.resize(number);
  raw.neighbors.resize(number);
  // A loop of its own: the search for the lowest vertex, whose branches are random, would make the
  // loop above wait for memory.
  begin_at_lowest_vertices(raw, execution);
}

/// Reads the points of the vertices and the corners of the faces. A vertex point map may return
/// points by value.
template <typename FaceGraph, typename Pack>
Raw_surface read_face_graph(const Mesh_order<FaceGraph, Pack>& order, const Pack& np,
                            const Execution& execution)
{
  Raw_surface raw;
  const auto point_map = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    get_const_property_map(vertex_point, order.mesh()));
  Large_array<Double_3>& points = arrays_of(raw.surface).points;
  points.resize(order.number_of_vertices());
  for_each_index(execution, points.size(), [&](std::size_t i) {
    const auto v = order.ordered_vertices()[i];
    points[i] = to_double_3(get(point_map, v));
  });
  read_corners(order, raw, execution);
  set_unit(raw.surface);
  return raw;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_READ_SURFACE_H
