// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COVERED_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COVERED_FACES_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/sorted_indices.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>
#include <CGAL/Region_segmentation/internal/surface/find_crumbs.h>
#include <CGAL/Region_segmentation/internal/surface/find_nearest_face.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
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
  /// Sets the originals of covered faces: the faces on which they lie.
  Covered_faces(const Surface& surface, std::vector<Index>& originals)
    : m_surface(surface)
    , m_bodies(surface)
  {
    const std::vector<Index> components = components_on_larger_ones();
    if (components.empty())
      return;
    m_tree.emplace(surface, m_bodies.component_of);
    m_places.resize(surface.number_of_vertices());
    const std::vector<std::size_t> open_sides = numbers_of_open_sides();
    const Grouped_items<Index> faces_of(open_sides.size(), [&](const auto& add) {
      for (Index f = 0; f < m_bodies.component_of.size(); ++f)
        add(m_bodies.component_of[f], f);
    });
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

  /// Those in contact with a larger one, but for crumbs; larger ones first.
  std::vector<Index> components_on_larger_ones() const
  {
    std::vector<bool> is_on_larger(m_bodies.areas.size());
    for (std::size_t a = 0; a < m_surface.number_of_adjacencies(); ++a)
      if (m_surface.has_flag(a, Surface::LINK) && m_surface.length(a) > 0) {
        const Index c = m_bodies.component_of[m_surface.lower_face(a)],
                    d = m_bodies.component_of[m_surface.higher_face(a)];
        if (const Index smaller = is_larger(c, d) ? d : c; !m_bodies.is_crumb[smaller])
          is_on_larger[smaller] = true;
      }
    std::vector<Index> result;
    for (const Index c :
         sorted_indices(m_bodies.areas.size(), [&](Index c, Index d) { return is_larger(c, d); }))
      if (is_on_larger[c])
        result.push_back(c);
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

  /// A face of a larger component within the tolerance, `otherwise` if there is none: the nearest
  /// one with a similar normal, or, without a normal, any.
  Index nearest(Index component, const Double_3& point, const Double_3& normal, Index otherwise)
  {
    const double tolerance = std::sqrt(m_bodies.areas[component]) / 100;
    Cost_of_face best(tolerance, otherwise); // costs of faces that do not agree are above it
    const bool is_any = squared_norm(normal) == 0;
    find_nearest_face(
      *m_tree, Component_tree::root(), point,
      [&](const auto& node) {
        return !(is_any && best.second != otherwise) &&
               (node.component == Component_tree::none || is_larger(node.component, component));
      },
      [&](Index g) {
        return is_any || dot(normal, m_surface.normal(g)) > least_cosine ? 0 : 2 * tolerance;
      },
      best);
    return best.second;
  }

  const Surface& m_surface;
  const Bodies m_bodies;
  std::optional<Component_tree> m_tree; // where a component is in contact with a larger one
  std::vector<Place> m_places;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COVERED_FACES_H
