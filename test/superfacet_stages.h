// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SUPERFACET_STAGES_H
#define CGAL_REGION_SEGMENTATION_TEST_SUPERFACET_STAGES_H

// The stages of the methods on superfacets, on manifold soups.

#include "meshes.h"

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Superfacets/Region_rays.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacets.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Patch_builder.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <cstddef>

namespace test {

inline CGAL::Region_segmentation::Surface surface_of_soup(const Soup& soup, bool has_links = true)
{
  namespace RS = CGAL::Region_segmentation;
  return RS::make_surface(to_surface_mesh(soup), RS::parameters::component_links(has_links));
}

inline CGAL::Region_segmentation::Surface_patches
patches_of(const CGAL::Region_segmentation::Surface& surface)
{
  namespace RS = CGAL::Region_segmentation;
  return RS::internal::Patch_builder::build(surface, 0, RS::Execution());
}

/// The superfacet of each face.
inline CGAL::Region_segmentation::Partition
superfacets_of(const CGAL::Region_segmentation::Surface& surface,
               const CGAL::Region_segmentation::Superfacets& superfacets)
{
  const CGAL::Region_segmentation::Surface_patches patches = patches_of(surface);
  return composed(patches.fine.of_elements(), superfacets(surface, patches));
}

template <typename Annotator>
using Graph_of = CGAL::Region_segmentation::Region_adjacency_graph<typename Annotator::RegionData,
                                                                   typename Annotator::SectionData>;

/// By the rays of these regions.
template <typename Annotator>
Graph_of<Annotator> annotated(const CGAL::Region_segmentation::Surface& surface,
                              const CGAL::Region_segmentation::Partition& regions)
{
  namespace RS = CGAL::Region_segmentation;
  auto graph = RS::build_region_adjacency_graph<typename Annotator::RegionData,
                                                typename Annotator::SectionData>(surface, regions);
  const RS::Surface_patches patches = patches_of(surface);
  const auto rays = RS::internal::Inward_rays(surface, patches, regions).trace(RS::Execution());
  Annotator()(graph, surface, regions,
              RS::Region_rays{rays, RS::Region_shapes(surface, patches.fine, regions)});
  return graph;
}

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_SUPERFACET_STAGES_H
