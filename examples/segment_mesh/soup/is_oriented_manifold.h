// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H

#include "soup/Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace segment_mesh {

/// A side of a polygon that leaves a point: the point that it leads to, and the one before both.
struct Leaving_side
{
  Polygons::Index next, previous;

  friend bool operator<(const Leaving_side& a, const Leaving_side& b) { return a.next < b.next; }
};

/// Whether the polygons at a point are one fan or disc, or none: the edge to its previous point
/// leads from each to another one, until all are passed.
/// \pre [begin, end) are the sides that leave the point, sorted, to different points
/// \param is_led_to a buffer
inline bool is_one_fan(const Leaving_side* begin, const Leaving_side* end,
                       std::vector<char>& is_led_to)
{
  if (begin == end)
    return true;
  const auto across = [begin, end](const Leaving_side* side) {
    const Leaving_side* const found = std::lower_bound(begin, end, Leaving_side{side->previous, 0});
    return found != end && found->next == side->previous ? found : end;
  };
  is_led_to.assign(std::size_t(end - begin) + 1, false);
  for (const Leaving_side* side = begin; side != end; ++side)
    is_led_to[std::size_t(across(side) - begin)] = true;
  // A fan that is not closed is walked from the face that no other one leads to.
  const auto start = std::find(is_led_to.begin(), is_led_to.end() - 1, false) - is_led_to.begin();
  const Leaving_side* const first = begin + start == end ? begin : begin + start;
  std::ptrdiff_t size = 1;
  for (const Leaving_side* side = across(first); side != end && side != first && size < end - begin;
       side = across(side)) // not for ever where two edges come from one point
    ++size;
  return size == end - begin;
}

/// Whether the faces form an oriented 2-manifold: faces have at least three corners, none twice; no
/// two faces have an edge in the same direction; the faces at a point form one fan or one disc.
/// \cgal's `is_polygon_soup_a_polygon_mesh()` says the same, but takes four times as long as to
/// make the mesh. O(n log d), where n is the number of corners and d the largest number at a point.
inline bool is_oriented_manifold(const Polygon_soup& soup)
{
  std::vector<Polygons::Index> ends(soup.points.size() + 1), corners;
  for (const std::size_t i : soup.polygons.corners())
    ++ends[i + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin()); // where the sides of points start
  std::vector<Leaving_side> sides(soup.polygons.corners().size());
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    const std::size_t n = polygon.size();
    corners.assign(polygon.begin(), polygon.end());
    std::sort(corners.begin(), corners.end());
    if (n < 3 || std::adjacent_find(corners.begin(), corners.end()) != corners.end())
      return false;
    for (std::size_t i = 0; i < n; ++i)
      sides[ends[polygon[i]]++] = {polygon[(i + 1) % n], polygon[(i + n - 1) % n]};
  }
  const auto is_same = [](const Leaving_side& a, const Leaving_side& b) {
    return a.next == b.next;
  };
  std::vector<char> buffer;
  Leaving_side* begin = sides.data();
  for (const std::size_t i : ends) {
    Leaving_side* const end = sides.data() + i;
    std::sort(begin, end);
    if (std::adjacent_find(begin, end, is_same) != end || !is_one_fan(begin, end, buffer))
      return false;
    begin = end;
  }
  return true;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IS_ORIENTED_MANIFOLD_H
