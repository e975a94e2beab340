// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
#define CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/apply_seeds.h>
#include <CGAL/Region_segmentation/internal/regions/split_at_constraints.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// First regions as constraints and seeds change them, and the seeds of regions.
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
/// splits regions where constraints separate their faces, and where they have faces of several
/// seeds; regions of equal seeds are joined along the cheapest path.
/// \throws Invalid_input if the faces of a seed cannot be joined
inline Requested_regions requested_regions(const Surface& surface, const Partition& regions,
                                           const Request& request)
{
  Requested_regions result;
  result.regions = request.constraints.empty()
                     ? regions
                     : internal::split_at_constraints(surface, regions, request.constraints);
  if (!request.seeds.empty()) {
    result.regions = internal::apply_seeds(surface, result.regions, request.seeds,
                                           request.constraints);
    result.seeds = internal::seeds_of_regions(result.regions, request.seeds);
  }
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
