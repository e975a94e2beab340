// SPDX-License-Identifier: GPL-3.0-or-later

#include "soup/is_oriented_manifold.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace segment_mesh {

namespace {

/// As in a `Surface_mesh`, which has no more points.
using Index = std::uint32_t;

/// A face at a point, as the points that come after and before that point on the face.
struct Corner
{
  Index next, previous;

  friend bool operator<(const Corner& a, const Corner& b) { return a.next < b.next; }
};

/// The corners by their points: those of point p are at `[first[p], first[p + 1])`.
struct Corners
{
  std::vector<std::size_t> first;
  std::vector<Corner> corners;
};

bool has_repeated_corner(const Polygon_soup::Polygon& polygon)
{
  if (polygon.size() == 3)
    return polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0];
  Polygon_soup::Polygon sorted = polygon;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

Corners collect_corners(const Polygon_soup& soup)
{
  Corners result;
  result.first.resize(soup.points.size() + 1);
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    for (std::size_t point : polygon)
      ++result.first[point];
  // The ends of the ranges, which filling them backwards makes their starts.
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.corners.resize(result.first.back());
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    Index previous = Index(polygon.back());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Index next = Index(polygon[i + 1 < polygon.size() ? i + 1 : 0]);
      result.corners[--result.first[polygon[i]]] = {next, previous};
      previous = Index(polygon[i]);
    }
  }
  return result;
}

/// Whether the faces at a point, a few, are one closed fan, whose edges are all different: each leads to one, and all of them
/// are passed before the first one is met again.
bool is_closed_fan(const Corner* begin, const Corner* end)
{
  const Corner* corner = begin;
  std::ptrdiff_t size = 0;
  do {
    const Index wanted = corner->previous;
    corner = std::find_if(begin, end, [wanted](const Corner& other) { return other.next == wanted; });
    ++size;
  } while (corner != end && corner != begin && size < end - begin);
  return corner == begin && size == end - begin;
}

/// Whether the faces at a point are one fan, whose edges are all different. Across the edge to its
/// previous point a face has the one for which that is the next point. `is_led_to` is a buffer.
bool is_fan(Corner* begin, Corner* end, std::vector<char>& is_led_to)
{
  constexpr std::ptrdiff_t few = 16; // most fans are closed and small, and then no order is needed
  if (begin == end || (end - begin <= few && is_closed_fan(begin, end)))
    return true;
  std::sort(begin, end);
  const auto is_same_edge = [](const Corner& a, const Corner& b) { return a.next == b.next; };
  if (std::adjacent_find(begin, end, is_same_edge) != end)
    return false;

  const auto across = [begin, end](const Corner* corner) {
    const Corner wanted = {corner->previous, 0};
    Corner* const found = std::lower_bound(begin, end, wanted);
    return found != end && found->next == wanted.next ? found : end;
  };
  // A fan with two ends is walked from the face that no other one leads to.
  is_led_to.assign(std::size_t(end - begin), false);
  for (Corner* corner = begin; corner != end; ++corner)
    if (Corner* const other = across(corner); other != end)
      is_led_to[std::size_t(other - begin)] = true;
  const auto start = std::find(is_led_to.begin(), is_led_to.end(), false);
  Corner* const first = start == is_led_to.end() ? begin : begin + (start - is_led_to.begin());
  std::ptrdiff_t size = 1;
  for (Corner* corner = across(first); corner != end && corner != first && size <= end - begin;
       corner = across(corner))
    ++size;
  return size == end - begin;
}

} // namespace

bool is_oriented_manifold(const Polygon_soup& soup)
{
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    if (polygon.size() < 3 || has_repeated_corner(polygon))
      return false;
  Corners corners = collect_corners(soup);
  Corner* const all = corners.corners.data();
  std::vector<char> buffer;
  for (std::size_t point = 0; point < soup.points.size(); ++point)
    if (!is_fan(all + corners.first[point], all + corners.first[point + 1], buffer))
      return false;
  return true;
}

} // namespace segment_mesh
