// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_FACES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_FACES_H

#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>

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

/// Turns faces so that neighbors across edges run in opposite directions along them. Of each
/// component the part of larger area (of equal ones that with the lowest face) remains as it is.
/// Edges whose two faces cannot be oriented consistently become seams.
inline void Surface_builder::orient_faces()
{
  const std::size_t size = number_of_faces();
  if (std::find(m_is_parallel.begin(), m_is_parallel.end(), true) == m_is_parallel.end())
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
      areas[int(state[f])] += m_areas[f];
      for (Index c = m_first_corners[f]; c < m_first_corners[f + 1]; ++c)
        if (const Index g = m_neighbors[c]; is_face(g) && state[g] == NOT_REACHED) {
          state[g] = (state[f] == TURNED) != m_is_parallel[c] ? TURNED : AS_IT_IS;
          component.push_back(g);
        }
    }
    if (areas[TURNED] > areas[AS_IT_IS])
      for (const Index f : component)
        state[f] = state[f] == TURNED ? AS_IT_IS : TURNED;
  }
  for (Index f = 0; f < size; ++f) {
    for (Index c = m_first_corners[f]; c < m_first_corners[f + 1]; ++c)
      if (const Index g = m_neighbors[c];
          is_face(g) && g > f && (state[f] != state[g]) != m_is_parallel[c]) {
        m_added.push_back(seam_between(f, g, m_corners[c], m_corners[next_corner(f, c)], 1));
        m_neighbors[side_across(f, c)] = at_seam;
        m_neighbors[c] = at_seam;
      }
    if (state[f] == TURNED)
      turn_face(f);
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
  std::vector<Axis_box> boxes(is_closed.size()); // relative to the origin of the tree
  std::vector<Double_3> lowest(is_closed.size(), {infinity, infinity, infinity});
  const Face_tree tree(surface);
  const auto component = [&](Index leaf) { return component_of[tree.face(leaf)]; };
  for (Index f = 0; f < component_of.size(); ++f)
    for (const Index v : surface.corners(f)) {
      const Index c = component_of[f];
      boxes[c].add(box_of(std::array{surface.point(v) - tree.origin()}));
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
    Axis_box above = box_of(std::array{lowest[c] - tree.origin()});
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

/// The volumes of the components, relative to the first point, so that nothing cancels far from the
/// origin.
inline std::vector<Component_volume> component_volumes(const Surface& surface)
{
  using Index = Surface::Index;
  const Partition& component_of = surface.components();
  std::vector<Component_volume> components(component_of.number_of_parts());
  for (std::size_t f = 0; f < component_of.size(); ++f) {
    Component_volume& component = components[component_of[f]];
    const Double_3 face = surface.area(f) * surface.normal(f);
    component.area += surface.area(f);
    component.area_vector = component.area_vector + face;
    component.volume += dot(
      surface.point(surface.corner(f, 0)) - surface.point(surface.corner(0, 0)), face);
    std::size_t i = 0;
    for_each_side(surface, f, [&](Index v, Index w) { // a side of no length is no border
      component.has_border |= surface.adjacency(f, i++) == Surface::none && v != w &&
                              !surface.is_degenerate(f);
    });
  }
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (surface.has_flag(a, Surface::SEAM))
      for (const Index f : {surface.lower_face(a), surface.higher_face(a)})
        components[component_of[f]].has_seam = true;
  return components;
}

/// Turns the outermost closed components of negative signed volume, together with the closed
/// components inside them. Sets the signs of all angles, if there are such components or seams.
inline void Surface_builder::orient_components()
{
  std::vector<bool> is_closed, is_inside_out;
  for (const Component_volume& component : component_volumes(*this)) {
    is_closed.push_back(component.is_closed());
    is_inside_out.push_back(component.is_closed() && component.volume < 0);
  }
  const bool are_turned = std::find(is_inside_out.begin(), is_inside_out.end(), true) !=
                          is_inside_out.end();
  if (are_turned) {
    const std::vector<Index> outermost = find_outermost(*this, m_component_of, is_closed);
    for (std::size_t f = 0; f < number_of_faces(); ++f)
      if (const Index c = m_component_of[f]; is_closed[c] && is_inside_out[outermost[c]])
        turn_face(f);
  }
  if (are_turned || has_seams_or_links())
    set_signs();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_FACES_H
