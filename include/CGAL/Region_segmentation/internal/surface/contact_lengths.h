// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_CONTACT_LENGTHS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_CONTACT_LENGTHS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/Link.h>
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

/// The contacts of two components, seen from one of them: sums by face.
class Contact_side
{
public:
  using Index = Surface::Index;
  using Iterator = std::vector<Face_contact>::const_iterator;
  static constexpr int number_of_kinds = 3;

  struct Face
  {
    Index face;
    std::array<double, number_of_kinds> sums{};    ///< of amounts
    std::array<double, number_of_kinds> largest{}; ///< amount
    std::array<Index, number_of_kinds> partners{}; ///< the faces that have it
  };

  /// `side`: 0 or 1, the index in `Face_contact::faces`
  Contact_side(const Surface& surface, Iterator begin, Iterator end, std::size_t side)
    : m_surface(surface)
  {
    std::vector<std::pair<Index, Index>> order; // a face, a contact of it
    for (Iterator c = begin; c != end; ++c)
      order.push_back({c->faces[side], Index(c - begin)});
    std::sort(order.begin(), order.end());
    for (const auto& [face, i] : order)
      add(face, begin[i].faces[1 - side], begin[i].contact);
  }

  const std::vector<Face>& faces() const { return m_faces; }

  std::size_t number_of_faces(std::size_t kind) const
  {
    return std::size_t(std::count_if(m_faces.begin(), m_faces.end(),
                                     [&](const Face& f) { return f.sums[kind] > 0; }));
  }

  double sum(std::size_t kind) const
  {
    return sum_of_faces([&](const Face& f) { return f.sums[kind]; });
  }

  /// An edge counts once, however many faces of the other component it lies on.
  double length_along_edges() const
  {
    return sum_of_faces([&](const Face& f) {
      return (std::min)(f.sums[Triangle_contact::ALONG_EDGE], lengths(f.face).longest);
    });
  }

  double touching_area() const
  {
    return sum_of_faces([&](const Face& f) { return fraction(f) * m_surface.area(f.face); });
  }

  /// In (0, 1]: 1 if each face is in contact wholly or not at all.
  double resolution() const
  {
    const double area = touching_area();
    const double sum = sum_of_faces(
      [&](const Face& f) { return fraction(f) * fraction(f) * m_surface.area(f.face); });
    return area > 0 ? sum / area : 0;
  }

  /// The length of the border of the contact area: sum over edges of length |u_f - u_g|, with u the
  /// fraction of a face in contact, 0 beyond a border. Exact if the border runs along edges of this
  /// component.
  double border_of_touching_area() const
  {
    double result = 0;
    for (const Face& f : m_faces) {
      const double u = fraction(f);
      if (!(u > 0))
        continue;
      result += u * lengths(f.face).sum;
      const std::size_t end = m_surface.first_adjacency(std::size_t(f.face) + 1);
      for (std::size_t a = m_surface.first_adjacency(f.face); a < end; ++a)
        result -= 2 * m_surface.length(a) * (std::min)(u, fraction_of(m_surface.lower_face(a)));
    }
    return (std::max)(result, 0.0);
  }

private:
  struct Lengths
  {
    double sum = 0, longest = 0;
  };

  template <typename F>
  double sum_of_faces(const F& value) const
  {
    double result = 0;
    for (const Face& f : m_faces)
      result += value(f);
    return result;
  }

  void add(Index face, Index partner, const Triangle_contact& contact)
  {
    if (m_faces.empty() || m_faces.back().face != face) {
      m_faces.emplace_back();
      m_faces.back().face = face;
    }
    Face& f = m_faces.back();
    f.sums[contact.kind] += contact.amount;
    if (contact.amount > f.largest[contact.kind]) {
      f.largest[contact.kind] = contact.amount;
      f.partners[contact.kind] = partner;
    }
  }

  Lengths lengths(Index face) const
  {
    Lengths result;
    for_each_side(m_surface, face, [&](Index v, Index w) {
      const double length = norm(m_surface.point(w) - m_surface.point(v));
      result.sum += length;
      result.longest = (std::max)(result.longest, length);
    });
    return result;
  }

