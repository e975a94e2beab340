// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_READ_FACE_LABELS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_READ_FACE_LABELS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/check_maps.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The partition of the faces of a mesh, in iteration order, by the labels that a property map
/// gives to them.
template <typename FaceGraph, typename FaceLabelMap>
Partition read_face_labels(const FaceGraph& mesh, const FaceLabelMap& label_map)
{
  static_assert(check_face_map<FaceLabelMap, FaceGraph>());
  using Label = typename boost::property_traits<FaceLabelMap>::value_type;
  return Partition::from_labels(faces(mesh), num_faces(mesh),
                                [&](const auto& f) -> Label { return get(label_map, f); });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_READ_FACE_LABELS_H
