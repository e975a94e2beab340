// SPDX-License-Identifier: GPL-3.0-or-later

#include "step_text.h"

#include "Trimmed_faces.h"
#include "make_solid.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <cmath>
#include <iterator>
#include <sstream>

namespace mesh_to_step {

namespace {

/// OpenCASCADE tells on stdout what it does.
void be_silent()
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

/// "near (1 2 3)".
std::string place(const Mesh& mesh, Mesh::Halfedge_index h)
{
  std::ostringstream text;
  text << "near (" << mesh.point(source(h, mesh)) << ")";
  return text.str();
}

void tell_facets(const Solid& solid, const std::vector<RS::Part_face<Kernel>>& faces,
                 const Mesh& mesh,
                 const Mesh::Property_map<Mesh::Face_index, std::size_t>& face_of_triangle,
                 std::vector<std::string>& remarks)
{
  const char* const kinds[] = {"plane", "cylinder", "cone", "sphere", "torus", "freeform"};
  std::set<std::size_t> waiting = solid.faces_as_facets;
  for (auto f : mesh.faces())
    if (const std::size_t face = face_of_triangle[f]; waiting.erase(face) > 0)
      remarks.push_back("face " + std::to_string(face) + ", " +
                        kinds[int(faces[face].surface.kind)] + " " +
                        place(mesh, halfedge(f, mesh)) + ", is facets");
}

void tell_border(const Mesh& mesh, std::vector<std::string>& remarks)
{
  std::size_t count = 0;
  Mesh::Halfedge_index first;
  for (auto h : halfedges(mesh))
    if (is_border(h, mesh) && count++ == 0)
      first = h;
  if (count > 0)
    remarks.push_back("the mesh is open: " + std::to_string(count) +
                      " edges have one face, the first " + place(mesh, first) +
                      "; so this is a shell, not a solid");
}

/// Whether the shape in the file is what it should be.
bool check(const Shape_properties& shape, double expected_volume, std::vector<std::string>& remarks)
{
  constexpr double tolerance = 1e-3; // of the volume
  std::ostringstream text;
  text << shape.number_of_faces << " faces, volume " << shape.volume << ", edges within "
       << shape.gap << " of their faces";
  const bool has_volume = expected_volume > 0,
             is_exact = std::fabs(shape.volume - expected_volume) <= tolerance * expected_volume;
  if (!shape.is_solid)
    text << "; this is not a valid closed solid";
  else if (!has_volume)
    text << "; the mesh encloses nothing";
  else if (!is_exact)
    text << "; the volume should be " << expected_volume;
  remarks.push_back(text.str());
  return shape.is_solid && has_volume && is_exact;
}

/// \throws Standard_Failure if the lengths are none that OpenCASCADE, whose tolerance is 1e-7, can
/// compute with
void check_size(const Mesh& mesh)
{
  constexpr double least = 1e-3, most = 1e12;
  const double size = size_of(mesh);
  if (size >= least && size <= most)
    return;
  std::ostringstream text;
  text << "the size of the part is " << size << ", OpenCASCADE needs one from " << least << " to "
       << most;
  throw Standard_Failure(text.str().c_str());
}

} // namespace

std::string step_text(const TopoDS_Shape& shape)
{
  be_silent();
  STEPControl_Writer writer;
  std::ostringstream text;
  if (writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone) {
    StepData_StepWriter lines(writer.Model());
    lines.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
    lines.Print(text);
  }
  return text.str();
}

TopoDS_Shape shape_of(const std::string& step_text)
{
  be_silent();
  STEPControl_Reader reader;
  std::istringstream text(step_text);
  if (reader.ReadStream("part", text) != IFSelect_RetDone)
    return {};
  reader.TransferRoots();
  return reader.OneShape();
}

Step_part make_step_part(Mesh mesh)
{
  check_size(mesh);
  if (is_closed(mesh))
    CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(mesh);
  auto face_of_triangle = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part_face").first;
  std::vector<RS::Part_face<Kernel>> faces;
  RS::find_part_faces(mesh, face_of_triangle, std::back_inserter(faces));
  const Solid solid = make_solid(mesh, face_of_triangle, faces);
  Step_part result;
  result.text = step_text(solid.shape);
  result.remarks.push_back(std::to_string(faces.size()) + " faces of the part");
  tell_facets(solid, faces, mesh, face_of_triangle, result.remarks);
  tell_border(mesh, result.remarks);
  result.is_solid = check(properties_of(shape_of(result.text)), solid.expected_volume,
                          result.remarks);
  return result;
}

} // namespace mesh_to_step
