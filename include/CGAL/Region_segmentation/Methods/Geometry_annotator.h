// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_GEOMETRY_ANNOTATOR_H
#define CGAL_REGION_SEGMENTATION_METHODS_GEOMETRY_ANNOTATOR_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/Partition.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationAnnotators
/// The annotator for data that are sums over the faces and edges of the mesh. These sums are computed with every region
/// graph, so it adds nothing. A model of `GraphAnnotator`.
///
/// \tparam RegionData_ a model of `RegionData` that needs no other annotator
/// \tparam SectionData_ a model of `SectionData` that needs no other annotator
template <typename RegionData_ = Region_geometry, typename SectionData_ = Section_geometry>
struct Geometry_annotator
{
  using RegionData = RegionData_;
  using SectionData = SectionData_;

  template <typename Graph>
  void operator()(Graph&, const Flat_mesh&, const Partition& /* regions */) const
  {}
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_GEOMETRY_ANNOTATOR_H
