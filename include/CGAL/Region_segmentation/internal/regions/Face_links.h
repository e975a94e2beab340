// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FACE_LINKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FACE_LINKS_H

#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The edge of a face that starts at one of its corners.
struct Face_edge
{
  using Index = Surface::Index;
  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

  Index face, corner;

  bool exists() const { return face != no_face; }
};

/// What is across each edge of each face: the links that a path over the surface follows. Edges are numbered face by
/// face. Faces without a normal are not linked. O(F log F); 12 bytes an edge of a face.
class Face_links
{
public:
  using Index = Surface::Index;

  explicit Face_links(const Surface& flat) : m_surface(flat)
  {
    m_first_edges.reserve(flat.number_of_faces() + 1);
    m_first_edges.push_back(0);
    for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
      m_first_edges.push_back(m_first_edges.back() + Index(m_surface.number_of_corners(f)));
    m_opposite.assign(m_first_edges.back(), Face_edge{Face_edge::no_face, 0});
    link(flat);
  }

  std::size_t number_of_edges() const { return m_opposite.size(); }
  std::size_t number(const Face_edge& e) const { return m_first_edges[e.face] + e.corner; }
  Face_edge opposite(const Face_edge& e) const { return m_opposite[number(e)]; }

  const Double_3& source(const Face_edge& e) const { return m_surface.point(m_surface.corner(e.face, e.corner)); }
  const Double_3& target(const Face_edge& e) const { return m_surface.point(vertex_after(e)); }

private:
  struct Entry
  {
    Index lower, higher; // vertices
    Face_edge edge;
  };

  Index vertex_after(const Face_edge& e) const
  {
    return m_surface.corner(e.face, e.corner + 1 < m_surface.number_of_corners(e.face) ? e.corner + 1 : 0);
  }

  void link(const Surface& flat)
  {
    std::vector<Entry> entries;
    entries.reserve(m_opposite.size());
    for (Index f = 0; f < flat.number_of_faces(); ++f)
      for (Index i = 0; !flat.is_degenerate(f) && i < m_surface.number_of_corners(f); ++i) {
        const Index a = m_surface.corner(f, i), b = vertex_after({f, i});
        entries.push_back({(std::min)(a, b), (std::max)(a, b), {f, i}});
      }
    const auto key = [](const Entry& e) { return std::tie(e.lower, e.higher, e.edge.face, e.edge.corner); };
    std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) { return key(a) < key(b); });
    // Two edges between the same two vertices cannot be told apart: they stay unlinked.
    for (std::size_t i = 0, end = 0; i < entries.size(); i = end) {
      while (end < entries.size() && entries[end].lower == entries[i].lower && entries[end].higher == entries[i].higher)
        ++end;
      if (end == i + 2 && entries[i].edge.face != entries[i + 1].edge.face) {
        m_opposite[number(entries[i].edge)] = entries[i + 1].edge;
        m_opposite[number(entries[i + 1].edge)] = entries[i].edge;
      }
    }
  }

  const Surface& m_surface;
  std::vector<Index> m_first_edges; // by face, and one more at the end
  std::vector<Face_edge> m_opposite;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FACE_LINKS_H
