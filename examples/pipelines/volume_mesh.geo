// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tetrahedra for simulation, by gmsh (4.8 or later), from the segments of a closed surface:
//
//   segment_mesh part.stl --method smooth-faces -o part.msh
//   gmsh -3 part.msh volume_mesh.geo -setnumber size 2 -o part_volume.msh
//
// The segments are gmsh's surfaces, which it need not guess by an angle, and physical groups of the same names in the result,
// beside the group "volume". With a `size`, an edge length in units of the mesh, each segment is meshed anew; without it the
// triangles stay as they are.
DefineConstant[ size = {0, Name "Edge length"} ];

CreateTopology; // curves where segments meet
If(size > 0)
  CreateGeometry; // a parametrization of each segment
  Mesh.MeshSizeMin = size;
  Mesh.MeshSizeMax = size;
EndIf
Surface Loop(1) = Surface{:}; // of one solid, with its cavities
Volume(1) = {1};
Physical Volume("volume") = {1};
Mesh.SaveGroupsOfNodes = 1; // in .inp and .unv files
