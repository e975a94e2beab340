// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
#define CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/apply_seeds.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// First regions as seeds change them, and the seeds of regions.
struct Requested_regions
{
  Partition regions; ///< of the faces
  Seeds seeds;       ///< of the regions

  bool is_fixed(Partition::Index region) const
  {
    return !seeds.empty() && seeds.of[region] != Seeds::none;
  }
};

/// \ingroup PkgRegionSegmentationData
/// splits regions that have faces of several seeds, and joins regions of equal seeds along the
/// cheapest path.
/// \throws Invalid_input if the faces of a seed cannot be joined, Invalid_method if `regions` is no
///         partition of the faces
inline Requested_regions requested_regions(const Surface& surface, const Partition& regions,
                                           const Seeds& seeds)
{
  internal::check_regions(regions, surface.number_of_faces());
  if (seeds.empty())
    return {regions, Seeds()};
  Requested_regions result{internal::apply_seeds(surface, regions, seeds), Seeds()};
  result.seeds = internal::seeds_of_regions(result.regions, seeds);
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
