// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SEARCH_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SEARCH_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_grower.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The faces of a part that are found so far: the label of each face of the mesh, and the surface
/// of each label.
struct Face_search
{
  using Index = Surface::Index;
  static constexpr Index none = Index(-1);

  const Tessellation& mesh;
  const Surface& surface;
  Face_set patch; ///< some faces around a face
  Face_grower grower;
  std::vector<Index> labels;              ///< by face of the mesh; none: not found yet
  std::vector<Fitted_surface<>> surfaces; ///< by label
  std::vector<std::uint8_t> is_sure;      ///< by facet: it surely is a plane of the part
  std::vector<std::uint8_t> is_freeform;  ///< by facet: a curved face that had it was none

  explicit Face_search(const Tessellation& tessellation)
    : mesh(tessellation)
    , surface(tessellation.surface)
    , patch(surface)
    , grower(tessellation)
    , labels(surface.number_of_faces(), none)
    , is_sure(tessellation.number_of_facets())
    , is_freeform(tessellation.number_of_facets(), 0)
  {
    for (Index i = 0; i < is_sure.size(); ++i)
      is_sure[i] = stands_alone(i, Tessellation::smooth_angle);
  }

  bool is_found(Index face) const { return labels[face] != none; }
  bool may_be_curved(Index face) const { return !is_found(face) && !is_sure[mesh.facet_of(face)]; }

  template <typename Faces>
  void add(const Fitted_surface<>& s, const Faces& faces)
  {
    for (const Index f : faces)
      labels[f] = Index(surfaces.size());
    surfaces.push_back(s);
  }

  /// Whether a facet goes on to others that are not found and not much smaller, within an angle, at
  /// most of a tenth of its border: so it is none of a curved face.
  bool stands_alone(Index facet, double angle) const
  {
    constexpr double least_area = 0.2, most = 0.1;
    double smooth = 0, all = 0;
    for (const Index f : mesh.faces_of_facet(facet))
      for_each_neighbor(surface, f, [&](Index g, Index v, Index w) {
        const Index other = mesh.facet_of(g);
        if (other == facet)
          return;
        const double length = norm(surface.point(w) - surface.point(v));
        all += length;
        if (!is_found(g) && mesh.surely_meet_within(angle, f, g) &&
            mesh.facet(other).area > least_area * mesh.facet(facet).area)
          smooth += length;
      });
    return smooth <= most * all;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SEARCH_H
