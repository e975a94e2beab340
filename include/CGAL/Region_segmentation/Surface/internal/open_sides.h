// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_OPEN_SIDES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_OPEN_SIDES_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An open side. Open sides are grouped by their lower vertex.
struct Open_side
{
  Surface::Index higher_vertex, face, corner;
};

/// Calls `f(v, sides)` for each pair of vertices with open sides between them: `v` is the lower
/// vertex, `sides` the open sides in the order of their corners.
template <typename F>
void Surface_builder::for_each_open_edge(const F& f) const
{
  Grouped_items<Open_side> by_vertex(m_points.size(), [&](const auto& add) {
    for (Index face = 0; face < number_of_faces(); ++face)
      for (Index side = m_first_corners[face]; side < m_first_corners[face + 1]; ++side)
        if (m_neighbors[side] == none) {
          const auto [v, w] = std::minmax(m_corners[side], m_corners[next_corner(face, side)]);
          if (v != w)
            add(v, {w, face, side});
        }
  });
  for (Index v = 0; v < by_vertex.number_of_groups(); ++v) {
    const auto sides = by_vertex[v];
    std::sort(sides.begin(), sides.end(), [](const Open_side& a, const Open_side& b) {
      return std::tie(a.higher_vertex, a.corner) < std::tie(b.higher_vertex, b.corner);
    });
    for (auto first = sides.begin(), last = first; first != sides.end(); first = last) {
      last = std::find_if(first, sides.end(), [w = first->higher_vertex](const Open_side& s) {
        return s.higher_vertex != w;
      });
      f(v, make_range(first, last));
    }
  }
}

/// By vertex, the length of the shortest open side at it that does not make an edge of two faces;
/// infinite if there is none.
inline std::vector<double> Surface_builder::shortest_open_sides() const
{
  std::vector<double> result(m_points.size(), std::numeric_limits<double>::infinity());
  for_each_open_edge([&](Index v, const auto& sides) {
    const Index w = sides.begin()->higher_vertex;
    if (sides.size() != 2)
      for (const Index at : {v, w})
        result[at] = (std::min)(result[at], norm(m_points[w] - m_points[v]));
  });
  return result;
}

/// Unites vertices at open sides whose points are equal. Returns the number of unions.
/// `open_sides`: by vertex, see `shortest_open_sides()`
inline std::size_t unite_equal_points(const Surface& surface, const std::vector<double>& open_sides,
                                      Lowest_root_forest& merged)
{
  using Index = Surface::Index;
  const auto coordinates = [&](Index v) { // -0 becomes 0
    const Double_3& p = surface.point(v);
    return std::array{p.x + 0.0, p.y + 0.0, p.z + 0.0};
  };
  std::size_t number = 0;
  for_each_repetition(
    open_sides.size(),
    [&](const auto& add) {
      for (Index v = 0; v < open_sides.size(); ++v)
        if (std::isfinite(open_sides[v]))
          add(v, boost::hash<std::array<double, 3>>()(coordinates(v)));
    },
    [&](Index v, Index w) { return coordinates(v) == coordinates(w); },
    [&](Index v, Index first) { number += merged.unite(v, first); });
  return number;
}

/// Unites vertices at open sides where no coordinate differs by more than the tolerance of either
/// vertex. This is 2^-22 of the largest coordinate of the surface, two steps of single precision,
/// but at most a tenth of the shortest open side at the vertex, so that no side vanishes.
/// Returns the number of unions.
inline std::size_t unite_near_points(const Surface& surface, const std::vector<double>& open_sides,
                                     double largest_coordinate, Lowest_root_forest& merged)
{
  using Index = Surface::Index;
  constexpr double rounding = 0x1p-22, share_of_side = 0.1;
  std::vector<Index> vertices;
  for (Index v = 0; v < open_sides.size(); ++v)
    if (std::isfinite(open_sides[v]))
      vertices.push_back(v);
  std::size_t number = 0;
  if (vertices.empty())
    return number;
  const auto tolerance = [&](Index v) {
    return (std::min)(rounding * largest_coordinate, share_of_side * open_sides[v]);
  };
  const Double_3 origin = surface.point(vertices[0]);
  const auto box = [&](Index v) { return box_of(std::array{surface.point(v) - origin}); };
  const Box_tree tree(vertices.size(), [&](Index i) { return box(vertices[i]); });
  for (const Index v : vertices) {
    const double bound = 4 * tolerance(v) * tolerance(v);
    tree.search([&, at = box(v)](Index node) { return squared_gap(tree.box(node), at); }, bound,
                [&](Index leaf) {
                  const Index w = vertices[tree.item(leaf)];
                  const Double_3 apart = surface.point(w) - surface.point(v);
                  if ((std::max)({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <=
                      (std::min)(tolerance(v), tolerance(w)))
                    number += merged.unite(v, w);
                });
  }
  return number;
}

/// Merges vertices at open sides, each with the lowest one of its set: those at equal points, then,
/// of those whose sides still do not make an edge of two faces, those at points that differ by
/// rounding. So closed components keep their vertices, of a face graph and of polygons.
inline void Surface_builder::merge_vertices_of_open_sides()
{
  Lowest_root_forest merged(m_points.size());
  const auto use_merged = [&](std::size_t number) {
    for (std::size_t c = 0; c < m_corners.size() && number > 0; ++c)
      m_corners[c] = merged.root(m_corners[c]);
    return number;
  };
  std::vector<double> open_sides = shortest_open_sides();
  const std::size_t equal = use_merged(unite_equal_points(*this, open_sides, merged));
  if (equal > 0)
    open_sides = shortest_open_sides();
  m_number_apart = use_merged(unite_near_points(*this, open_sides, m_largest_coordinate, merged));
  if (equal + m_number_apart == 0)
    return;
  begin_at_lowest_vertices(Execution());
  for (Index v = 0; v < m_points.size(); ++v)
    m_merged_vertices.push_back(merged.root(v));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_OPEN_SIDES_H
