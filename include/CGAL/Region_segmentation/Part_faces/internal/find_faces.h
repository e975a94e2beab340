// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_grower.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>
#include <CGAL/Region_segmentation/Part_faces/internal/drop_osculating_surfaces.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_curved_faces.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_face_roles.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_planes.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/merge_equal_surfaces.h>
#include <CGAL/Region_segmentation/Part_faces/internal/vertex_error.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The label of the surface, of those of a face and its neighbors, on which the face lies, and from
/// which it deviates least; that of the face if it lies on none.
inline Surface::Index nearest_label(const Face_search& search, Surface::Index face)
{
  using Index = Surface::Index;
  constexpr double much = 0.9, little = 0.1; // of the deviation, of sigma
  Index best = search.labels[face];
  double least = std::numeric_limits<double>::infinity();
  const auto compare = [&](Index label) {
    if (label == Face_search::none || !search.mesh.lies_on(search.surfaces[label], face))
      return;
    const double deviation = deviation_of_face(search.surface, search.surfaces[label], face);
    if (deviation < much * least - little * search.mesh.sigma) {
      least = deviation;
      best = label;
    }
  };
  compare(best);
  for_each_neighbor(search.surface, face, [&](Index g, Index, Index) {
    if (search.labels[g] != best)
      compare(search.labels[g]);
  });
  return best;
}

/// Faces go to the neighboring surface from which they deviate least.
inline void compete_at_borders(Face_search& search)
{
  constexpr int rounds = 8;
  bool is_changed = true;
  for (int round = 0; round < rounds && is_changed; ++round) {
    is_changed = false;
    for (Surface::Index f = 0; f < search.labels.size(); ++f) {
      const Surface::Index best = nearest_label(search, f);
      is_changed = is_changed || best != search.labels[f];
      search.labels[f] = best;
    }
  }
}

/// Gives faces without area that no side has a face across, as copies of others, the label of the
/// first face that they are adjacent to. Returns that face, by face; none for other faces.
inline std::vector<Surface::Index> label_copies(Face_search& search)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  std::vector<Index> originals(surface.number_of_faces(), Face_search::none);
  const auto is_copy = [&](Index f) {
    bool result = surface.is_degenerate(f);
    if (result)
      for_each_neighbor(surface, f, [&](Index, Index, Index) { result = false; });
    return result;
  };
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Index f = surface.lower_face(a), g = surface.higher_face(a);
    if (surface.has_flag(a, Surface::LINK | Surface::CONSTRAINED) ||
        surface.is_degenerate(f) == surface.is_degenerate(g))
      continue;
    const auto [copy, original] = surface.is_degenerate(f) ? std::pair(f, g) : std::pair(g, f);
    if (originals[copy] == Face_search::none && is_copy(copy)) {
      originals[copy] = original;
      search.labels[copy] = search.labels[original];
    }
  }
  return originals;
}

/// Makes each connected component of a label a face of its own, and those of what was not found
/// freeform faces, which end where the mesh does not go on smoothly.
inline void separate_components(Face_search& search, const Execution& execution)
{
  const Surface& surface = search.surface;
  const std::vector<Surface::Index> originals = label_copies(search);
  const Partition components = label_components(
    surface,
    [&](std::size_t a) {
      const Surface::Index f = surface.lower_face(a), g = surface.higher_face(a),
                           label = search.labels[f];
      if (originals[f] == g || originals[g] == f)
        return true;
      return label == search.labels[g] && !surface.has_flag(a, Surface::barrier) &&
             (label != Face_search::none || search.mesh.is_smooth(f, g));
    },
    execution);
  std::vector<Fitted_surface<>> surfaces(components.number_of_parts());
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    if (search.is_found(f))
      surfaces[components[f]] = search.surfaces[search.labels[f]];
  search.labels.assign(components.begin(), components.end());
  search.surfaces = std::move(surfaces);
}

/// The label of each face of the mesh, see `find_surface_faces()`.
inline void find_labels(Face_search& search, const Execution& execution)
{
  find_curved_faces(search, execution.step(0, 0.8));
  drop_osculating_surfaces(search);
  add_planes(search);
  compete_at_borders(search);
  Equal_surfaces(search).merge();
  separate_components(search, execution.step(0.8, 1));
}

/// Fits the surface of each face of the part to all its vertices. Faces of the mesh that are not on
/// it, as those that cross a crease, do not count.
inline void fit_surfaces(const Tessellation& mesh, Surface_faces& faces)
{
  const Grouped_items<Surface::Index> by_part(faces.surfaces.size(), [&](const auto& add) {
    for (Surface::Index f = 0; f < faces.partition.size(); ++f)
      add(faces.partition[f], f);
  });
  Face_set members(mesh.surface);
  for (std::size_t part = 0; part < faces.surfaces.size(); ++part) {
    Fitted_surface<>& s = faces.surfaces[part];
    if (s.kind == Surface_kind::FREEFORM)
      continue;
    members.clear();
    for (const Surface::Index f : by_part[part])
      if (mesh.has_vertices_on(s, f))
        members.add(f);
    if (members.faces().empty()) {
      s = Fitted_surface<>();
      continue;
    }
    Fitted_surface<> fitted = s;
    if (int(members.points().size()) > degrees_of_freedom(s.kind) &&
        refine_surface(fitted, members.points(), 0) &&
        largest_distance(fitted, members.points()) <= mesh.tolerance())
      s = fitted;
    measure(s, members.points());
  }
}

/// See `find_surface_faces()`. `tolerance`: in units of the surface
inline Surface_faces find_faces(const Surface& surface, double tolerance,
                                const Execution& execution)
{
  const Tessellation mesh(surface, tolerance > 0 ? tolerance / Tessellation::interval
                                                 : vertex_error(surface));
  Face_search search(mesh);
  find_labels(search, execution);
  Surface_faces result;
  result.partition = Partition::from_labels(search.labels);
  result.surfaces = std::move(search.surfaces);
  result.tolerance = mesh.tolerance();
  fit_surfaces(mesh, result);
  result.roles = find_face_roles(surface, result.partition, result.surfaces);
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H
