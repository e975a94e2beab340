// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_LINKS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_LINKS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/part_areas.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>
#include <CGAL/Region_segmentation/internal/surface/Added_adjacency.h>
#include <CGAL/Region_segmentation/internal/surface/contact_lengths.h>
#include <CGAL/Region_segmentation/internal/surface/find_contacts.h>
#include <CGAL/Region_segmentation/internal/surface/join_nearest.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// By component: 1/250 of the square root of its area. Two faces are in contact within the least of
/// those of their components and the square roots of their own areas. So neither a large body nor a
/// crumb far away changes what parts touch each other, and a face is compared with few others.
inline std::vector<double> contact_tolerances(const Surface& surface,
                                              const Partition& component_of_face)
{
  std::vector<double> result = part_areas(surface, component_of_face);
  for (double& area : result)
    area = std::sqrt(area) / 250;
  return result;
}

/// Links between components: where they are in contact, with the length of contact, and between the
/// nearest ones, with length 0, until all are connected.
///
/// \pre the surface has its edges and seams, and `component_of_face` is its connected components
///
/// Nothing is done for one component. Otherwise O(F log F), see `Contact_finder` and
/// `Nearest_joiner`.
inline std::vector<Added_adjacency>
find_links(const Surface& surface, const Partition& component_of_face, const Execution& execution)
{
  if (component_of_face.number_of_parts() < 2)
    return {};
  const std::vector<double> tolerances = contact_tolerances(surface, component_of_face);
  Component_tree tree(surface, component_of_face, tolerances);
  Contact_finder finder(surface, tree, component_of_face);
  std::vector<Added_adjacency> links = links_of_contacts(surface, component_of_face, tolerances,
                                                         finder.find(execution.step(0, 0.5)));
  Nearest_joiner(surface, tree, component_of_face, links).run(execution.step(0.5, 1));
  return links;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_LINKS_H
