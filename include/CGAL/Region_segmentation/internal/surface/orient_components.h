// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/surface/find_nesting.h>
#include <CGAL/Region_segmentation/internal/surface/orient_faces.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What decides whether a component is closed, and its orientation.
struct Component_volume
{
  Double_3 origin{}, area_vector{};
  double area = 0, volume = 0; // the volume times 3
  bool has_origin = false, has_border = false, has_seam = false;

  /// The area vectors of a closed surface sum to zero; this decides where a component is closed
  /// only together with its seams.
  bool is_closed() const
  {
    constexpr double largest_gap = 1e-9;
    return !has_border && (!has_seam || norm(area_vector) <= largest_gap * area);
  }

  void add_face(const Surface& surface, std::size_t f)
  {
    const Double_3& point = surface.point(surface.corner(f, 0));
    if (!has_origin)
      origin = point;
    has_origin = true;
    const Double_3 face = surface.area(f) * surface.normal(f);
    area += surface.area(f);
    area_vector = area_vector + face;
    volume += dot(point - origin, face);
  }
};

/// With volumes of the components without border alone.
inline std::vector<Component_volume>
component_volumes(const Raw_surface& raw, const Partition& component_of,
                  const std::vector<Surface::Index>& faces_at_borders,
                  const std::vector<Seam>& seams)
{
  std::vector<Component_volume> components(component_of.number_of_parts());
  for (const Surface::Index face : faces_at_borders)
    components[component_of[face]].has_border = true;
  for (const Seam& seam : seams)
    for (const Surface::Index face : {seam.face, seam.other_face})
      components[component_of[face]].has_seam = true;
  for (std::size_t f = 0; f < component_of.size(); ++f)
    if (Component_volume& c = components[component_of[f]]; !c.has_border)
      c.add_face(raw.surface, f);
  return components;
}

/// Turns the outermost closed components of negative signed volume, together with the closed
/// components inside them.
inline void orient_components(Raw_surface& raw, const Partition& component_of,
                              const std::vector<Surface::Index>& faces_at_borders,
                              const std::vector<Seam>& seams)
{
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::vector<Component_volume> components = component_volumes(raw, component_of,
                                                                     faces_at_borders, seams);
  std::vector<bool> is_closed(components.size()), is_inside_out(components.size());
  bool is_any_inside_out = false;
  for (std::size_t c = 0; c < components.size(); ++c) {
    is_closed[c] = components[c].is_closed();
    is_inside_out[c] = is_closed[c] && components[c].volume < 0;
    is_any_inside_out = is_any_inside_out || is_inside_out[c];
  }
  if (!is_any_inside_out)
    return;
  const std::vector<Surface::Index> outermost = find_outermost(raw.surface, component_of,
                                                               is_closed);
  const auto is_turned = [&](std::size_t face) {
    const Surface::Index c = component_of[face];
    return is_closed[c] && is_inside_out[outermost[c]];
  };
  for (std::size_t f = 0; f < component_of.size(); ++f)
    if (is_turned(f))
      turn_face(raw, f);
  for (std::size_t a = 0; a < arrays.flags.size(); ++a)
    if (is_turned(arrays.lower_faces[a]) &&
        (arrays.flags[a] & (Surface::CONVEX | Surface::CONCAVE)))
      arrays.flags[a] ^= Surface::CONVEX | Surface::CONCAVE;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H
