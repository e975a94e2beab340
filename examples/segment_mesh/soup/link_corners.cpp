// SPDX-License-Identifier: GPL-3.0-or-later

#include "soup/link_corners.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>

namespace segment_mesh {

namespace {

using Index = Polygons::Index;

/// A corner at a point, with the points that come after and before that point on the face.
struct Corner
{
  Index next, previous, id;

  friend bool operator<(const Corner& a, const Corner& b) { return a.next < b.next; }
};

/// The corners by their points: those of point p are at `[first[p], first[p + 1])`.
struct Corners_of_points
{
  std::vector<Index> first;
  std::unique_ptr<Corner[]> corners;
};

bool has_repeated_corner(const Polygon_soup::Polygon& polygon)
{
  if (polygon.size() == 3)
    return polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0];
  std::vector<Index> sorted(polygon.begin(), polygon.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

/// Nothing if a polygon is no face.
std::optional<Corners_of_points> collect_corners(const Polygon_soup& soup)
{
  Corners_of_points result;
  result.first.resize(soup.points.size() + 1);
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    if (polygon.size() < 3 || has_repeated_corner(polygon))
      return std::nullopt;
    for (const Index point : polygon)
      ++result.first[point];
  }
  // The ends of the ranges, which filling them backwards makes their starts.
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.corners.reset(new Corner[result.first.back()]); // uninitialized
  Index id = 0;
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    Index previous = polygon.back();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Index next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      result.corners[--result.first[polygon[i]]] = {next, previous, id++};
      previous = polygon[i];
    }
  }
  return result;
}

/// Links the corners at a point, a few, if they are one closed fan, whose edges are all different:
/// each leads to one, and all of them are passed before the first one is met again.
bool link_closed_fan(const Corner* begin, const Corner* end, Corner_links& links)
{
  const Corner* corner = begin;
  std::ptrdiff_t size = 0;
  do {
    const Index wanted = corner->previous;
    const Corner* const across = std::find_if(
      begin, end, [wanted](const Corner& other) { return other.next == wanted; });
    if (across == end)
      return false;
    links[corner->id] = across->id;
    corner = across;
    ++size;
  } while (corner != begin && size < end - begin);
  return corner == begin && size == end - begin;
}

/// Links the corners at a point if they are one fan, whose edges are all different. Across the edge
/// to its previous point a face has the one for which that is the next point. `is_led_to` is a
/// buffer.
bool link_fan(Corner* begin, Corner* end, Corner_links& links, std::vector<char>& is_led_to)
{
  constexpr std::ptrdiff_t few = 16; // most fans are closed and small, and then no order is needed
  if (begin == end || (end - begin <= few && link_closed_fan(begin, end, links)))
    return true;
  std::sort(begin, end);
  const auto is_same_edge = [](const Corner& a, const Corner& b) { return a.next == b.next; };
  if (std::adjacent_find(begin, end, is_same_edge) != end)
    return false;

  const auto across = [begin, end](const Corner* corner) {
    const Corner wanted = {corner->previous, 0, 0};
    Corner* const found = std::lower_bound(begin, end, wanted);
    return found != end && found->next == wanted.next ? found : end;
  };
  // A fan with two ends is walked from the face that no other one leads to.
  is_led_to.assign(std::size_t(end - begin), false);
  for (Corner* corner = begin; corner != end; ++corner)
    if (Corner* const other = across(corner); other != end) {
      links[corner->id] = other->id;
      is_led_to[std::size_t(other - begin)] = true;
    }
  const auto start = std::find(is_led_to.begin(), is_led_to.end(), false);
  Corner* const first = start == is_led_to.end() ? begin : begin + (start - is_led_to.begin());
  std::ptrdiff_t size = 1;
  for (Corner* corner = across(first); corner != end && corner != first && size <= end - begin;
       corner = across(corner))
    ++size;
  return size == end - begin;
}

} // namespace

std::optional<Corner_links> link_corners(const Polygon_soup& soup)
{
  const std::optional<Corners_of_points> of_points = collect_corners(soup);
  if (!of_points)
    return std::nullopt;
  Corner* const all = of_points->corners.get();
  Corner_links links(soup.polygons.corners().size(), no_corner);
  std::vector<char> buffer;
  for (std::size_t point = 0; point < soup.points.size(); ++point)
    if (!link_fan(all + of_points->first[point], all + of_points->first[point + 1], links, buffer))
      return std::nullopt;
  return links;
}

} // namespace segment_mesh
