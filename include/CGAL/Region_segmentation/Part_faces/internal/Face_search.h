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
    for (Index facet = 0; facet < is_sure.size(); ++facet)
      is_sure[facet] = is_plane_of_part(facet);
  }

  bool is_found(Index face) const { return labels[face] != none; }
  bool is_sure_plane(Index face) const { return is_sure[mesh.facet_of(face)]; }
  bool may_be_curved(Index face) const { return !is_found(face) && !is_sure_plane(face); }

  template <typename Faces>
  void add(const Fitted_surface<>& s, const Faces& faces)
  {
    for (const Index f : faces)
      labels[f] = Index(surfaces.size());
    surfaces.push_back(s);
  }

private:
  /// Whether a facet has six vertices, and less than two facets of at least an eighth of its area
  /// go on from it smoothly: so it is none of a curved face.
  bool is_plane_of_part(Index facet) const
  {
    constexpr std::size_t fewest_vertices = 6;
    constexpr double least_area = 0.125;
    if (mesh.facet(facet).number_of_vertices < fewest_vertices)
      return false;
    Index first = none;
    for (const Index f : mesh.faces_of_facet(facet)) {
      bool has_two = false;
      for_each_neighbor(surface, f, [&](Index g, Index, Index) {
        const Index other = mesh.facet_of(g);
        if (other == facet || !mesh.is_surely_smooth(f, g) ||
            mesh.facet(other).area <= least_area * mesh.facet(facet).area)
          return;
        has_two = has_two || (first != none && other != first);
        first = other;
      });
      if (has_two)
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FACE_SEARCH_H
