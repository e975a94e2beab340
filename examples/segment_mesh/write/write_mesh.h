// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H

#include "write/Labelled_mesh.h"
#include "segmentation/Segmentation_details.h"

#include <iosfwd>
#include <vector>

namespace segment_mesh {

/// \name Meshes with segments, and polylines; faces in their order
/// @{

/// Binary, little endian: double coordinates; for each face its points, a color and an int
/// `segment`.
void write_ply(std::ostream& out, const Labelled_mesh& mesh);

/// Colored faces: red, green and blue from 0 to 255 after the indices.
void write_off(std::ostream& out, const Labelled_mesh& mesh);

/// A group `segment_I` for each segment, entered again wherever the order of the faces comes back
/// to it, and a group `feature_lines` of `l` elements if there are any.
void write_obj(std::ostream& out, const Labelled_mesh& mesh,
               const std::vector<Polyline>& feature_lines = {});

/// PolyData of VTK: binary, with the arrays `segment` and `color` of the faces.
void write_vtp(std::ostream& out, const Labelled_mesh& mesh);

/// glTF: a node, mesh and material `segment_I` for each segment; polygons as triangles, coordinates
/// as float. \pre `can_write_glb()`
void write_glb(std::ostream& out, const Labelled_mesh& mesh);
/// Whether the program was built with tinygltf.
bool can_write_glb();

/// 3D Manufacturing Format: an object and material `segment_I` for each segment; as `write_glb()`,
/// in millimeters. \pre `can_write_3mf()`
void write_3mf(std::ostream& out, const Labelled_mesh& mesh);
/// Whether the program was built with lib3mf.
bool can_write_3mf();

/// An `l` element for each border, in a group `border_I_J` of the segments to its left and right;
/// points that no border has are left out.
void write_borders_obj(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders);

/// Lines of PolyData, with the arrays `left_segment` and `right_segment`.
void write_borders_vtp(std::ostream& out, const std::vector<Point>& points,
                       const std::vector<Border>& borders);
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_MESH_H
