// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LABELLED_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LABELLED_MESH_H

#include "segmentation/Segmentation_details.h"
#include "soup/Mesh_properties.h"
#include "soup/Polygon_soup.h"
#include "soup/triangulate_polygon.h"
#include "view/segment_colors.h"

#include <cstddef>
#include <string>
#include <vector>

namespace segment_mesh {

inline const Mesh_properties no_properties;

/// A mesh, or a part of it, with a segment for each face, `no_segment` for none.
struct Labelled_mesh
{
  const Polygon_soup& soup;
  const std::vector<std::size_t>& segment_of_face;
  std::vector<std::string> names = {}; ///< of segments; `segment_I` of those that are not there
  const Mesh_properties& properties = no_properties; ///< what the input has beside points and faces

  std::string name(std::size_t segment) const
  {
    return segment < names.size() ? names[segment] : name_of_segment(segment);
  }
};

/// By segment, in their order; the last ones are those of no segment.
std::vector<std::vector<std::size_t>>
faces_of_segments(const std::vector<std::size_t>& segment_of_face);

/// A part of a mesh.
struct Mesh_part
{
  Polygon_soup soup;
  Mesh_properties properties;
};

/// Some faces, in their order, with their points in the order of the mesh. O(n log n) in their
/// corners.
Mesh_part extract_faces(const Labelled_mesh& mesh, const std::vector<std::size_t>& faces);

/// Of polygons, those that have three different points.
struct Face_triangles
{
  Triangles triangles;
  std::vector<std::size_t> face_of_triangle;
};

/// In the order of the polygons.
Face_triangles triangulate_faces(const Polygon_soup& soup);

/// A segment as a part of its own, with at least one triangle.
struct Segment_triangles : Face_triangles
{
  std::string name;
  Color color;
  Mesh_part part;
};

/// All segments with a face of at least three different points.
std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh);

/// The name of a file that is given from one folder, as seen from another one; links are followed.
std::string relative_name(const std::string& from, const std::string& name, const std::string& to);

/// "group", "material", "solid", "paint".
std::string singular(Set_kind kind);

/// Empty if there are none.
std::vector<Mesh_properties::Rgb> colors_of_points(const Labelled_mesh& mesh);

/// From 0 to 255.
Color bytes_of(const Mesh_properties::Rgb& color);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LABELLED_MESH_H
