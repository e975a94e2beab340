// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_FACES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_FACES_H

#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
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
  bool is_inside_out() const { return is_closed() && volume < 0; }
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

/// For each component the innermost and the outermost closed component around it; the component
/// itself, if there is none or it is open.
struct Components_around
{
  std::vector<Surface::Index> innermost, outermost;
};

/// The closed components with an odd number of faces above a point: those around it.
inline std::vector<Surface::Index>
components_around_point(const Double_3& p, const Surface& surface, const Face_tree& tree,
                        const std::vector<Component_volume>& volumes)
{
  using Index = Surface::Index;
  Axis_box above = box_of(std::array{p - tree.origin()});
  above.high[2] = std::numeric_limits<float>::infinity();
  std::map<Index, bool> is_around; // by component
  tree.boxes().search([&](Index node) { return squared_gap(tree.boxes().box(node), above); },
                      (std::numeric_limits<double>::min)(),
                      [&](Index leaf) {
                        is_around[surface.components()[tree.face(leaf)]] ^= is_above_point(
                          tree.triangle(leaf), p);
                      });
  std::vector<Index> result;
  for (const auto& [c, is_odd] : is_around)
    if (is_odd && volumes[c].is_closed())
      result.push_back(c);
  return result;
}

/// A closed component lies in another one of larger volume if at least half of its faces do. So an
/// inner wall may cross the outer one in places. At most some hundred faces are asked for, by their
/// centroids. O(F log F) in practice.
///
/// `tree`: of the surface; `volumes`: by component
inline Components_around find_components_around(const Surface& surface, const Face_tree& tree,
                                                const std::vector<Component_volume>& volumes)
{
  using Index = Surface::Index;
  constexpr std::ptrdiff_t enough = 100; // faces
  const Grouped_items<Index> faces(volumes.size(), [&](const auto& add) {
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      add(surface.components()[f], f);
  });
  Components_around result;
  for (Index c = 0; c < volumes.size(); ++c) {
    Index &inner = result.innermost.emplace_back(c), &outer = result.outermost.emplace_back(c);
    if (!volumes[c].is_closed())
      continue;
    std::map<Index, std::size_t> numbers; // of faces, by component around them
    const auto [first, past] = faces[c];
    const std::ptrdiff_t step = (past - first) / enough + 1;
    std::size_t asked = 0;
    for (const Index* f = first; f < past; f += step, ++asked)
      for (const Index d : components_around_point(surface.centroid(*f), surface, tree, volumes))
        ++numbers[d];
    const auto is_larger = [&](Index d, Index e) {
      return std::abs(volumes[d].volume) > std::abs(volumes[e].volume);
    };
    for (const auto& [d, number] : numbers)
      if (2 * number >= asked && is_larger(d, c)) {
        outer = is_larger(d, outer) ? d : outer;
        inner = inner == c || is_larger(inner, d) ? d : inner;
      }
  }
  return result;
}

/// Turns the outermost closed components of negative signed volume, together with the closed
/// components inside them. Sets the signs of all angles, if there are such components or seams.
inline std::optional<Voids> Surface_builder::orient_components()
{
  const std::vector<Component_volume> volumes = component_volumes(*this);
  if (std::none_of(volumes.begin(), volumes.end(),
                   [](const auto& v) { return v.is_inside_out(); })) {
    if (has_seams_or_links())
      set_signs();
    return std::nullopt;
  }
  Voids voids{Face_tree(*this), {}};
  const Components_around around = find_components_around(*this, voids.tree, volumes);
  const auto is_turned = [&](Index c) {
    return volumes[c].is_closed() && volumes[around.outermost[c]].is_inside_out();
  };
  for (std::size_t f = 0; f < number_of_faces(); ++f)
    if (is_turned(m_component_of[f]))
      turn_face(f);
  const auto is_negative = [&](Index c) { // now
    return is_turned(c) ? volumes[c].volume > 0 : volumes[c].is_inside_out();
  };
  for (Index c = 0; c < volumes.size(); ++c) {
    const Index inner = around.innermost[c];
    voids.bodies.push_back(is_negative(c) && !is_negative(inner) ? inner : none);
  }
  set_signs();
  return voids;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_ORIENT_FACES_H
