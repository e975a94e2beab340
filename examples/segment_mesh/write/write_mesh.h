// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H

#include "segmentation/Segmentation_details.h"
#include "soup/Mesh_properties.h"
#include "soup/Polygon_soup.h"
#include "soup/triangulate_polygon.h"
#include "view/segment_colors.h"

#include <cstddef>
#include <iosfwd>
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

/// Of a corner; (0, 0) where it has none.
Mesh_properties::Texture_point texture_point(const Mesh_properties& properties, std::size_t corner);

/// Adds the triangles of a polygon that have three different points.
void add_triangles(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon,
                   Triangles& triangles);

/// A segment as a part of its own.
struct Segment_triangles
{
  std::string name;
  Color color;
  Mesh_part part;
  Triangles triangles;                       ///< at least one; each has three different points
  std::vector<std::size_t> face_of_triangle; ///< of the part
};

/// All segments with a face of at least three different points.
std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh);

/// The name of a file that is given from one folder, as seen from another one.
std::string relative_name(const std::string& from, const std::string& name, const std::string& to);

/// \name Meshes with a segment for each face
/// They keep the colors of points; `.ply` and `.obj` also texture coordinates, and the sets of
/// faces, by name; `.vtp` these by number.
/// @{

/// Binary, little endian: double coordinates; for each face its points, a color and an int
/// `segment`; for each kind of sets an int, whose names are in comments.
void write_ply(std::ostream& out, const Labelled_mesh& mesh);

/// Colored faces: red, green and blue from 0 to 255 after the indices.
void write_off(std::ostream& out, const Labelled_mesh& mesh);

/// Whether the materials of the input go into a .obj file, and not those of the segments.
bool has_obj_materials(const Mesh_properties& properties);
/// A group with the name of each segment, after it that of the group or solid of the input; the
/// material of the input, or one of the segment. The faces of a segment are in their order.
/// `libraries`: the names of the files of the materials
void write_obj(std::ostream& out, const Labelled_mesh& mesh,
               const std::vector<std::string>& libraries = {});
/// The materials of segments: their colors.
void write_mtl(std::ostream& out, const Labelled_mesh& mesh);

/// PolyData of VTK: text, with the arrays `segment` and `color` of the faces.
void write_vtp(std::ostream& out, const Labelled_mesh& mesh);
/// @}

/// \name A part for each segment, polygons as triangles; without faces of no segment
/// @{

/// Text, since binary files have no names: a solid for each segment.
void write_stl(std::ostream& out, const Labelled_mesh& mesh);

/// glTF: a node and mesh for each segment; coordinates as float, normals, and of the input colors
/// and texture coordinates; the materials of the input if it is glTF, else one of each segment,
/// which is white where points have colors. `folder`: that of the file, for the names of images
void write_glb(std::ostream& out, const Labelled_mesh& mesh, const std::string& folder = "");

/// 3D Manufacturing Format: an object and material for each segment, in millimeters.
void write_3mf(std::ostream& out, const Labelled_mesh& mesh);
/// @}

/// \name The mesh in one piece, polygons as triangles
/// @{

/// 3D Manufacturing Format: one object, whose triangles are painted for extruder I modulo 15 of a
/// slicer, from 0, in segment I, and not at all in none.
void write_painted_3mf(std::ostream& out, const Labelled_mesh& mesh);

/// MSH 2.2 of gmsh, text: a surface and a physical group for each segment I, both with the number
/// I + 1; faces of no segment are a surface without a group.
void write_msh(std::ostream& out, const Labelled_mesh& mesh);
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
