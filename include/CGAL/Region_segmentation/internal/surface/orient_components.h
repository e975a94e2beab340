// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Box_tree.h>
#include <CGAL/Region_segmentation/internal/surface/match_sides.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reverses the boundary of a face, which still begins at its vertex of lowest index.
inline void turn_face(Raw_surface& raw, std::size_t face)
{
  Surface_arrays& arrays = arrays_of(raw.surface);
  const auto first = std::ptrdiff_t(arrays.first_corners[face]),
             past = std::ptrdiff_t(arrays.first_corners[face + 1]);
  arrays.normals[face] = -1.0 * arrays.normals[face];
  std::reverse(arrays.corners.begin() + first + 1, arrays.corners.begin() + past);
  for (auto* sides : {&raw.neighbors, &arrays.adjacencies})
    if (!sides->empty())
      std::reverse(sides->begin() + first, sides->begin() + past);
}

/// Turns faces so that neighbors across edges run in opposite directions along them. Of each
/// component the part of larger area (of equal ones that with the lowest face) remains as it is.
/// Edges whose two faces cannot be oriented consistently become seams.
inline void orient_faces(Raw_surface& raw, const std::vector<Surface::Index>& parallel_sides,
                         std::vector<Seam>& seams)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::size_t size = arrays.normals.size();
  if (parallel_sides.empty())
    return;
  std::vector<bool> is_parallel(arrays.corners.size()), is_reached(size), is_turned(size);
  for (const Index side : parallel_sides)
    is_parallel[side] = true;

  for (Index seed = 0; seed < size; ++seed) {
    if (is_reached[seed])
      continue;
    std::vector<Index> component{seed};
    double areas[2] = {0, 0}; // of the faces that are not turned, and of those that are
    is_reached[seed] = true;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Index f = component[i];
      areas[is_turned[f]] += arrays.areas[f];
      for (Index c = arrays.first_corners[f]; c < arrays.first_corners[f + 1]; ++c)
        if (const Index g = raw.neighbors[c]; Raw_surface::is_face(g) && !is_reached[g]) {
          is_reached[g] = true;
          is_turned[g] = is_turned[f] != is_parallel[c];
          component.push_back(g);
        }
    }
    if (areas[1] > areas[0])
      for (const Index f : component)
        is_turned[f] = !is_turned[f];
  }
  for (Index f = 0; f < size; ++f)
    for (Index c = arrays.first_corners[f]; c < arrays.first_corners[f + 1]; ++c) {
      const Index g = raw.neighbors[c];
      if (!Raw_surface::is_face(g) || g <= f || (is_turned[f] != is_turned[g]) == is_parallel[c])
        continue;
      const Side_of_edge a = side_at(arrays, f, c);
      raw.neighbors[side_across(raw, f, c)] = Raw_surface::at_seam;
      raw.neighbors[c] = Raw_surface::at_seam;
      seams.push_back({a.lower_vertex, a.higher_vertex, f, g, 1});
    }
  for (Index f = 0; f < size; ++f)
    if (is_turned[f])
      turn_face(raw, f);
}

