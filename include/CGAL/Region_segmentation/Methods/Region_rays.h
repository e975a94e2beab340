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
#include <limits>
#include <memory>
#include <optional>
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
    : m_hits(regions.number_of_parts())
  {
    if (surface.area() == 0)
      return;
    m_shapes = internal::Region_shapes(surface, regions, execution);
    m_tree = std::make_shared<internal::Ray_tree>(surface, patches, m_shapes.surface_centroid,
                                                  execution.step(0, 0.6));
    trace(surface, patches, regions, execution.step(0.6, 1));
  }

  /// The rays and shapes of other regions: only those of regions that were not among the former
  /// ones are traced and measured.
  Region_rays of_changed_regions(const Surface& surface, const Surface_patches& patches,
                                 const Partition& former, const Partition& regions,
                                 const Execution& execution = Execution()) const
  {
    Region_rays result;
    const std::vector<Partition::Index> former_of = equal_parts(former, regions);
    for (const Partition::Index r : former_of)
      result.m_hits.push_back(r < m_hits.size() ? m_hits[r] : std::nullopt);
    if (surface.area() == 0)
      return result;
    result.m_shapes = m_shapes.of_changed_regions(surface, regions, former_of, execution);
    result.m_tree = m_tree;
    result.trace(surface, patches, regions, execution);
    return result;
  }

  /// By region.
  const std::vector<std::optional<Hits>>& hits() const { return m_hits; }
  /// The shapes of the regions; none of a surface without area.
  const internal::Region_shapes& shapes() const { return m_shapes; }

private:
  /// What is missing.
  void trace(const Surface& surface, const Surface_patches& patches, const Partition& regions,
             const Execution& execution)
  {
    internal::Inward_rays(surface, patches.fine, regions, m_shapes, *m_tree)
      .trace(m_hits, execution);
  }

  /// For each part of `after` the part of `before` with the same elements, or the highest number if
  /// there is none.
  static std::vector<Partition::Index> equal_parts(const Partition& before, const Partition& after)
  {
    using Index = Partition::Index;
    constexpr Index none = (std::numeric_limits<Index>::max)(), unknown = none - 1;
    std::vector<Index> equal(after.number_of_parts(), unknown);
    std::vector<std::size_t> size_before(before.number_of_parts()),
      size_after(after.number_of_parts());
    for (std::size_t i = 0; i < after.size(); ++i) {
      Index& e = equal[after[i]];
      e = e == unknown || e == before[i] ? before[i] : none;
      ++size_before[before[i]];
      ++size_after[after[i]];
    }
    for (std::size_t part = 0; part < equal.size(); ++part)
      if (equal[part] < unknown && size_before[equal[part]] != size_after[part])
        equal[part] = none;
    return equal;
  }

  internal::Region_shapes m_shapes;
  std::shared_ptr<const internal::Ray_tree> m_tree;
  std::vector<std::optional<Hits>> m_hits;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_REGION_RAYS_H
