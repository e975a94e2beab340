// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_SEARCH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_SEARCH_H

#include <CGAL/Region_segmentation/internal/faces/Face_grower.h>
#include <CGAL/Region_segmentation/internal/faces/Face_set.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

  void add(const Fitted_surface<>& s, const std::vector<Index>& faces)
  {
    for (const Index f : faces) {
      labels[f] = Index(surfaces.size());
      for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
        is_on_found[surface.corner(f, i)] = 1;
    }
    surfaces.push_back(s);
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
