// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_COMPONENTS_H

#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/match_sides.h>

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
/// `across`: an array by side, which is reversed like the corners
inline void turn_face(Surface_arrays& arrays, Large_array<Surface::Index>& across, std::size_t face)
{
  const auto first = std::ptrdiff_t(arrays.first_corners[face]),
             past = std::ptrdiff_t(arrays.first_corners[face + 1]);
  arrays.normals[face] = -1.0 * arrays.normals[face];
  std::reverse(arrays.corners.begin() + first + 1, arrays.corners.begin() + past);
  std::reverse(across.begin() + first, across.begin() + past);
}

/// Turns faces so that neighbors across edges run in opposite directions along them. Of each
/// component the part of larger area (of equal ones that with the lowest face) remains as it is.
/// Edges whose two faces cannot be oriented consistently become seams.
/// `is_parallel`: by side, whether that of the neighbor runs in the same direction
inline void orient_faces(Raw_surface& raw, const std::vector<bool>& is_parallel,
                         std::vector<Added_adjacency>& added)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::size_t size = arrays.normals.size();
  if (std::find(is_parallel.begin(), is_parallel.end(), true) == is_parallel.end())
    return;
  enum : char { AS_IT_IS, TURNED, NOT_REACHED };
  std::vector<char> state(size, NOT_REACHED);
  for (Index seed = 0; seed < size; ++seed) {
    if (state[seed] != NOT_REACHED)
      continue;
    std::vector<Index> component{seed};
    double areas[2] = {0, 0}; // of the faces that are not turned, and of those that are
    state[seed] = AS_IT_IS;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Index f = component[i];
      areas[int(state[f])] += arrays.areas[f];
      for (Index c = arrays.first_corners[f]; c < arrays.first_corners[f + 1]; ++c)
        if (const Index g = raw.neighbors[c]; Raw_surface::is_face(g) && state[g] == NOT_REACHED) {
          state[g] = (state[f] == TURNED) != is_parallel[c] ? TURNED : AS_IT_IS;
          component.push_back(g);
        }
    }
    if (areas[TURNED] > areas[AS_IT_IS])
      for (const Index f : component)
        state[f] = state[f] == TURNED ? AS_IT_IS : TURNED;
  }
  for (Index f = 0; f < size; ++f) {
    for (Index c = arrays.first_corners[f]; c < arrays.first_corners[f + 1]; ++c)
      if (const Index g = raw.neighbors[c];
          Raw_surface::is_face(g) && g > f && (state[f] != state[g]) != is_parallel[c]) {
        added.push_back(seam_between(raw.surface, f, g, arrays.corners[c],
                                     arrays.corners[next_corner(arrays, f, c)], 1));
        raw.neighbors[side_across(raw, f, c)] = Raw_surface::at_seam;
        raw.neighbors[c] = Raw_surface::at_seam;
      }
    if (state[f] == TURNED)
      turn_face(arrays, raw.neighbors, f);
  }
}

inline bool is_lower(const Double_3& p, const Double_3& q)
{
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

/// Whether a triangle is above a point. Comparisons are half-open, and give the same for both faces
/// of an edge, so that an upward ray passes through exactly one of the faces around an edge or a
/// vertex.
inline bool is_above_point(const Triangle& t, const Double_3& at)
{
  // Whether a side of the triangle passes the point, in the plane of x and y, at larger y.
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

/// For each component the outermost closed component in which it lies; the component itself if
/// there is none or if it is open. A component lies in another one if its box is in that of the
/// other, smaller, and an odd number of faces of the other are above its lowest vertex. O(F log F)
/// in practice.
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
  for (Index f = 0; f < component_of.size(); ++f)
    for (const Index v : surface.corners(f)) {
      const Index c = component_of[f];
      boxes[c].add(box_of(std::array{surface.point(v)}));
      lowest[c] = (std::min)(lowest[c], surface.point(v), is_lower);
    }
  const auto is_in_box_of = [&](Index c, Index d) {
    Axis_box both = boxes[d];
    both.add(boxes[c]);
    const auto is_both = [&](const Axis_box& b) {
      return both.low == b.low && both.high == b.high;
    };
    return is_both(boxes[d]) && !is_both(boxes[c]);
  };
  std::vector<Index> result;
  for (Index c = 0; c < is_closed.size(); ++c) {
    result.push_back(c);
    if (!is_closed[c])
      continue;
    Axis_box above = box_of(std::array{lowest[c]});
    above.high[2] = std::numeric_limits<float>::infinity();
    std::map<Index, bool> contains; // by component: whether the number of its faces above is odd
    tree.boxes().search([&](Index node) { return squared_gap(tree.boxes().box(node), above); },
                        (std::numeric_limits<double>::min)(),
                        [&](Index leaf) {
                          const Index d = component(leaf);
                          if (is_closed[d] && is_in_box_of(c, d))
                            contains[d] ^= is_above_point(tree.triangle(leaf), lowest[c]);
                        });
    for (const auto& [d, is_inside] : contains)
      if (is_inside && is_in_box_of(result[c], d))
        result[c] = d;
  }
  return result;
}

/// The sums over a component that tell whether it is closed, and how it is oriented.
struct Component_volume
{
  Double_3 area_vector{};
  double area = 0, volume = 0; // the volume times 3
  bool has_border = false, has_seam = false;

  /// Whether the component is closed. The area vectors of a closed surface sum to zero, which
  /// decides for a component that has seams.
  bool is_closed() const
  {
    constexpr double largest_gap = 1e-9;
    return !has_border && (!has_seam || norm(area_vector) <= largest_gap * area);
  }
};

/// Turns the outermost closed components of negative signed volume, together with the closed
/// components inside them. Returns whether any face is turned.
inline bool orient_components(Surface& surface)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(surface);
  const Partition& component_of = arrays.component_of;
  std::vector<Component_volume> components(component_of.number_of_parts());
  for (std::size_t f = 0; f < component_of.size(); ++f) {
    Component_volume& component = components[component_of[f]];
    const Double_3 face = arrays.areas[f] * arrays.normals[f];
    component.area += arrays.areas[f];
    component.area_vector = component.area_vector + face;
    component.volume += dot(surface.point(surface.corner(f, 0)), face);
    for (std::size_t i = 0; i < surface.number_of_corners(f) && !surface.is_degenerate(f); ++i)
      component.has_border |= surface.adjacency(f, i) == Surface::none;
  }
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (surface.has_flag(a, Surface::SEAM))
      for (const Index f : {surface.lower_face(a), surface.higher_face(a)})
        components[component_of[f]].has_seam = true;
  std::vector<bool> is_closed, is_inside_out;
  for (const Component_volume& component : components) {
    is_closed.push_back(component.is_closed());
    is_inside_out.push_back(component.is_closed() && component.volume < 0);
  }
  if (std::find(is_inside_out.begin(), is_inside_out.end(), true) == is_inside_out.end())
    return false;
  const std::vector<Index> outermost = find_outermost(surface, component_of, is_closed);
  for (std::size_t f = 0; f < component_of.size(); ++f)
    if (const Index c = component_of[f]; is_closed[c] && is_inside_out[outermost[c]])
      turn_face(arrays, arrays.adjacencies, f);
  return true;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_COMPONENTS_H
