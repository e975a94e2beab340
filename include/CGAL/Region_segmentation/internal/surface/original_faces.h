// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIGINAL_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIGINAL_FACES_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/find_crumbs.h>
#include <CGAL/Region_segmentation/internal/surface/find_doubled_faces.h>
#include <CGAL/Region_segmentation/internal/surface/find_nearest_face.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the faces of overlapping scans: those whose corners all lie on faces of larger components,
/// within 1/100 of the square root of the area of their own, and whose centroid lies on one with a
/// similar normal. They are *covered* if they make a quarter of the area of an open component or
/// all of a closed one, and lie partly above, partly below the larger ones, an eighth of their area
/// at least: layers do not cross, and bodies that touch each other have opposite normals there.
///
/// Only components in contact with a larger one are looked at. O(log F) a vertex of these.
class Covered_faces
{
  using Index = Surface::Index;

public:
  Covered_faces(const Surface& surface, std::vector<Index>& originals)
    : m_surface(surface)
    , m_bodies(surface)
    , m_tree(surface, m_bodies.component_of)
    , m_places(surface.number_of_vertices())
  {
    const std::vector<bool> touches = components_on_larger_ones();
    const std::vector<std::size_t> open_sides = numbers_of_open_sides();
    const auto faces_of = grouped<Index>(touches.size(), [&](const auto& add) {
      for (Index f = 0; f < m_bodies.component_of.size(); ++f)
        if (touches[m_bodies.component_of[f]])
          add(m_bodies.component_of[f], f);
    });
    std::vector<Index> components(touches.size());
    std::iota(components.begin(), components.end(), Index(0));
    std::sort(components.begin(), components.end(),
              [&](Index c, Index d) { return is_larger(c, d); });
    for (const Index c : components)
      find(c, faces_of[c], open_sides[c] > 0, originals);
  }

  /// Whether an adjacency is left out where faces are their originals: that of two covered ones,
  /// and a link between faces of one component then.
  bool is_left_out(std::size_t a, const std::vector<Index>& originals) const
  {
    const Index f = m_surface.lower_face(a), g = m_surface.higher_face(a);
    if (originals[f] == f && originals[g] == g)
      return false;
    return m_surface.has_flag(a, Surface::LINK)
             ? m_bodies.component_of[originals[f]] == m_bodies.component_of[originals[g]]
             : originals[f] != f && originals[g] != g;
  }

private:
  static constexpr double least_share = 0.25, least_share_of_side = 0.125, least_cosine = 0.5,
                          rounding = 1e-6;

  struct Place // of a vertex
  {
    Index component = (std::numeric_limits<Index>::max)(); // for which it was looked at
    bool is_on_larger = false;
  };

  bool is_larger(Index c, Index d) const
  {
    return m_bodies.areas[c] != m_bodies.areas[d] ? m_bodies.areas[c] > m_bodies.areas[d] : c < d;
  }

  std::vector<bool> components_on_larger_ones() const
  {
    std::vector<bool> result(m_bodies.areas.size());
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
      if (m_surface.has_flag(a, Surface::LINK) && m_surface.length(a) > 0) {
        const Index c = m_bodies.component_of[m_surface.lower_face(a)],
                    d = m_bodies.component_of[m_surface.higher_face(a)];
        const Index smaller = is_larger(c, d) ? d : c;
        result[smaller] = !m_bodies.is_crumb(smaller);
      }
    return result;
  }

  /// By component.
  std::vector<std::size_t> numbers_of_open_sides() const
  {
    std::vector<std::size_t> result(m_bodies.areas.size());
    for (std::size_t f = 0; f < m_surface.number_of_faces(); ++f)
      result[m_bodies.component_of[f]] += m_surface.number_of_corners(f);
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
      if (!m_surface.has_flag(a, Surface::LINK)) {
        std::size_t& n = result[m_bodies.component_of[m_surface.lower_face(a)]];
        n -= (std::min)(n, std::size_t(2));
      }
    return result;
  }

  template <typename Faces>
  void find(Index component, const Faces& faces, bool is_open, std::vector<Index>& originals)
  {
    std::vector<std::pair<Index, Index>> covered;
    double area = 0, area_above = 0, area_below = 0;
    for (const Index f : faces)
      if (const Index g = face_below(component, f); g != f) {
        covered.push_back({f, g});
        const double a = m_surface.area(f), height = height_above(g, m_surface.centroid(f));
        area += a;
        area_above += height > -rounding * m_surface.length_unit() ? a : 0;
        area_below += height < rounding * m_surface.length_unit() ? a : 0;
      } else if (!is_open && !m_surface.is_degenerate(f))
        return;
    if (!(area >= least_share * m_bodies.areas[component]) ||
        !((std::min)(area_above, area_below) >= least_share_of_side * area))
      return;
    for (const auto& [f, g] : covered)
      originals[f] = originals[g];
  }

  double height_above(Index f, const Double_3& point) const
  {
    return dot(point - m_surface.point(m_surface.corner(f, 0)), m_surface.normal(f));
  }

  /// The face of a larger component on which a face lies, or itself.
  Index face_below(Index component, Index f)
  {
    for (std::size_t i = 0; i < m_surface.number_of_corners(f); ++i) {
      const Index v = m_surface.corner(f, i);
      Place& place = m_places[v];
      if (place.component != component)
        place = {component, nearest(component, m_surface.point(v), {0, 0, 0}, f) != f};
      if (!place.is_on_larger)
        return f;
    }
    return nearest(component, m_surface.centroid(f), m_surface.normal(f), f);
  }

  /// The nearest face of a larger component, `otherwise` if none is within the tolerance.
  Index nearest(Index component, const Double_3& point, const Double_3& normal, Index otherwise)
  {
    const double tolerance = std::sqrt(m_bodies.areas[component]) / 100;
    Cost_of_face best(tolerance, otherwise);
    find_nearest_face(
      m_tree, Component_tree::root(), point,
      [&](const auto& node) {
        return node.component == Component_tree::none || is_larger(node.component, component);
      },
      [&](Index g) {
        return squared_norm(normal) == 0 || dot(normal, m_surface.normal(g)) > least_cosine
                 ? 0
                 : tolerance;
      },
      best);
    return best.second;
  }

  const Surface& m_surface;
  const Bodies m_bodies;
  Component_tree m_tree;
  std::vector<Place> m_places;
};

/// Which faces of a surface are one.
struct Original_faces
{
  using Index = Surface::Index;

  /// By face: the one that it is given twice with, or that it lies on, or else itself.
  std::vector<Index> of;
  /// Adjacencies that the surface without other faces does not have; empty: none.
  std::vector<bool> is_left_out;

  Original_faces() = default;
  explicit Original_faces(const Surface& surface)
    : of(surface.number_of_faces())
  {
    std::iota(of.begin(), of.end(), Index(0));
    bool has_contacts = false;
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const Index lower = surface.lower_face(a), higher = surface.higher_face(a);
      if (surface.has_flag(a, Surface::JOINING) && surface.is_degenerate(higher) &&
          are_equal_faces(surface, lower, higher))
        of[higher] = lower;
      has_contacts = has_contacts || (surface.has_flag(a, Surface::LINK) && surface.length(a) > 0);
    }
    if (!has_contacts)
      return;
    const Covered_faces covered(surface, of);
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
      is_left_out.push_back(covered.is_left_out(a, of));
  }

  bool is_original(std::size_t f) const { return of[f] == f; }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIGINAL_FACES_H
