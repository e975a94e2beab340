// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_ATTRIBUTES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_ATTRIBUTES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace segment_mesh {

/// Of a point or a vector.
template <typename Triple>
std::array<double, 3> coordinates(const Triple& t)
{
  return {t.x(), t.y(), t.z()};
}

/// \name The attributes of segments as outputs and the modules of other languages have them
/// Angles are in degrees. `add(name, value)` is called for each attribute, in their order: a
/// number, a text, or an array of numbers or of arrays.
/// @{

/// \param segment a `Segment_description`
template <typename Description, typename Add>
void visit_attributes(const Description& segment, const Add& add)
{
  add("area", segment.area);
  add("volume", segment.volume);
  add("volume_share", segment.volume_share);
  add("centroid", coordinates(segment.centroid));
  add("axes", std::array{coordinates(segment.axes[0]), coordinates(segment.axes[1]),
                         coordinates(segment.axes[2])});
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

/// Of a fitted surface, those that it has. The point of a cone is its apex, where its radius is 0.
template <typename Kernel, typename Add>
void visit_attributes_of_surface(const CGAL::Region_segmentation::Fitted_surface<Kernel>& surface,
                                 const Add& add)
{
  using Kind = CGAL::Region_segmentation::Surface_kind;
  const Kind kind = surface.kind;
  add("type", name_of(kind));
  if (kind == Kind::FREEFORM)
    return;
  const bool is_cone = kind == Kind::CONE;
  const double apex = is_cone ? surface.radius / std::tan(surface.angle) : 0;
  add("deviation", surface.deviation);
  add("point", coordinates(is_cone ? surface.apex() : surface.point));
  if (kind != Kind::SPHERE)
    add("direction", coordinates(surface.direction));
  if (kind != Kind::PLANE && !is_cone)
    add("radius", surface.radius);
  if (kind == Kind::TORUS)
    add("minor_radius", surface.minor_radius);
  if (is_cone)
    add("half_angle", surface.angle * 180 / CGAL_PI);
  if (kind != Kind::SPHERE)
    add("extent", std::array<double, 2>{surface.lowest + apex, surface.highest + apex});
}

/// Of a `Part_face`, without its surface and neighbors.
template <typename Part_face, typename Add>
void visit_attributes_of_face(const Part_face& face, const Add& add)
{
  add("is_concave", face.surface.side < 0);
  if (face.role != CGAL::Region_segmentation::Face_role::NONE)
    add("role", name_of(face.role));
  add("area", face.area);
  add("first_on_surface", face.first_on_surface);
  add("first_on_axis", face.first_on_axis);
}
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_ATTRIBUTES_H
