// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H

#include "soup/Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace segment_mesh {

/// A side of a polygon from a point to the next one, and the point before both.
struct Polygon_side
{
  Polygons::Index from, to, previous;

  friend bool operator<(const Polygon_side& a, const Polygon_side& b)
  {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  }
};

/// Whether the polygons at a point are one fan or disc: the edge to its previous point leads from
/// each to another one, until all are passed. \pre [begin, end) are the sides that leave the point,
/// sorted, all different
inline bool is_one_fan(const Polygon_side* begin, const Polygon_side* end)
{
  const auto across = [begin, end](const Polygon_side* side) {
    const Polygon_side* const found = std::lower_bound(begin, end,
                                                       Polygon_side{side->from, side->previous, 0});
    return found != end && found->to == side->previous ? found : end;
  };
  std::vector<char> is_led_to(std::size_t(end - begin) + 1);
  for (const Polygon_side* side = begin; side != end; ++side)
    is_led_to[std::size_t(across(side) - begin)] = true;
  // A fan that is not closed is walked from the face that no other one leads to.
  const auto start = std::find(is_led_to.begin(), is_led_to.end() - 1, false);
  const Polygon_side* const first = start == is_led_to.end() - 1
                                      ? begin
                                      : begin + (start - is_led_to.begin());
  std::ptrdiff_t size = 1;
  for (const Polygon_side* side = across(first); side != end && side != first; side = across(side))
    ++size;
  return size == end - begin;
}

/// Whether the faces form an oriented 2-manifold: faces have at least three corners, none twice; no
/// two faces have an edge in the same direction; the faces at a point form one fan or one disc.
/// \cgal's `is_polygon_soup_a_polygon_mesh()` says the same, but takes four times as long as to
/// make the mesh. O(n log n) in the number of corners.
inline bool is_oriented_manifold(const Polygon_soup& soup)
{
  std::vector<Polygon_side> sides;
  sides.reserve(soup.polygons.corners().size());
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    const std::size_t n = polygon.size();
    std::vector<Polygons::Index> corners(polygon.begin(), polygon.end());
    std::sort(corners.begin(), corners.end());
    if (n < 3 || std::adjacent_find(corners.begin(), corners.end()) != corners.end())
      return false;
    for (std::size_t i = 0; i < n; ++i)
      sides.push_back({polygon[i], polygon[(i + 1) % n], polygon[(i + n - 1) % n]});
  }
  std::sort(sides.begin(), sides.end());
  const auto is_same = [](const Polygon_side& a, const Polygon_side& b) { return !(a < b); };
  if (std::adjacent_find(sides.begin(), sides.end(), is_same) != sides.end())
    return false;
  const Polygon_side* const end = sides.data() + sides.size();
  for (const Polygon_side *first = sides.data(), *last = first; first != end; first = last) {
    last = std::find_if(first, end, [first](const auto& side) { return side.from != first->from; });
    if (!is_one_fan(first, last))
      return false;
  }
  return true;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H
