// SPDX-License-Identifier: GPL-3.0-or-later
//
// A machine part as a solid of planes, cylinders, cones, spheres, tori and freeform faces, in a
// STEP file: mesh_to_step PART.stl PART.step. Ends with 1 if the solid in the file is not closed,
// valid, and of the volume of the part.

#include "../../example_mesh.h"

#include "make_solid.h"
#include "step_file.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <Standard_Failure.hxx>

#include <cmath>
#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace {

void tell_borders(const Mesh& mesh)
{
  std::size_t count = 0;
  Mesh::Halfedge_index first;
  for (auto h : halfedges(mesh))
    if (is_border(h, mesh) && count++ == 0)
      first = h;
  if (count > 0)
    std::cout << "The mesh is open: " << count << " edges have one face, the first near ("
              << mesh.point(source(first, mesh)) << "), so there is a shell, but no solid.\n";
}

void tell_facets(const std::set<std::size_t>& faces_as_facets,
                 const std::vector<RS::Part_face<Kernel>>& faces, const Mesh& mesh,
                 const Mesh::Property_map<Mesh::Face_index, std::size_t>& face_of_triangle)
{
  const char* const kinds[] = {"plane", "cylinder", "cone", "sphere", "torus", "freeform"};
  for (const std::size_t face : faces_as_facets)
    for (auto f : mesh.faces())
      if (face_of_triangle[f] == face) {
        std::cout << "Face " << face << ", " << kinds[int(faces[face].surface.kind)] << " near ("
                  << mesh.point(source(halfedge(f, mesh), mesh)) << "), is facets.\n";
        break;
      }
}

/// Whether the solid is right.
bool tell_solid(const mesh_to_step::Shape_properties& solid, double expected_volume)
{
  constexpr double tolerance = 1e-3; // of the volume
  const bool has_volume = std::fabs(solid.volume - expected_volume) <=
                          tolerance * std::fabs(expected_volume);
  std::cout << solid.number_of_faces << " faces, volume " << solid.volume << ", edges within "
            << solid.gap << " of their faces\n";
  if (!solid.is_solid)
    std::cout << "This is not a valid closed solid.\n";
  else if (!has_volume)
    std::cout << "The volume should be " << expected_volume << ".\n";
  return solid.is_solid && has_volume;
}

} // namespace

int main(int argc, char** argv)
try {
  Mesh mesh = read_mesh(argc, argv, "flange.off");
  const char* const file = argc > 2 ? argv[2] : "mesh_to_step.step";
  if (is_closed(mesh))
    CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(mesh);
  auto face_of_triangle = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part_face").first;
  std::vector<RS::Part_face<Kernel>> faces;
  RS::find_part_faces(mesh, face_of_triangle, std::back_inserter(faces));
  const mesh_to_step::Solid solid = mesh_to_step::make_solid(mesh, face_of_triangle, faces);

  if (!mesh_to_step::write_step(solid.shape, file)) {
    std::cerr << file << " cannot be written\n";
    return EXIT_FAILURE;
  }
  std::cout << faces.size() << " faces of the part\n";
  tell_facets(solid.faces_as_facets, faces, mesh, face_of_triangle);
  tell_borders(mesh);
  const TopoDS_Shape written = mesh_to_step::read_step(file); // others read the file as it is
  return tell_solid(mesh_to_step::properties_of(written), solid.expected_volume) ? EXIT_SUCCESS
                                                                                 : EXIT_FAILURE;
} catch (const Standard_Failure& failure) {
  std::cerr << "no solid is made: " << failure.GetMessageString() << '\n';
  return EXIT_FAILURE;
}
