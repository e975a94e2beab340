// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_CONTACT_LENGTHS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_CONTACT_LENGTHS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Added_adjacency.h>
#include <CGAL/Region_segmentation/internal/surface/find_contacts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The contacts of two components, seen from one of them: by face, and sums of all faces.
struct Contact_side
{
  using Index = Surface::Index;
  using Iterator = std::vector<Face_contact>::const_iterator;
  static constexpr std::size_t number_of_kinds = 3;

  struct Face
  {
    Index face;
    std::array<double, number_of_kinds> sums{};    ///< of amounts
    std::array<double, number_of_kinds> largest{}; ///< amount
    std::array<Index, number_of_kinds> partners{}; ///< the faces that have it
    double fraction = 0;                           ///< of its area that touches
    double perimeter = 0;
  };

  std::vector<Face> faces; ///< ascending
  std::array<double, number_of_kinds> sums{};
  std::array<std::size_t, number_of_kinds> numbers_of_faces{};
  /// An edge counts once, however many faces of the other component it lies on.
  double length_along_edges = 0;
  double touching_area = 0;
  /// In (0, 1]: 1 if each face touches wholly or not at all. 0 if none does.
  double resolution = 0;

  /// `side`: 0 or 1, the index in `Face_contact::faces`
  Contact_side(const Surface& surface, Iterator begin, Iterator end, std::size_t side)
  {
    std::vector<std::pair<Index, Index>> order; // a face, a contact of it
    for (Iterator c = begin; c != end; ++c)
      order.push_back({c->faces[side], Index(c - begin)});
    std::sort(order.data(), order.data() + order.size());
    for (const auto& [face, i] : order)
      add(face, begin[i].faces[1 - side], begin[i].contact);
    double sum_of_squares = 0;
    for (Face& f : faces) {
      double longest_edge = 0;
      for_each_side(surface, f.face, [&](Index v, Index w) {
        const double length = norm(surface.point(w) - surface.point(v));
        f.perimeter += length;
        longest_edge = (std::max)(longest_edge, length);
      });
      const double area = surface.area(f.face), touching = f.sums[Triangle_contact::TOUCHING];
      f.fraction = touching > 0 ? (std::min)(1.0, touching / area) : 0;
      for (std::size_t kind = 0; kind < number_of_kinds; ++kind) {
        sums[kind] += f.sums[kind];
        numbers_of_faces[kind] += f.sums[kind] > 0;
      }
      length_along_edges += (std::min)(f.sums[Triangle_contact::ALONG_EDGE], longest_edge);
      touching_area += f.fraction * area;
      sum_of_squares += f.fraction * f.fraction * area;
    }
    resolution = touching_area > 0 ? sum_of_squares / touching_area : 0;
  }

  /// The length of the border of the contact area: sum over edges of length |u_f - u_g|, with u the
  /// fraction of a face in contact, 0 beyond a border. Exact if the border runs along edges of this
  /// component.
  double border_of_touching_area(const Surface& surface) const
  {
    double result = 0;
    for (const Face& f : faces) {
      if (!(f.fraction > 0))
        continue;
      result += f.fraction * f.perimeter;
      const std::size_t end = surface.first_adjacency(std::size_t(f.face) + 1);
      for (std::size_t a = surface.first_adjacency(f.face); a < end; ++a)
        result -= 2 * surface.length(a) *
                  (std::min)(f.fraction, fraction_of(surface.lower_face(a)));
    }
    return (std::max)(result, 0.0);
  }

private:
  void add(Index face, Index partner, const Triangle_contact& contact)
  {
    if (faces.empty() || faces.back().face != face)
      faces.push_back({face});
    Face& f = faces.back();
    f.sums[contact.kind] += contact.amount;
    if (contact.amount > f.largest[contact.kind]) {
      f.largest[contact.kind] = contact.amount;
      f.partners[contact.kind] = partner;
    }
  }

  double fraction_of(Index face) const
  {
    const auto f = std::lower_bound(faces.begin(), faces.end(), face,
                                    [](const Face& g, Index i) { return g.face < i; });
    return f != faces.end() && f->face == face ? f->fraction : 0;
  }
};

using Contact_sides = std::array<Contact_side, 2>;

/// The length of the border of the contact area, from the side whose faces are more wholly in
/// contact; not below that of a disc of this area.
inline double border_of_touching_area(const Surface& surface, const Contact_sides& sides,
                                      double area)
{
  constexpr double pi = 3.14159265358979323846, almost_one = 1 - 1e-9;
  const double resolution = (std::max)(sides[0].resolution, sides[1].resolution);
  double border = 2 * std::sqrt(pi * area);
  for (const Contact_side& side : sides)
    if (side.resolution >= almost_one * resolution)
      border = (std::max)(border, side.border_of_touching_area(surface));
  return border;
}

/// Which kind of contact two components have, and its length.
inline Triangle_contact contact_of_components(const Surface& surface, const Contact_sides& sides,
                                              double tolerance)
{
  const double area = (std::min)(sides[0].touching_area, sides[1].touching_area);
  const double along = (std::min)(sides[0].length_along_edges, sides[1].length_along_edges);
  const double crossing = sides[0].sums[Triangle_contact::CROSSING];
  const double resolution = (std::max)(sides[0].resolution, sides[1].resolution);
  const bool is_strip = area <= tolerance * along && resolution < 0.5; // mere slivers touch
  const Triangle_contact result = is_strip ? Triangle_contact{Triangle_contact::ALONG_EDGE, along}
                                           : Triangle_contact{
                                               Triangle_contact::TOUCHING,
                                               border_of_touching_area(surface, sides, area)};
  return crossing > result.amount ? Triangle_contact{Triangle_contact::CROSSING, crossing} : result;
}

/// Links for the contacts of two components: one for each face in contact of the component that has
/// more of them, with the face that it shares most with. The length of contact is divided among
/// them as areas or lengths are.
inline void add_links_of_pair(const Contact_sides& sides, const Triangle_contact& contact,
                              std::vector<Added_adjacency>& links)
{
  const std::size_t k = contact.kind;
  const Contact_side&
    side = sides[sides[1].numbers_of_faces[k] > sides[0].numbers_of_faces[k] ? 1 : 0];
  for (const Contact_side::Face& f : side.faces)
    if (f.sums[k] > 0)
      links.push_back(link_of(f.face, f.partners[k], f.sums[k] / side.sums[k] * contact.amount));
}

/// \pre the contacts are sorted by components, then by faces
inline std::vector<Added_adjacency> links_of_contacts(const Surface& surface,
                                                      const Partition& component_of_face,
                                                      const std::vector<double>& tolerances,
                                                      const std::vector<Face_contact>& contacts)
{
  std::vector<Added_adjacency> result;
  const auto components = [&](const Face_contact& c) {
    return std::make_pair(component_of_face[c.faces[0]], component_of_face[c.faces[1]]);
  };
  for (auto begin = contacts.begin(); begin != contacts.end();) {
    const auto pair = components(*begin);
    auto end = begin;
    while (end != contacts.end() && components(*end) == pair)
      ++end;
    const Contact_sides sides{Contact_side(surface, begin, end, 0),
                              Contact_side(surface, begin, end, 1)};
    const double tolerance = (std::min)(tolerances[pair.first], tolerances[pair.second]);
    add_links_of_pair(sides, contact_of_components(surface, sides, tolerance), result);
    begin = end;
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_CONTACT_LENGTHS_H
