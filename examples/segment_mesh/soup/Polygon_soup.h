// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_POLYGON_SOUP_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_POLYGON_SOUP_H

#include <boost/iterator/iterator_facade.hpp>
#include <boost/range/iterator_range_core.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <vector>

namespace segment_mesh {

/// Coordinates. \cgal's kernels take longer to compile than most parts of the program, so only
/// those that compute with points know one.
using Point = std::array<double, 3>;

/// An edge by the indices of its points.
using Vertex_pair = std::array<std::size_t, 2>;

/// Cycles of indices of points, all corners one after another: vectors in a vector take 3.5 times
/// the memory for triangles, and 10 million of them take as long to read as to segment by two-step.
class Polygons
{
public:
  /// Of a point or a corner; as in a `Surface_mesh`, which has no more of either.
  using Index = std::uint32_t;

  /// The corners of a polygon, valid until polygons are added.
  using Polygon = boost::iterator_range<const Index*>;

  class const_iterator : public boost::iterator_facade<const_iterator, Polygon,
                                                       boost::single_pass_traversal_tag, Polygon>
  {
  public:
    const_iterator(const Polygons& polygons, std::size_t f)
      : m_polygons(&polygons)
      , m_f(f)
    {}

  private:
    friend class boost::iterator_core_access;
    Polygon dereference() const { return (*m_polygons)[m_f]; }
    void increment() { ++m_f; }
    bool equal(const const_iterator& other) const { return m_f == other.m_f; }

    const Polygons* m_polygons;
    std::size_t m_f;
  };

  using value_type = Polygon;
  using iterator = const_iterator;

  Polygons() = default;
  Polygons(std::initializer_list<std::vector<std::size_t>> polygons) { append(polygons); }
  Polygons(const std::vector<std::vector<std::size_t>>& polygons) { append(polygons); }

  std::size_t size() const { return m_ends.size(); }
  bool empty() const { return m_ends.empty(); }
  Polygon operator[](std::size_t f) const
  {
    return {m_corners.data() + first_corner(f), m_corners.data() + m_ends[f]};
  }
  /// The place of the first corner of a polygon in `corners()`.
  std::size_t first_corner(std::size_t f) const { return f == 0 ? 0 : m_ends[f - 1]; }
  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, size()}; }

  /// The corners of all polygons, in their order.
  const std::vector<Index>& corners() const { return m_corners; }

  /// Makes room for so many triangles.
  void reserve(std::size_t number)
  {
    m_ends.reserve(number);
    m_corners.reserve(3 * number);
  }
  std::size_t capacity() const { return m_ends.capacity(); }

  /// Adds a corner to the polygon that `close_polygon()` will end.
  void add_corner(std::size_t point) { m_corners.push_back(Index(point)); }
  void close_polygon()
  {
    if (m_corners.size() > (std::numeric_limits<Index>::max)())
      throw std::length_error("the faces have more than 2^32 - 1 corners");
    m_ends.push_back(Index(m_corners.size()));
  }

  template <typename Range>
  void push_back(const Range& points)
  {
    for (std::size_t point : points)
      add_corner(point);
    close_polygon();
  }
  void push_back(std::initializer_list<std::size_t> points) { push_back<>(points); }

  /// Replaces each index `i` of a point by `new_index(i)`.
  template <typename NewIndex>
  void renumber(NewIndex new_index)
  {
    for (Index& i : m_corners)
      i = Index(new_index(i));
  }

  friend bool operator==(const Polygons& a, const Polygons& b)
  {
    return a.m_ends == b.m_ends && a.m_corners == b.m_corners;
  }

private:
  template <typename Range>
  void append(const Range& polygons)
  {
    for (const auto& polygon : polygons)
      push_back(polygon);
  }

  std::vector<Index> m_corners;
  std::vector<Index> m_ends; // of the polygons among the corners
};

/// Points, and faces as cycles of indices of points.
struct Polygon_soup
{
  using Polygon = Polygons::Polygon;

  std::vector<Point> points;
  Polygons polygons;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_POLYGON_SOUP_H
