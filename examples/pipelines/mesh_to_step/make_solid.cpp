// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_solid.h"

#include "bodies.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace mesh_to_step {

namespace {

/// The plane of a triangle.
Fitted_surface plane_of(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = halfedge(f, mesh);
  const Point &a = mesh.point(source(h, mesh)), &b = mesh.point(target(h, mesh)),
              &c = mesh.point(target(next(h, mesh), mesh));
  const Kernel::Vector_3 normal = CGAL::cross_product(b - a, c - a);
  Fitted_surface result;
  result.kind = RS::Surface_kind::PLANE;
  result.point = a;
  if (const double length = std::sqrt(normal.squared_length()); length > 0)
    result.direction = normal / length;
  return result;
}

/// Makes each triangle of some faces a face of its own.
void divide_into_facets(const Mesh& mesh, const std::set<std::size_t>& divided,
                        Labelled_faces& labelled)
{
  for (auto f : faces(mesh))
    if (std::size_t& label = labelled.labels[f]; divided.count(label) > 0) {
      if (labelled.is_facet[label]) { // by another triangle of the face
        label = labelled.surfaces.size();
        labelled.surfaces.emplace_back();
        labelled.is_facet.push_back(true);
      }
      labelled.surfaces[label] = plane_of(mesh, f);
      labelled.is_facet[label] = true;
    }
}

/// The faces that are not right; planes only if nothing else is, since one with an edge of such a
/// face is not right either.
std::set<std::size_t> wrong_faces(const Trimmed_faces& trimmed, const Labelled_faces& labelled)
{
  std::set<std::size_t> planes, others;
  for (std::size_t i = 0; i < labelled.surfaces.size(); ++i)
    if (!labelled.is_facet[i] && !trimmed.is_right(i))
      (labelled.surfaces[i].kind == RS::Surface_kind::PLANE ? planes : others).insert(i);
  return others.empty() ? planes : others;
}

/// Of each body a solid: of its outer shell, and those of its voids.
TopoDS_Shape make_shape(const Mesh& mesh, const Bodies& bodies, const Labels& labels,
                        const std::vector<TopoDS_Shape>& shapes)
{
  BRep_Builder builder;
  std::map<std::size_t, std::map<std::size_t, TopoDS_Shell>> shells; // by body and component
  std::set<std::size_t> added;
  for (auto f : faces(mesh))
    if (added.insert(labels[f]).second) {
      TopoDS_Shell& shell = shells[bodies.body[f]][bodies.component[f]];
      if (shell.IsNull())
        builder.MakeShell(shell);
      for (TopExp_Explorer face(shapes[labels[f]], TopAbs_FACE); face.More(); face.Next())
        builder.Add(shell, face.Current());
    }
  TopoDS_Compound result;
  builder.MakeCompound(result);
  for (auto& [body, shells_of_body] : shells) {
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    for (auto& [component, shell] : shells_of_body) {
      shell.Closed(BRep_Tool::IsClosed(shell));
      builder.Add(solid, shell);
    }
    builder.Add(result, solid);
  }
  return result.NbChildren() == 1 ? TopoDS_Iterator(result).Value() : result;
}

/// The labels of the faces of the shape, in its order.
std::vector<std::size_t> labels_of_faces(const TopoDS_Shape& shape,
                                         const std::vector<TopoDS_Shape>& shapes)
{
  NCollection_DataMap<TopoDS_Shape, std::size_t, TopTools_ShapeMapHasher> label_of;
  for (std::size_t label = 0; label < shapes.size(); ++label)
    for (TopExp_Explorer face(shapes[label], TopAbs_FACE); face.More(); face.Next())
      label_of.Bind(face.Current(), label);
  std::vector<std::size_t> result;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    result.push_back(label_of.Find(face.Current()));
  return result;
}

} // namespace

Solid make_solid(Mesh mesh, const Labels& face_of_triangle, const Part_faces& part_faces,
                 Facets facets)
{
  Solid result;
  result.mesh = std::move(mesh);
  const Bodies bodies = orient_bodies(result.mesh);
  Labelled_faces labelled;
  labelled.labels = result.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:solid_face")
                      .first;
  for (auto f : faces(result.mesh))
    labelled.labels[f] = face_of_triangle[f];
  for (const auto& face : part_faces)
    labelled.surfaces.push_back(face.surface);
  labelled.is_facet.resize(part_faces.size(), false);
  std::optional<Trimmed_faces> trimmed(std::in_place, result.mesh, labelled);
  result.faces_as_facets = wrong_faces(*trimmed, labelled);
  if (facets == Facets::ALLOWED && !result.faces_as_facets.empty()) {
    divide_into_facets(result.mesh, result.faces_as_facets, labelled);
    trimmed.emplace(result.mesh, labelled);
  }
  result.shape = make_shape(result.mesh, bodies, labelled.labels, trimmed->shapes());
  result.labels = labelled.labels;
  result.number_of_labels = labelled.surfaces.size();
  result.label_of_face = labels_of_faces(result.shape, trimmed->shapes());
  return result;
}

} // namespace mesh_to_step
