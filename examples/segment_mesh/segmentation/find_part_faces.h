// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FIND_PART_FACES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FIND_PART_FACES_H

#include "segmentation/segment_attributes.h"
#include "soup/Polygon_soup.h"

#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdint>
#include <vector>

namespace segment_mesh {

/// The faces of a machine part that is a soup, for the modules of other languages.
struct Soup_part_faces
{
  std::vector<std::int32_t> labels; ///< of the faces of the soup
  std::vector<CGAL::Region_segmentation::Part_face<CGAL::Simple_cartesian<double>>> faces;
};

/// \param np the visitor, if there is one
/// \throws Invalid_input, and Segmentation_cancelled if the visitor cancels
template <typename NamedParameters>
Soup_part_faces find_part_faces(const Polygon_soup& soup, double tolerance,
                                const NamedParameters& np)
{
  namespace RS = CGAL::Region_segmentation;
  const RS::Execution execution = RS::internal::make_execution<CGAL::Sequential_tag>(np);
  const RS::Surface surface = RS::make_surface_of_polygon_soup(soup.points, soup.polygons, np);
  const RS::Surface_faces found = RS::find_surface_faces(surface, tolerance,
                                                         execution.stage("regions"));
  Soup_part_faces result;
  result.faces = RS::internal::part_faces<CGAL::Simple_cartesian<double>>(surface, found);
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    result.labels.push_back(std::int32_t(found.partition[f]));
  return result;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FIND_PART_FACES_H
