// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H

#include "segmentation/Segmentation_details.h"
#include "write/Labelled_mesh.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace segment_mesh {

/// \name Meshes with a segment for each face
/// `.ply`, `.obj` and `.vtp` keep the colors of points, and the sets of faces, by name, in `.vtp`
/// by number; `.ply` and `.obj` texture coordinates.
/// @{

/// Binary, little endian: double coordinates; for each face its points, a color and an int
/// `segment`; for each kind of sets an int, whose names are in comments. `textures`: the names of
/// image files
void write_ply(std::ostream& out, const Labelled_mesh& mesh,
               const std::vector<std::string>& textures = {});

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

/// Borders as polylines: an `l` element for each, in a group `border_I_J` of the segments to its
/// left and right.
void write_borders_obj(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H
