// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "Gmsh Reference Manual", version 2 of the MSH file format. Programs other than gmsh read
// it more often than version 4.

#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <ostream>
#include <set>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

void write_names(Text_buffer& text, const Labelled_mesh& mesh)
{
  std::set<std::size_t> segments(mesh.segment_of_face.begin(), mesh.segment_of_face.end());
  segments.erase(std::size_t(RS::no_segment));
  text << "$PhysicalNames\n" << segments.size() << "\n";
  for (std::size_t s : segments)
    text << "2 " << s + 1 << " \"" << mesh.name(s) << "\"\n"; // 2: a surface
  text << "$EndPhysicalNames\n";
}

void write_nodes(Text_buffer& text, const std::vector<Point>& points)
{
  text << "$Nodes\n" << points.size() << "\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    text << i + 1 << " " << points[i][0] << " " << points[i][1] << " " << points[i][2] << "\n";
  text << "$EndNodes\n";
}

/// Triangles in the order of `mesh`; those of the faces of no segment are of surface
/// `number_of_segments` + 1.
void write_elements(Text_buffer& text, const Polygon_soup& soup, const Labelled_mesh& mesh,
                    std::size_t number_of_segments)
{
  const auto [triangles, face_of_triangle] = triangulate_faces(soup);
  text << "$Elements\n" << triangles.size() << "\n";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t segment = mesh.segment_of_face[face_of_triangle[i]],
                      surface = (std::min)(segment, number_of_segments) + 1,
                      group = surface > number_of_segments ? 0 : surface;
    text << i + 1 << " 2 2 " << group << " " << surface; // a triangle with two numbers
    for (const Polygons::Index point : triangles[i])
      text << " " << point + 1;
    text << "\n";
  }
  text << "$EndElements\n";
}

} // namespace

void write_msh(std::ostream& out, const Labelled_mesh& mesh)
{
  const std::size_t number_of_segments = faces_of_segments(mesh.segment_of_face).size() - 1;
  std::vector<std::size_t> faces(mesh.soup.polygons.size());
  std::iota(faces.begin(), faces.end(), std::size_t(0));
  const Polygon_soup soup = extract_faces(mesh, faces).soup; // with no other points
  Text_buffer text(out);
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"; // text; numbers of 8 bytes
  write_names(text, mesh);
  write_nodes(text, soup.points);
  write_elements(text, soup, mesh, number_of_segments);
}

} // namespace segment_mesh
