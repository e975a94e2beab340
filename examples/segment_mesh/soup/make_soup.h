// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SOUP_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SOUP_H

#include "soup/Edge_list.h"
#include "soup/Polygon_soup.h"
#include "soup/vector_algebra.h"

#include <CGAL/Region_segmentation/Support/exceptions.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace segment_mesh {

/// The index that a number from another language is.
/// \throws Invalid_input that begins with `place()` if it is none below `number_of_points`
template <typename Number, typename Place>
std::size_t point_index(Number index, std::size_t number_of_points, const Place& place)
{
  if (index >= 0 && index < Number(number_of_points) && Number(std::size_t(index)) == index)
    return std::size_t(index);
  std::ostringstream text;
  text << place() << ": index " << index << " is out of range: there are " << number_of_points
       << " points";
  throw CGAL::Region_segmentation::Invalid_input(text.str());
}

/// The soup of arrays from another language, which are ranges with `size()` and `operator[]`:
/// three coordinates of each point, the corners of all faces one after another, and how many of
/// them each face has. A point that is not finite and not used becomes the origin.
/// \pre the sizes of the faces add up to the number of corners
/// \throws Invalid_input if a face has no corners, or one that is not a point, or not finite
template <typename Coordinates, typename Corners, typename Sizes>
Polygon_soup make_soup(const Coordinates& coordinates, const Corners& corners, const Sizes& sizes)
{
  using CGAL::Region_segmentation::Invalid_input;
  Polygon_soup soup;
  for (std::size_t i = 0; i + 2 < std::size_t(coordinates.size()); i += 3)
    soup.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  std::size_t corner = 0;
  for (std::size_t f = 0; f < std::size_t(sizes.size()); ++f) {
    const auto place = [&] { return "face " + std::to_string(f) + ", from 0"; };
    if (!(sizes[f] > 0))
      throw Invalid_input(place() + ": has no corners");
    for (const std::size_t end = corner + std::size_t(sizes[f]); corner < end; ++corner) {
      const std::size_t i = point_index(corners[corner], soup.points.size(), place);
      if (!is_finite(soup.points[i]))
        throw Invalid_input("the point of vertex " + std::to_string(i) + " is not finite");
      soup.polygons.add_corner(i);
    }
    soup.polygons.close_polygon();
  }
  for (Point& p : soup.points)
    if (!is_finite(p))
      p = {};
  return soup;
}

/// The edges whose ends are given two by two.
/// \throws Invalid_input if a pair is not joined by an edge
template <typename Ends>
std::vector<Vertex_pair> make_edges(const Polygon_soup& soup, const Ends& ends)
{
  const auto place = [] { return std::string("constrained edges"); };
  std::vector<Vertex_pair> result;
  if (ends.size() == 0)
    return result;
  const Edge_list edges(soup);
  for (std::size_t i = 0; i + 1 < std::size_t(ends.size()); i += 2) {
    const std::size_t a = point_index(ends[i], soup.points.size(), place),
                      b = point_index(ends[i + 1], soup.points.size(), place);
    if (!edges.has(a, b))
      throw CGAL::Region_segmentation::Invalid_input(
        place() + ": there is no edge between points " + std::to_string(a) + " and " +
        std::to_string(b));
    result.push_back({a, b});
  }
  return result;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SOUP_H
