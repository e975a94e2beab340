// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FIND_LINKS_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FIND_LINKS_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A link between two faces, with the length of their contact, which is 0 for a gap.
inline Added_adjacency link_of(Surface::Index f, Surface::Index g, double length)
{
  return {(std::min)(f, g), (std::max)(f, g), length * length, Surface::LINK};
}

/// Finds the links between components: between faces that are in contact, and between the nearest
/// faces of components that are not connected by these.
class Link_finder
{
public:
  using Index = Surface::Index;

  /// \pre there are two components or more
  Link_finder(const Surface& surface, const Partition& component_of, const Execution& execution)
    : m_surface(surface)
    , m_component_of(component_of)
    , m_tree(surface)
    , m_groups(component_of.number_of_parts())
    , m_number_of_groups(component_of.number_of_parts())
    , m_number_left(64 * component_of.size() + 1000000)
    , m_counter(execution, m_number_left)
  {}

  std::vector<Added_adjacency> find()
  {
    add_contacts();
    while (m_number_of_groups > 1)
      join_nearest();
    return std::move(m_links);
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Two faces whose distance is below a bound, or none.
  struct Nearest
  {
    double squared_distance; ///< of the faces; before a pair is found, the bound of the search
    Index face = none, other = none;
  };

  /// Links each face with the nearest face of another component that is in contact with it. Two
  /// faces are in contact if their distance is less than the square root of the area of either
  /// face, and less than 1/250 of the square root of the area of either component: so neither a
  /// large body nor a crumb far away changes which parts touch each other. However fine the faces
  /// are, the lengths of the links between two components add up to about the length of the border
  /// of their contact: the faces of either component count half of it.
  void add_contacts()
  {
    std::vector<double> bounds = part_areas(m_surface, m_component_of); // of squared distances
    for (double& bound : bounds)
      bound /= 250 * 250;
    const auto bound_of_face = [&](Index f) {
      return (std::min)(bounds[m_component_of[f]], m_surface.area(f));
    };
    std::vector<Nearest> nearest;
    for (Index f = 0; f < m_component_of.size(); ++f)
      nearest.push_back({bound_of_face(f)});
    search(
      [&](Index component, Index node) {
        return m_tree.boxes().is_leaf(node) ? nearest[m_tree.face(node)].squared_distance
                                            : bounds[component];
      },
      [&](Index, Index node, Index other) {
        Nearest& n = nearest[m_tree.face(node)];
        compare(node, other, (std::min)(n.squared_distance, bound_of_face(m_tree.face(other))), n);
      });
    const std::vector<double> borders = border_lengths(nearest);
    for (const Nearest& n : nearest)
      if (n.face != none)
        add_link(n, (std::min)(borders[n.face], perimeter(n.other)) / 2);
  }

  /// By face in contact with a component: the length of its sides to faces that are not in contact
  /// with the same component.
  std::vector<double> border_lengths(const std::vector<Nearest>& nearest) const
  {
    const auto partner = [&](Index f) {
      return nearest[f].face == none ? none : m_component_of[nearest[f].other];
    };
    std::vector<double> result;
    for (Index f = 0; f < nearest.size(); ++f)
      result.push_back(partner(f) == none ? 0 : perimeter(f));
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a) {
      const Index f = m_surface.lower_face(a), g = m_surface.higher_face(a);
      if (partner(f) != none && partner(f) == partner(g))
        for (const Index face : {f, g})
          result[face] = (std::max)(result[face] - m_surface.length(a), 0.0);
    }
    return result;
  }

  double perimeter(Index face) const
  {
    double result = 0;
    for_each_side(m_surface, face, [&](Index v, Index w) {
      result += norm(m_surface.point(w) - m_surface.point(v));
    });
    return result;
  }