  double fraction(const Face& f) const
  {
    const double area = f.sums[Triangle_contact::TOUCHING];
    return area > 0 ? (std::min)(1.0, area / m_surface.area(f.face)) : 0;
  }

  double fraction_of(Index face) const
  {
    const auto f = std::lower_bound(m_faces.begin(), m_faces.end(), face,
                                    [](const Face& g, Index i) { return g.face < i; });
    return f != m_faces.end() && f->face == face ? fraction(*f) : 0;
  }

  const Surface& m_surface;
  std::vector<Face> m_faces; // ascending
};

using Contact_sides = std::array<Contact_side, 2>;

/// The length of the border of the contact area, from the side whose faces are more wholly in
/// contact; not below that of a disc of this area.
inline double border_of_touching_area(const Contact_sides& sides, double area)
{
  constexpr double pi = 3.14159265358979323846, almost_one = 1 - 1e-9;
  const double r = sides[0].resolution(), s = sides[1].resolution();
  double border = 0;
  if (r >= almost_one * s)
    border = sides[0].border_of_touching_area();
  if (s >= almost_one * r)
    border = (std::max)(border, sides[1].border_of_touching_area());
  return (std::max)(border, 2 * std::sqrt(pi * area));
}

/// Which kind of contact two components have, and its length.
struct Contact_length
{
  Contact_length(const Contact_sides& sides, double tolerance)
  {
    const double area = (std::min)(sides[0].touching_area(), sides[1].touching_area());
    const double along = (std::min)(sides[0].length_along_edges(), sides[1].length_along_edges());
    const double crossing = sides[0].sum(Triangle_contact::CROSSING);
    const double resolution = (std::max)(sides[0].resolution(), sides[1].resolution());
    const bool is_strip = area <= tolerance * along && resolution < 0.5; // mere slivers of faces
                                                                         // touch
    kind = is_strip ? Triangle_contact::ALONG_EDGE : Triangle_contact::TOUCHING;
    length = is_strip ? along : border_of_touching_area(sides, area);
    if (crossing > length) {
      kind = Triangle_contact::CROSSING;
      length = crossing;
    }
  }

  Triangle_contact::Kind kind;
  double length;
};

/// Links for the contacts of two components: one for each face in contact of the component that has
/// more of them, with the face that it shares most with. The length of contact is divided among
/// them as areas or lengths are.
inline void add_links_of_pair(const Contact_sides& sides, const Contact_length& contact,
                              std::vector<Link>& links)
{
  const std::size_t k = contact.kind;
  const Contact_side&
    side = sides[sides[1].number_of_faces(k) > sides[0].number_of_faces(k) ? 1 : 0];
  const double sum = side.sum(k);
  for (const Contact_side::Face& f : side.faces())
    if (f.sums[k] > 0) {
      const Surface::Index g = f.partners[k];
      links.push_back(
        {(std::min)(f.face, g), (std::max)(f.face, g), f.sums[k] / sum * contact.length});
    }
}

/// \pre the contacts are sorted by components, then by faces
inline std::vector<Link> links_of_contacts(const Surface& surface,
                                           const Partition& component_of_face,
                                           const std::vector<double>& tolerances,
                                           const std::vector<Face_contact>& contacts)
{
  std::vector<Link> result;
  const auto components = [&](const Face_contact& c) {
    return std::make_pair(component_of_face[c.faces[0]], component_of_face[c.faces[1]]);
  };
  for (auto begin = contacts.begin(); begin != contacts.end();) {
    const auto pair = components(*begin);
    const auto end = std::find_if(begin, contacts.end(),
                                  [&](const auto& c) { return components(c) != pair; });
    const Contact_sides sides{Contact_side(surface, begin, end, 0),
                              Contact_side(surface, begin, end, 1)};
    const double tolerance = (std::min)(tolerances[pair.first], tolerances[pair.second]);
    add_links_of_pair(sides, Contact_length(sides, tolerance), result);
    begin = end;
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_CONTACT_LENGTHS_H
