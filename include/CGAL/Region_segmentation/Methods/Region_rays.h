// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_REGION_RAYS_H
#define CGAL_REGION_SEGMENTATION_METHODS_REGION_RAYS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/rays/Inward_rays.h>
#include <CGAL/Region_segmentation/internal/rays/Ray_tree.h>
#include <CGAL/Region_segmentation/internal/regions/Region_shapes.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationParts
/// The rays that regions of a surface cast into the body, see `Visibility_annotator`, and where
/// they end.
class Region_rays
{
public:
  using Hits = internal::Inward_rays::Hits;

  Region_rays() = default;

  /// Makes the tree that finds hits, and traces the rays of all regions.
  Region_rays(const Surface& surface, const Surface_patches& patches, const Partition& regions,
              const Execution& execution = Execution())
  {
    if (surface.area() == 0)
      return;
    m_shapes = internal::Region_shapes(surface, regions, execution);
    const internal::Ray_tree tree(surface, patches, m_shapes.surface_centroid,
                                  execution.step(0, 0.6));
    m_hits = internal::Inward_rays(surface, patches.fine, regions, m_shapes, tree)
               .trace(execution.step(0.6, 1));
  }

  /// By region; none of a surface without area.
  const std::vector<Hits>& hits() const { return m_hits; }
  /// The shapes of the regions; none of a surface without area.
  const internal::Region_shapes& shapes() const { return m_shapes; }

private:
  internal::Region_shapes m_shapes;
  std::vector<Hits> m_hits;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_REGION_RAYS_H