  /// A round of Boruvka's algorithm: links each group of linked components with the nearest other
  /// group, where that does not close a cycle.
  void join_nearest()
  {
    std::vector<Nearest> nearest(m_component_of.number_of_parts(), Nearest{infinity}); // by group
    search([&](Index group, Index) { return nearest[group].squared_distance; },
           [&](Index group, Index node, Index other) {
             compare(node, other, nearest[group].squared_distance, nearest[group]);
           });
    for (const Nearest& n : nearest)
      if (n.face != none &&
          m_groups.root(m_component_of[n.face]) != m_groups.root(m_component_of[n.other]))
        add_link(n, 0);
  }

  /// Calls `f(group, leaf, other)` for pairs of leaves of the tree, `leaf` in the group and `other`
  /// in another group, if the squared distance of their boxes is below `bound(group, leaf)`, and
  /// the same is true of the nodes above them. `f` may lower bounds. Once too many leaves are
  /// compared, as where thousands of triangles cross each other, only nodes with an infinite bound
  /// are visited.
  template <typename Bound, typename F>
  void search(const Bound& bound, const F& f)
  {
    const Box_tree& boxes = m_tree.boxes();
    const std::vector<Index> groups = boxes.values(
      [&](Index leaf) { return m_groups.root(m_component_of[m_tree.face(leaf)]); },
      [](Index g, Index h) { return g == h ? g : none; });
    boxes.for_each_topmost(
      [&](Index node) { return groups[node] != none; },
      [&](Index top) {
        const Index group = groups[top];
        const auto is_left_out = [&](Index a, Index b) {
          const double largest = bound(group, a);
          return groups[b] == group || squared_gap(boxes.box(a), boxes.box(b)) >= largest ||
                 (m_number_left == 0 && largest < infinity);
        };
        boxes.for_each_pair(top, 0, is_left_out, [&](Index a, Index b) { f(group, a, b); });
      });
  }

  /// Replaces `nearest` if the squared distance of two leaves is below `bound`.
  void compare(Index leaf, Index other, double bound, Nearest& nearest)
  {
    m_counter.advance();
    m_number_left -= m_number_left > 0;
    const Triangle s = m_tree.triangle(leaf), t = m_tree.triangle(other);
    if (squared_separation(s, t) >= bound)
      return;
    if (const double squared = squared_distance(s, t); squared < bound)
      nearest = {squared, m_tree.face(leaf), m_tree.face(other)};
  }

  void add_link(const Nearest& n, double length)
  {
    m_links.push_back(link_of(n.face, n.other, length));
    m_number_of_groups -= m_groups.unite(m_component_of[n.face], m_component_of[n.other]);
  }

  const Surface& m_surface;
  const Partition& m_component_of;
  const Face_tree m_tree;
  std::vector<Added_adjacency> m_links;
  Lowest_root_forest m_groups; // sets of components with links between them
  std::size_t m_number_of_groups, m_number_left;
  Step_counter m_counter;
};

/// The links between components, which are connected by edges and seams.
///
/// One component has no links, which takes no time; more take O(F log F) in practice.
inline std::vector<Added_adjacency>
find_links(const Surface& surface, const Partition& component_of, const Execution& execution)
{
  if (component_of.number_of_parts() < 2)
    return {};
  return Link_finder(surface, component_of, execution).find();
}

/// Adds links between sets of faces that edges and seams do not connect, and marks crumbs:
/// components of less than 1/1000 of the area of the largest one.
inline void Surface_builder::link_components(const Execution& execution)
{
  if (number_of_components() < 2)
    return;
  insert_adjacencies(find_links(*this,
                                label_components(
                                  *this, [](std::size_t) { return true; }, execution.silent()),
                                execution));
  const std::vector<double> areas = part_areas(*this, m_component_of);
  const auto [least, greatest] = std::minmax_element(areas.begin(), areas.end());
  if (const double bound = 1e-3 * *greatest; *least < bound)
    for (const double area : areas)
      m_crumbs.push_back(area < bound);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FIND_LINKS_H
