// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_NEIGHBORS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_NEIGHBORS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(adjacency, i, j)` for the adjacencies across edges and seams of faces with different
/// labels i and j: those of the lower and of the higher face.
template <typename Labels, typename F>
void for_each_border(const Surface& surface, const Labels& labels, const F& f)
{
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Surface::Index i = labels[surface.lower_face(a)], j = labels[surface.higher_face(a)];
    if (i != j && !surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED))
      f(a, i, j);
  }
}

/// The faces adjacent to each face across edges and seams, and whether they go on smoothly there.
class Face_neighbors
{
public:
  using Index = Surface::Index;
  struct Neighbor
  {
    Index face, adjacency;
  };
  explicit Face_neighbors(const Surface& surface)
    : m_surface(surface)
  {
    m_neighbors = Grouped_items<Neighbor>(surface.number_of_faces(), [&](const auto& add) {
      for (Index a = 0; a < surface.number_of_adjacencies(); ++a)
        if (!surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED)) {
          add(surface.lower_face(a), {surface.higher_face(a), a});
          add(surface.higher_face(a), {surface.lower_face(a), a});
        }
    });
    find_thin_faces(surface);
  }

  Iterator_range<const Neighbor*> operator[](std::size_t face) const { return m_neighbors[face]; }

  /// Whether a face is a sliver, needle or cap: its normal tells nothing of the surface on which
  /// its vertices lie.
  bool is_thin(std::size_t face) const { return m_is_thin[face] != 0; }

  /// Whether the deviation of an adjacency may be that of two facets of a curved face.
  bool is_smooth(std::size_t adjacency) const
  {
    return m_surface.cosine(adjacency) > smooth_cosine;
  }
  /// Whether its two faces are parts of one plane facet.
  bool is_coplanar(std::size_t adjacency) const
  {
    return m_surface.cosine(adjacency) > flat_cosine;
  }
  /// Whether it is smooth, or that is unknown.
  bool may_be_smooth(std::size_t adjacency) const
  {
    return is_smooth(adjacency) || is_thin(m_surface.lower_face(adjacency)) ||
           is_thin(m_surface.higher_face(adjacency));
  }

private:
  static constexpr double flat_cosine = 1 - 1e-9;
  static constexpr double smooth_cosine = 0.819; // 35 degrees: a cylinder has at least 11 facets

  void find_thin_faces(const Surface& surface)
  {
    m_is_thin.resize(surface.number_of_faces());
    for (std::size_t f = 0; f < m_is_thin.size(); ++f)
      m_is_thin[f] = surface.is_degenerate(f) || is_thin(surface, f);
  }

  /// Half of a narrow strip, which has an edge about as short as its height, is not thin.
  static bool is_thin(const Surface& surface, std::size_t face)
  {
    constexpr double thin = 0.002, // height over the longest edge
      of_strip = 0.5,              // height over the shortest edge
      rounding = 1e-5;             // height over the size of the surface
    double longest = 0, shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, n = surface.number_of_corners(face); i < n; ++i) {
      const double length = norm(surface.point(surface.corner(face, i)) -
                                 surface.point(surface.corner(face, (i + 1) % n)));
      longest = (std::max)(longest, length);
      shortest = (std::min)(shortest, length);
    }
    const double height = 2 * surface.area(face) / longest;
    return height < thin * longest &&
           (height < of_strip * shortest || height < rounding * surface.length_unit());
  }

  const Surface& m_surface;
  Grouped_items<Neighbor> m_neighbors;
  std::vector<std::uint8_t> m_is_thin;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_NEIGHBORS_H
