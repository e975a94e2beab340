// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FACE_NEIGHBORS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FACE_NEIGHBORS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(adjacency, i, j)` for the adjacencies across edges and seams of faces with different
/// labels i and j: those of the lower and of the higher face.
template <typename Labels, typename F>
void for_each_border(const Surface& surface, const Labels& labels, const F& f)
{
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Surface::Index i = labels[surface.lower_face(a)], j = labels[surface.higher_face(a)];
    if (i != j && !surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED))
      f(a, i, j);
  }
}

/// The faces adjacent to each face across edges and seams, and whether they go on smoothly there.
class Face_neighbors
{
public:
  using Index = Surface::Index;
  struct Neighbor
  {
    Index face, adjacency;
  };
  explicit Face_neighbors(const Surface& surface)
    : m_surface(surface)
  {
    m_neighbors = Grouped_items<Neighbor>(surface.number_of_faces(), [&](const auto& add) {
      for (Index a = 0; a < surface.number_of_adjacencies(); ++a)
        if (!surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED)) {
          add(surface.lower_face(a), {surface.higher_face(a), a});
          add(surface.higher_face(a), {surface.lower_face(a), a});
        }
    });
    find_thin_faces(surface);
  }

  Iterator_range<const Neighbor*> operator[](std::size_t face) const { return m_neighbors[face]; }

  /// Whether a face is a sliver, needle or cap: its normal tells nothing of the surface on which
  /// its vertices lie.
  bool is_thin(std::size_t face) const { return m_is_thin[face] != 0; }

  /// Whether the deviation of an adjacency may be that of two facets of a curved face.
  bool is_smooth(std::size_t adjacency) const
  {
    return m_surface.cosine(adjacency) > smooth_cosine;
  }
  /// Whether its two faces are parts of one plane facet.
  bool is_coplanar(std::size_t adjacency) const
  {
    return m_surface.cosine(adjacency) > flat_cosine;
  }
  /// Whether it is smooth, or that is unknown.
  bool may_be_smooth(std::size_t adjacency) const
  {
    return is_smooth(adjacency) || is_thin(m_surface.lower_face(adjacency)) ||
           is_thin(m_surface.higher_face(adjacency));
  }

private:
  static constexpr double flat_cosine = 1 - 1e-9;
  static constexpr double smooth_cosine = 0.819; // 35 degrees: a cylinder has at least 11 facets

  void find_thin_faces(const Surface& surface)
  {
    m_is_thin.resize(surface.number_of_faces());
    for (std::size_t f = 0; f < m_is_thin.size(); ++f)
      m_is_thin[f] = surface.is_degenerate(f) || is_thin(surface, f);
  }

  /// Half of a narrow strip, which has an edge about as short as its height, is not thin.
  static bool is_thin(const Surface& surface, std::size_t face)
  {
    constexpr double thin = 0.002, // height over the longest edge
      of_strip = 0.5,              // height over the shortest edge
      rounding = 1e-5;             // height over the size of the surface
    double longest = 0, shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, n = surface.number_of_corners(face); i < n; ++i) {
      const double length = norm(surface.point(surface.corner(face, i)) -
                                 surface.point(surface.corner(face, (i + 1) % n)));
      longest = (std::max)(longest, length);
      shortest = (std::min)(shortest, length);
    }
    const double height = 2 * surface.area(face) / longest;
    return height < thin * longest &&
           (height < of_strip * shortest || height < rounding * surface.length_unit());
  }

  const Surface& m_surface;
  Grouped_items<Neighbor> m_neighbors;
  std::vector<std::uint8_t> m_is_thin;
};

/// Marks of elements that are cleared in constant time.
class Element_marks
{
public:
  explicit Element_marks(std::size_t size)
    : m_marks(size, 0)
  {}
  void clear() { ++m_current; }
  bool has(std::size_t i) const { return m_marks[i] == m_current; }
  /// Returns whether the element was not marked before.
  bool mark(std::size_t i)
  {
    const bool is_new = !has(i);
    m_marks[i] = m_current;
    return is_new;
  }

private:
  std::vector<std::uint32_t> m_marks;
  std::uint32_t m_current = 1;
};

/// Faces in the order in which they are added, and the points of their vertices.
class Face_set
{
public:
  using Index = Surface::Index;

  explicit Face_set(const Surface& surface)
    : m_surface(surface)
    , m_face_marks(surface.number_of_faces())
    , m_vertex_marks(surface.number_of_vertices())
  {}

  void clear()
  {
    m_faces.clear();
    m_points.clear();
    m_face_marks.clear();
    m_vertex_marks.clear();
  }

  /// \pre the set does not have the face
  void add(Index face)
  {
    m_face_marks.mark(face);
    m_faces.push_back(face);
    for (std::size_t i = 0; i < m_surface.number_of_corners(face); ++i)
      if (m_vertex_marks.mark(m_surface.corner(face, i)))
        m_points.push_back(m_surface.point(m_surface.corner(face, i)));
  }

  /// Makes it the faces around `seed` in breadth first order, across `may_cross(neighbor)`, until
  /// they have `wanted` vertices.
  template <typename MayCross>
  void collect(const Face_neighbors& neighbors, Index seed, std::size_t wanted,
               const MayCross& may_cross)
  {
    clear();
    add(seed);
    for (std::size_t next = 0; next < faces().size() && points().size() < wanted; ++next)
      for (const Face_neighbors::Neighbor& n : neighbors[faces()[next]])
        if (!has(n.face) && may_cross(n))
          add(n.face);
  }

  bool has(Index face) const { return m_face_marks.has(face); }
  const std::vector<Index>& faces() const { return m_faces; }
  const std::vector<Double_3>& points() const { return m_points; }

private:
  const Surface& m_surface;
  Element_marks m_face_marks, m_vertex_marks;
  std::vector<Index> m_faces;
  std::vector<Double_3> m_points;
};

/// The side that two faces share, from one vertex to another; of several, one of them. `along` is 0
/// if they share no vertices. Linear time in the corners of the face that has fewer.
struct Shared_side
{
  Double_3 middle{0, 0, 0}, along{0, 0, 0};

  Shared_side(const Surface& surface, std::size_t face, std::size_t other)
  {
    if (surface.number_of_corners(face) > surface.number_of_corners(other))
      std::swap(face, other);
    const std::size_t n = surface.number_of_corners(face);
    double least = none;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t p = surface.corner(face, i), q = surface.corner(face, (i + 1) % n);
      const double distance = (std::max)(this->distance(surface, p, other),
                                         this->distance(surface, q, other));
      if (distance < least) {
        least = distance;
        set(surface.point(p), surface.point(q));
      }
    }
    if (least == none)
      middle = 0.5 * (surface.centroid(face) + surface.centroid(other));
  }

private:
  static constexpr std::size_t many = 64; // corners, among which a vertex is not searched
  static constexpr double none = (std::numeric_limits<double>::max)();

  /// 0 for a vertex of a face, else none; that from its plane where the face has many corners.
  static double distance(const Surface& surface, std::size_t vertex, std::size_t face)
  {
    const std::size_t n = surface.number_of_corners(face);
    if (n > many)
      return std::fabs(
        dot(surface.normal(face), surface.point(vertex) - surface.point(surface.corner(face, 0))));
    for (std::size_t i = 0; i < n; ++i)
      if (surface.corner(face, i) == vertex)
        return 0;
    return none;
  }

  void set(const Double_3& from, const Double_3& to)
  {
    const Double_3 d = to - from;
    middle = 0.5 * (from + to);
    along = norm(d) > 0 ? (1 / norm(d)) * d : d;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FACE_NEIGHBORS_H