inline bool is_lower(const Double_3& p, const Double_3& q)
{
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

/// Whether a triangle is above a point. Comparisons are half-open and computed alike from both
/// sides of an edge, so an upward ray passes through exactly one of the faces around an edge or a
/// vertex.
inline bool is_above_point(const Triangle& t, const Double_3& at)
{
  // Whether a side passes the point in the plane on the side of larger y.
  const auto passes = [&](Double_3 p, Double_3 q) {
    if ((p.x <= at.x) == (q.x <= at.x))
      return false;
    if (is_lower(q, p))
      std::swap(p, q);
    return p.y + (at.x - p.x) / (q.x - p.x) * (q.y - p.y) > at.y;
  };
  if (passes(t[0], t[1]) == (passes(t[1], t[2]) != passes(t[2], t[0])))
    return false;
  const Double_3 n = cross(t[1] - t[0], t[2] - t[0]), d = at - t[0];
  return n.z != 0 && t[0].z - (n.x * d.x + n.y * d.y) / n.z > at.z;
}

/// For each component the closed one with the largest box, of several the lowest, in which it lies;
/// itself if there is none or if it is open. A component lies in another one if its box does and an
/// odd number of faces of the other one are above its lowest vertex; so of two that cross either,
/// neither or one may lie in the other. O(F log F) in practice.
inline std::vector<Surface::Index> find_outermost(const Surface& surface,
                                                  const Partition& component_of,
                                                  const std::vector<bool>& is_closed)
{
  using Index = Surface::Index;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Axis_box> boxes(is_closed.size());
  std::vector<Double_3> lowest(is_closed.size(), {infinity, infinity, infinity});
  const Face_tree tree(surface);
  const auto component = [&](Index leaf) { return component_of[tree.face(leaf)]; };
  for (Index node = 0; node < tree.boxes().number_of_nodes(); ++node)
    if (tree.boxes().is_leaf(node)) {
      boxes[component(node)].add(tree.boxes().box(node));
      for (const Double_3& p : tree.triangle(node))
        if (is_lower(p, lowest[component(node)]))
          lowest[component(node)] = p;
    }

  const auto size = [&](Index c) {
    return boxes[c].extent(0) + boxes[c].extent(1) + boxes[c].extent(2);
  };
  const auto is_in_box_of = [&](Index c, Index d) {
    Axis_box both = boxes[d];
    both.add(boxes[c]);
    return both.low == boxes[d].low && both.high == boxes[d].high && size(c) < size(d);
  };
  std::vector<Index> result;
  for (Index c = 0; c < is_closed.size(); ++c) {
    result.push_back(c);
    if (!is_closed[c])
      continue;
    Axis_box above = box_of(std::array{lowest[c]});
    above.high[2] = std::numeric_limits<float>::infinity();
    std::map<Index, bool> contains; // by component: the parity of its faces above
    tree.boxes().search([&](Index node) { return squared_gap(tree.boxes().box(node), above); },
                        (std::numeric_limits<double>::min)(),
                        [&](Index leaf) {
                          const Index d = component(leaf);
                          if (is_closed[d] && is_in_box_of(c, d))
                            contains[d] ^= is_above_point(tree.triangle(leaf), lowest[c]);
                        });
    for (const auto& [d, is_inside] : contains)
      if (is_inside && (result[c] == c || size(d) > size(result[c])))
        result[c] = d;
  }
  return result;
}

/// What decides whether a component is closed, and its orientation.
struct Component_volume
{
  Double_3 area_vector{};
  double area = 0, volume = 0; // the volume times 3
  bool has_border = false, has_seam = false;

  /// The area vectors of a closed surface sum to zero; this decides where a component is closed
  /// only together with its seams.
  bool is_closed() const
  {
    constexpr double largest_gap = 1e-9;
    return !has_border && (!has_seam || norm(area_vector) <= largest_gap * area);
  }
};

/// Turns the outermost closed components of negative signed volume, together with the closed
/// components inside them.
inline void orient_components(Raw_surface& raw, const Partition& component_of,
                              const std::vector<Surface::Index>& faces_at_borders,
                              const std::vector<Seam>& seams)
{
  Surface_arrays& arrays = arrays_of(raw.surface);
  std::vector<Component_volume> components(component_of.number_of_parts());
  for (const Surface::Index face : faces_at_borders)
    components[component_of[face]].has_border = true;
  for (const Seam& seam : seams)
    for (const Surface::Index face : {seam.face, seam.other_face})
      components[component_of[face]].has_seam = true;
  for (std::size_t f = 0; f < component_of.size(); ++f) {
    Component_volume& component = components[component_of[f]];
    const Double_3 face = arrays.areas[f] * arrays.normals[f];
    component.area += arrays.areas[f];
    component.area_vector = component.area_vector + face;
    component.volume += dot(raw.surface.point(raw.surface.corner(f, 0)), face);
  }
  std::vector<bool> is_closed, is_inside_out;
  for (const Component_volume& component : components) {
    is_closed.push_back(component.is_closed());
    is_inside_out.push_back(component.is_closed() && component.volume < 0);
  }
  if (std::find(is_inside_out.begin(), is_inside_out.end(), true) == is_inside_out.end())
    return;
  const std::vector<Surface::Index> outermost = find_outermost(raw.surface, component_of,
                                                               is_closed);
  const auto is_turned = [&](std::size_t face) {
    const Surface::Index c = component_of[face];
    return is_closed[c] && is_inside_out[outermost[c]];
  };
  for (std::size_t f = 0; f < component_of.size(); ++f)
    if (is_turned(f))
      turn_face(raw, f);
  for (std::size_t a = 0; a < arrays.flags.size(); ++a)
    if (is_turned(arrays.lower_faces[a]) &&
        (arrays.flags[a] & (Surface::CONVEX | Surface::CONCAVE)))
      arrays.flags[a] ^= Surface::CONVEX | Surface::CONCAVE;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H
