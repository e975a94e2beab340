// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_ATTRIBUTES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_ATTRIBUTES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace segment_mesh {

/// \name The attributes of segments as outputs and the Python module have them
/// Angles are in degrees. `add(name, value)` is called for each attribute, in their order.
/// @{

/// \param segment a `Segment_description`
template <typename Description, typename Add>
void visit_attributes(const Description& segment, const Add& add)
{
  add("area", segment.area);
  add("volume", segment.volume);
  add("volume_share", segment.volume_share);
  add("centroid", segment.centroid);
  add("axes", segment.axes);
  add("extents", segment.extents);
  add("border_length", segment.border_length);
  add("boundary_length", segment.boundary_length);
}

/// \param neighbor one of the `neighbors` of a `Segment_description`
template <typename Neighbor, typename Add>
void visit_attributes_of_neighbor(const Neighbor& neighbor, const Add& add)
{
  add("segment", std::int64_t(neighbor.segment)); // -1: no segment
  add("border_length", neighbor.border_length);
  add("mean_signed_deviation", neighbor.mean_signed_deviation * 180 / CGAL_PI);
}

inline const char* name_of(CGAL::Region_segmentation::Surface_kind kind)
{
  constexpr const char* names[] = {"plane", "cylinder", "cone", "sphere", "torus", "freeform"};
  return names[std::size_t(kind)];
}

inline const char* name_of(CGAL::Region_segmentation::Face_role role)
{
  constexpr const char* names[] = {"none", "blend", "hole", "boss"};
  return names[std::size_t(role)];
}

/// The surface whose `point` is the apex if it is a cone, which has no radius there.
template <typename Kernel>
CGAL::Region_segmentation::Fitted_surface<Kernel>
from_apex(CGAL::Region_segmentation::Fitted_surface<Kernel> surface)
{
  if (surface.kind == CGAL::Region_segmentation::Surface_kind::CONE) {
    const double to_apex = surface.radius / std::tan(surface.angle);
    surface.point = surface.apex();
    surface.radius = 0;
    surface.lowest += to_apex;
    surface.highest += to_apex;
  }
  return surface;
}
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_ATTRIBUTES_H
