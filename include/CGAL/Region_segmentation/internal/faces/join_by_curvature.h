// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_BY_CURVATURE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_BY_CURVATURE_H

#include <CGAL/Region_segmentation/internal/faces/Curvature_joiner.h>
#include <CGAL/Region_segmentation/internal/faces/Face_curvatures.h>
#include <CGAL/Region_segmentation/internal/faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/faces/surface_evidence.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Joins single faces that no edge joins smoothly to others, such as those of folds, to the larger
/// freeform region with the longest common edge, and then those beside them.
inline void join_single_faces(const Face_search& search, const std::vector<Surface::Index>& regions,
                              Curvature_joiner& joiner)
{
  using Index = Surface::Index;
  const auto is_single = [&](Index f) {
    return regions[f] != Face_search::none && joiner.faces(joiner.current(regions[f])) == 1;
  };
  std::vector<std::pair<Index, Index>> joined;
  do {
    joined.clear();
    for (Index f = 0; f < regions.size(); ++f) {
      if (!is_single(f))
        continue;
      double longest = 0;
      Index neighbor = f;
      for (const Face_neighbors::Neighbor& n : search.neighbors[f])
        if (regions[n.face] != Face_search::none && !is_single(n.face) &&
            !joiner.is_fitted(joiner.current(regions[n.face])) &&
            search.surface.length(n.adjacency) > longest) {
          longest = search.surface.length(n.adjacency);
          neighbor = n.face;
        }
      if (neighbor != f)
        joined.push_back({regions[f], regions[neighbor]});
    }
    for (const auto& pair : joined)
      joiner.join(joiner.current(pair.first), joiner.current(pair.second));
  } while (!joined.empty());
}

/// The faces of the mesh that `join_by_curvature()` joins: regions of one face where no surface was
/// found, of all faces of a label elsewhere; none on surfaces of strong evidence.
struct Free_regions
{
  using Index = Surface::Index;

  std::vector<Evidence> evidence;    ///< by label
  std::vector<std::uint8_t> is_free; ///< by face
  std::vector<Index> of_faces;       ///< or none
  std::vector<Index> label_of_region;

  explicit Free_regions(const Face_search& search)
    : evidence(evidence_of_surfaces(search))
    , is_free(search.labels.size())
    , of_faces(search.labels.size(), Face_search::none)
  {
    std::vector<Index> of_label(search.surfaces.size(), Face_search::none);
    for (Index f = 0; f < is_free.size(); ++f) {
      const Index label = search.labels[f];
      is_free[f] = evidence[label] != Evidence::STRONG;
      if (!is_free[f])
        continue;
      if (search.surfaces[label].kind == Surface_kind::FREEFORM ||
          of_label[label] == Face_search::none) {
        of_label[label] = Index(label_of_region.size());
        label_of_region.push_back(label);
      }
      of_faces[f] = of_label[label];
    }
  }
};

/// Adds faces and edges of free regions.
inline void fill(Curvature_joiner& joiner, const Face_search& search, const Free_regions& regions)
{
  using Index = Surface::Index;
  for (Index f = 0; f < search.labels.size(); ++f)
    if (regions.is_free[f])
      joiner.add_face(regions.of_faces[f], regions.evidence[search.labels[f]] == Evidence::WEAK);
  const Face_curvatures curvatures(search, regions.is_free);
  for_each_border(search.surface, regions.of_faces, [&](std::size_t a, Index i, Index j) {
    if (i == Face_search::none || j == Face_search::none)
      return;
    const double length = search.surface.length(a);
    Curvature_joiner::Border edge{length, length, search.neighbors.may_be_smooth(a)};
    if (edge.is_smooth) {
      const Face_curvatures::Jump jump = curvatures(a);
      edge.jump = length * jump.difference / jump.scale;
    }
    joiner.add_edge(i, j, edge);
  });
}

/// Divides what fits no surface into freeform faces, at the borders across which its curvature
/// jumps, as between a fillet and a wall. Surfaces of weak evidence become places of freeform faces
/// beside them if the curvature does not jump there.
inline void join_by_curvature(Face_search& search)
{
  using Index = Surface::Index;
  const Free_regions regions(search);
  Curvature_joiner joiner(regions.label_of_region.size());
  fill(joiner, search, regions);
  joiner.join();
  join_single_faces(search, regions.of_faces, joiner);

  std::vector<Index> labels(regions.label_of_region.size(), Face_search::none); // by region
  for (Index f = 0; f < search.labels.size(); ++f)
    if (regions.is_free[f]) {
      const Index region = joiner.current(regions.of_faces[f]);
      if (labels[region] == Face_search::none) {
        labels[region] = Index(search.surfaces.size());
        const Fitted_surface<> own = search.surfaces[regions.label_of_region[region]];
        search.surfaces.push_back(joiner.is_joined(region) ? Fitted_surface<>() : own);
      }
      search.labels[f] = labels[region];
    }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_BY_CURVATURE_H
