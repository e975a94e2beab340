// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_SEARCH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_SEARCH_H

#include <CGAL/Region_segmentation/internal/faces/Face_grower.h>
#include <CGAL/Region_segmentation/internal/faces/Face_set.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What the phases of finding faces share: the tolerance, and the faces found so far, by their
/// labels, with their surfaces.
class Face_search
{
public:
  using Index = Surface::Index;
  static constexpr Index none = Index(-1);

  const Surface& surface;
  const Face_neighbors neighbors;
  Face_set patch; ///< some faces around a face
  const Face_test test;
  Face_grower grower;
  std::vector<Index> labels;              ///< by face of the mesh; none: not found yet
  std::vector<Fitted_surface<>> surfaces; ///< by label
  std::vector<std::uint8_t> is_tried;     ///< by face of the mesh: no seed in this phase
  std::vector<std::uint8_t> is_on_found;  ///< by vertex: a face that is found has it

  Face_search(const Surface& s, double tolerance)
    : surface(s)
    , neighbors(s)
    , patch(s)
    , test(s, neighbors, tolerance)
    , grower(s, neighbors, test)
    , labels(s.number_of_faces(), none)
    , is_on_found(s.number_of_vertices(), 0)
  {}

  /// Whether vertices lie on their surfaces, to rounding.
  bool is_exact() const { return test.tolerance() < 2e-5 * surface.length_unit(); }

  bool is_found(Index face) const { return labels[face] != none; }
  const Fitted_surface<>& surface_of(Index face) const { return surfaces[labels[face]]; }

  /// Adds a face of the part, without those of its facets that are flat.
  void add(const Fitted_surface<>& s, const std::vector<Index>& faces)
  {
    const Index label = Index(surfaces.size());
    surfaces.push_back(s);
    m_largest_deviations.push_back(largest_deviation(s, faces));
    for (const Index f : faces)
      if (!is_flat(label, f)) {
        labels[f] = label;
        for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
          is_on_found[surface.corner(f, i)] = 1;
      }
  }

  /// Whether a face is one of several of a plane that deviate much more from a curved surface than
  /// its other faces do, though their vertices lie on it: a flat of a shaft.
  bool is_flat(Index label, Index face) const
  {
    const auto deviates = [&](Index f) {
      return test.deviation(surfaces[label], f) > m_largest_deviations[label];
    };
    const auto around = neighbors[face];
    return deviates(face) && std::any_of(around.begin(), around.end(), [&](const auto& n) {
             return neighbors.is_coplanar(n.adjacency) && deviates(n.face);
           });
  }

  /// The number of vertices of some faces that no face that is found has.
  std::size_t number_of_new_vertices(const std::vector<Index>& faces) const
  {
    std::vector<Index> vertices;
    for (const Index f : faces)
      for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
        if (!is_on_found[surface.corner(f, i)])
          vertices.push_back(surface.corner(f, i));
    std::sort(vertices.begin(), vertices.end());
    return std::size_t(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
  }

  /// Faces that are neither found nor thin, the largest first: so what is found does not depend on
  /// their order.
  std::vector<Index> seeds() const
  {
    std::vector<Index> result;
    for (Index f = 0; f < labels.size(); ++f)
      if (!is_found(f) && !neighbors.is_thin(f))
        result.push_back(f);
    std::stable_sort(result.begin(), result.end(),
                     [&](Index a, Index b) { return surface.area(a) > surface.area(b); });
    return result;
  }

  /// Starts a phase.
  void clear_tried() { is_tried.assign(labels.size(), 0); }

private:
  /// A tessellation is equally accurate everywhere.
  double largest_deviation(const Fitted_surface<>& s, const std::vector<Index>& faces) const
  {
    if (!is_exact() || s.kind == Surface_kind::PLANE)
      return std::numeric_limits<double>::infinity();
    constexpr double much = 10;
    std::vector<double> deviations;
    for (const Index f : faces)
      deviations.push_back(test.deviation(s, f));
    const auto most = deviations.begin() + std::ptrdiff_t(deviations.size() * 3 / 4);
    std::nth_element(deviations.begin(), most, deviations.end());
    return (std::max)(much * *most, test.tolerance());
  }

  std::vector<double> m_largest_deviations; // by label
};

/// The share of the border of the faces that were grown where the surface goes on smoothly to faces
/// that are not found, and not much smaller than several faces.
inline double share_of_smooth_border(const Face_search& search)
{
  const Surface& surface = search.surface;
  double smooth = 0, all = 0;
  for (const Surface::Index f : search.grower.faces())
    for (const Face_neighbors::Neighbor& n : search.neighbors[f])
      if (!search.grower.is_taken(n.face)) {
        const double length = surface.length(n.adjacency);
        all += length;
        if (!search.is_found(n.face) && search.neighbors.may_be_smooth(n.adjacency) &&
            (search.grower.faces().size() == 1 ||
             surface.area(n.face) > 0.2 * search.grower.area()))
          smooth += length;
      }
  return all > 0 ? smooth / all : 0;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_SEARCH_H
