// SPDX-License-Identifier: GPL-3.0-or-later

#include "step_part.h"

#include "check_solid.h"
#include "design_intent.h"
#include "report.h"
#include "step_text.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>

#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace mesh_to_step {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// "near (1 2 3)".
std::string place(const Mesh& mesh, Mesh::Halfedge_index h)
{
  std::ostringstream text;
  text << "near (" << mesh.point(source(h, mesh)) << ")";
  return text.str();
}

/// Tells of some labels, in the order of the mesh.
template <typename Sentence>
void tell(std::set<std::size_t> waiting, const Mesh& mesh, const Labels& labels,
          const Sentence& sentence, std::vector<std::string>& remarks)
{
  for (auto f : mesh.faces())
    if (waiting.erase(labels[f]) > 0)
      remarks.push_back(sentence(labels[f], place(mesh, halfedge(f, mesh))));
}

/// Tells whether there is no border, and else where.
bool tell_closed(const Mesh& mesh, std::vector<std::string>& remarks)
{
  std::size_t count = 0;
  Mesh::Halfedge_index first;
  for (auto h : halfedges(mesh))
    if (is_border(h, mesh) && count++ == 0)
      first = h;
  if (count > 0)
    remarks.push_back("the mesh is open: " + std::to_string(count) +
                      " edges have one face, the first " + place(mesh, first));
  return count == 0;
}

/// The faces that are farther from their triangles than a tolerance, or what they stand for
/// explains; or from their edges, which may be as far as the vertices of the mesh are from simple
/// surfaces.
std::set<std::size_t> wrong_faces(const Certificate& measured, const Part_faces& faces, double size)
{
  constexpr double tolerance = 1e-4, edge_tolerance = 1e-5, most_sides = 10;
  std::set<std::size_t> result;
  double edges_within = edge_tolerance * size;
  for (const auto& face : faces)
    edges_within = (std::max)(edges_within, face.surface.deviation);
  for (std::size_t i = 0; i < measured.faces.size(); ++i) {
    const Face_errors& e = measured.faces[i];
    const double deviation = i < faces.size() ? 2 * faces[i].surface.deviation : 0,
                 allowed = (std::max)(tolerance * size, deviation);
    if (e.of_vertices > allowed || e.of_surface > allowed + most_sides * e.of_sides ||
        e.of_edges > edges_within)
      result.insert(i);
  }
  return result;
}

void tell_errors(const std::set<std::size_t>& wrong, const Certificate& certificate,
                 const Solid& solid, const Part_faces& faces, std::vector<std::string>& remarks)
{
  const auto sentence = [&](std::size_t face, const std::string& where) {
    const Face_errors& e = certificate.faces[face];
    std::ostringstream text;
    text << (face < faces.size() ? face_name(faces, face) : "facet") << ' ' << where
         << ": vertices within " << e.of_vertices << ", the face within " << e.of_surface
         << " of triangles, edges within " << e.of_edges;
    return text.str();
  };
  tell(wrong, solid.mesh, solid.labels, sentence, remarks);
}

/// A sentence on the whole, and whether it is right.
bool tell_whole(const Certificate& c, const Solid& solid, std::vector<std::string>& remarks)
{
  constexpr double precision = 1e-4; // of the volume
  const double volume = PMP::volume(solid.mesh);
  std::ostringstream text;
  text << c.bodies.size() << (c.bodies.size() == 1 ? " solid, " : " solids, ") << c.number_of_faces
       << " faces, volume " << c.volume << " (mesh " << volume << "), area " << c.area << " (mesh "
       << PMP::area(solid.mesh) << "), edges within " << c.gap << " of their faces";
  bool is_right = false;
  if (!c.is_valid || !c.is_closed)
    text << "; this is not a valid closed solid";
  else if (!(volume > 0))
    text << "; the mesh encloses nothing";
  else if (c.faces.empty())
    text << "; " << solid.label_of_face.size() << " faces were written";
  else if (std::fabs(c.volume - volume) > c.volume_error + precision * volume)
    text << "; faces as near to the triangles as these have the volume within " << c.volume_error;
  else
    is_right = true;
  remarks.push_back(text.str());
  return is_right;
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

/// "torus_4" for a face of the part, or "facet_27".
std::vector<std::string> face_names(const Solid& solid, const Part_faces& faces)
{
  std::vector<std::string> result;
  for (const std::size_t label : solid.label_of_face) {
    const bool is_facet = label >= faces.size() || solid.faces_as_facets.count(label) > 0;
    result.push_back(is_facet ? "facet_" + std::to_string(label) : face_name(faces, label));
  }
  return result;
}

} // namespace

Step_part make_step_part(Mesh mesh, Facets facets, Design_intent intent)
{
  check_size(mesh);
  auto face_of_triangle = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part_face").first;
  Part_faces faces;
  RS::find_part_faces(mesh, face_of_triangle, std::back_inserter(faces));
  Step_part result;
  result.remarks.push_back(std::to_string(faces.size()) + " faces of the part");
  Design_log log;
  if (intent == Design_intent::SET)
    log = set_design_intent(mesh, face_of_triangle, faces);
  if (!tell_closed(mesh, result.remarks)) {
    result.report = report(faces, log, {}, {}, false);
    return result;
  }
  const Solid solid = make_solid(mesh, face_of_triangle, faces, facets);
  tell(
    solid.faces_as_facets, mesh, face_of_triangle,
    [&](std::size_t face, const std::string& where) {
      return face_name(faces, face) + " " + where + " cannot be made of its surface";
    },
    result.remarks);
  if (facets == Facets::REFUSED && !solid.faces_as_facets.empty()) {
    result.report = report(faces, log, solid, {}, false);
    return result;
  }
  const std::vector<std::string> names = face_names(solid, faces);
  result.text = step_text(solid.shape, names);
  const Certificate certificate = compare(shape_of(result.text), solid, names);
  const std::set<std::size_t> wrong = wrong_faces(certificate, faces, size_of(mesh));
  tell_errors(wrong, certificate, solid, faces, result.remarks);
  const bool is_right = tell_whole(certificate, solid, result.remarks);
  result.is_solid = is_right && wrong.empty();
  result.report = report(faces, log, solid, certificate, result.is_solid);
  return result;
}

} // namespace mesh_to_step
