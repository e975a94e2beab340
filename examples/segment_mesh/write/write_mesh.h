// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H

#include "segmentation/Segmentation_details.h"
#include "soup/Polygon_soup.h"
#include "soup/triangulate_polygon.h"
#include "view/segment_colors.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace segment_mesh {

/// A mesh, or a part of it, with a segment for each face, `no_segment` for none.
struct Labelled_mesh
{
  const Polygon_soup& soup;
  const std::vector<std::size_t>& segment_of_face;
};

/// By segment, in their order; the last ones are those of no segment.
std::vector<std::vector<std::size_t>>
faces_of_segments(const std::vector<std::size_t>& segment_of_face);

/// Some faces, in their order, with their points in the order of the mesh. O(n log n) in their
/// corners.
Polygon_soup extract_faces(const Polygon_soup& soup, const std::vector<std::size_t>& faces);

/// A segment as a part of its own.
struct Segment_triangles
{
  std::string name; ///< `segment_I`
  Color color;
  std::vector<Point> points;
  Triangles triangles; ///< at least one; each has three different points
};

/// All segments with a face of at least three different points.
std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh);

/// \name Meshes with a segment for each face
/// @{

/// Binary, little endian: double coordinates; for each face its points, a color and an int
/// `segment`.
void write_ply(std::ostream& out, const Labelled_mesh& mesh);

/// Colored faces: red, green and blue from 0 to 255 after the indices.
void write_off(std::ostream& out, const Labelled_mesh& mesh);

/// A group and a material `segment_I` for each segment; its faces are in their order.
/// `material_library`: the name of the file of the materials, empty if there is none
void write_obj(std::ostream& out, const Labelled_mesh& mesh,
               const std::string& material_library = "");
/// The materials of `write_obj()`: the colors of the segments.
void write_mtl(std::ostream& out, const Labelled_mesh& mesh);

/// PolyData of VTK: text, with the arrays `segment` and `color` of the faces.
void write_vtp(std::ostream& out, const Labelled_mesh& mesh);
/// @}

/// \name A part for each segment, polygons as triangles; without faces of no segment
/// @{

/// Text, since binary files have no names: a solid `segment_I` for each segment.
void write_stl(std::ostream& out, const Labelled_mesh& mesh);

/// glTF: a node, mesh and material `segment_I` for each segment; coordinates as float, and normals.
void write_glb(std::ostream& out, const Labelled_mesh& mesh);

/// 3D Manufacturing Format: an object and material `segment_I` for each segment, in millimeters.
void write_3mf(std::ostream& out, const Labelled_mesh& mesh);
/// @}

/// \name Borders as polylines, with the points that they use
/// @{

/// An `l` element for each border, in a group `border_I_J` of the segments to its left and right.
void write_borders_obj(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders);

/// Lines of PolyData, with the arrays `left_segment` and `right_segment`.
void write_borders_vtp(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders);
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H
