// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_COMPONENTS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/surface/find_nesting.h>
#include <CGAL/Region_segmentation/internal/surface/orient_faces.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What decides whether a component is closed, and its orientation.
struct Component_volume
{
  Double_3 area_vector{};
  double area = 0, volume = 0; // the volume times 3
  bool has_border = false, has_seam = false;

  /// The area vectors of a closed surface sum to zero; this decides where a component is closed
  /// only together with its seams.
  bool is_closed() const
  {
    constexpr double largest_gap = 1e-9;
    return !has_border && (!has_seam || norm(area_vector) <= largest_gap * area);
  }
};

/// Turns the outermost closed components of negative signed volume, together with the closed
/// components inside them.
inline void orient_components(Raw_surface& raw, const Partition& component_of,
                              const std::vector<Surface::Index>& faces_at_borders,
                              const std::vector<Seam>& seams)
{
  Surface_arrays& arrays = arrays_of(raw.surface);
  std::vector<Component_volume> components(component_of.number_of_parts());
  for (const Surface::Index face : faces_at_borders)
    components[component_of[face]].has_border = true;
  for (const Seam& seam : seams)
    for (const Surface::Index face : {seam.face, seam.other_face})
      components[component_of[face]].has_seam = true;
  for (std::size_t f = 0; f < component_of.size(); ++f) {
    Component_volume& component = components[component_of[f]];
    const Double_3 face = arrays.areas[f] * arrays.normals[f];
    component.area += arrays.areas[f];
    component.area_vector = component.area_vector + face;
    component.volume += dot(raw.surface.point(raw.surface.corner(f, 0)), face);
  }
  std::vector<bool> is_closed, is_inside_out;
  for (const Component_volume& component : components) {
    is_closed.push_back(component.is_closed());
    is_inside_out.push_back(component.is_closed() && component.volume < 0);
  }
  if (std::find(is_inside_out.begin(), is_inside_out.end(), true) == is_inside_out.end())
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
