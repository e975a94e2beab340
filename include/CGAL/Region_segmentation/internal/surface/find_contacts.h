// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_CONTACTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_CONTACTS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>
#include <CGAL/Region_segmentation/internal/surface/Triangle_contact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A contact of triangles of two faces, the first one in the component of lower number.
struct Face_contact
{
  std::array<Surface::Index, 2> faces;
  Triangle_contact contact;
};

/// Finds the faces of different components that are in contact: those of components c and d within
/// the smaller of their tolerances, and within the square root of the area of the smaller face. O(F
/// log F) for a bounded number of faces of other components near each face.
class Contact_finder
{
public:
  using Index = Surface::Index;

  Contact_finder(const Surface& surface, Component_tree& tree, const Partition& component_of_face)
    : m_surface(surface)
    , m_tree(tree)
    , m_component_of(component_of_face)
  {}

  /// Sorted by components, then by faces.
  std::vector<Face_contact> find(const Execution& execution)
  {
    Step_counter counter(execution, m_number_left);
    visit(m_tree.root(), m_tree.root(), counter);
    const auto key = [&](const Face_contact& c) {
      return std::make_tuple(m_component_of[c.faces[0]], m_component_of[c.faces[1]], c.faces,
                             c.contact.kind, c.contact.amount);
    };
    std::sort(m_contacts.begin(), m_contacts.end(),
              [&](const Face_contact& c, const Face_contact& d) { return key(c) < key(d); });
    return std::move(m_contacts);
  }

private:
  double tolerance(Index a, Index b) const
  {
    return (std::min)(m_tree[a].tolerance, m_tree[b].tolerance);
  }
  double squared_tolerance(Index a, Index b) const { return tolerance(a, b) * tolerance(a, b); }

  void visit(Index a, Index b, Step_counter& counter)
  {
    if (m_number_left == 0)
      return;
    counter.advance();
    if (a == b) {
      if (m_tree[a].component != Component_tree::none)
        return;
      const Index child = m_tree.children(a);
      visit(child, child + 1, counter);
      visit(child + 1, child + 1, counter);
      visit(child, child, counter);
    } else if (squared_gap(m_tree[a].box, m_tree[b].box) <= squared_tolerance(a, b)) {
      const Index node = m_tree.node_to_divide(a, b), other = node == a ? b : a;
      if (node == Component_tree::none)
        return compare_faces(a, b);
      const Index child = m_tree.children(node);
      visit(child + 1, other, counter);
      visit(child, other, counter);
    }
  }

  /// \pre both nodes are leaves
  void compare_faces(Index a, Index b)
  {
    if (m_tree[a].component > m_tree[b].component)
      std::swap(a, b);
    const double bound = squared_tolerance(a, b);
    m_tree.for_each_near(
      a, b, bound,
      [&](const Component_tree::Part& p, const Component_tree::Part& q, double squared_gap) {
        const double squared = (std::min)({bound, m_surface.area(p.face), m_surface.area(q.face)});
        if (squared_gap > squared)
          return;
        if (m_number_left > 0)
          --m_number_left;
        find_contact(m_tree.triangle(p), m_tree.triangle(q), std::sqrt(squared),
                     [&](const Triangle_contact& c) {
                       m_contacts.push_back({{p.face, q.face}, c});
                     });
      });
  }

  const Surface& m_surface;
  Component_tree& m_tree;
  const Partition& m_component_of;
  std::vector<Face_contact> m_contacts;
  /// Of the pairs that are compared; further contacts are not found.
  std::size_t m_number_left = Component_tree::most_pairs(m_component_of.size());
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_CONTACTS_H
