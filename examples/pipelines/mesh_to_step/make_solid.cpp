// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_solid.h"

#include "Trimmed_faces.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/helpers.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace mesh_to_step {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// Gives faces that have one axis, within the tolerance, exactly one: what is between them are then
/// circles around it.
void share_axes(std::vector<RS::Part_face<Kernel>>& faces, double tolerance)
{
  for (RS::Part_face<Kernel>& face : faces) {
    const Fitted_surface& first = faces[face.first_on_axis].surface;
    Fitted_surface& s = face.surface;
    const Kernel::Line_3 axis(first.point, first.direction);
    const double allowed = tolerance * tolerance;
    if (CGAL::squared_distance(axis, s.point + s.lowest * s.direction) > allowed ||
        CGAL::squared_distance(axis, s.point + s.highest * s.direction) > allowed)
      continue;
    s.point = first.point + ((s.point - first.point) * first.direction) * first.direction;
    s.direction = (s.direction * first.direction > 0 ? 1 : -1) * first.direction;
  }
}

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

/// The shells of the components of the mesh, and if it is closed, a solid of each volume: of its
/// outer shell, and those of its cavities.
TopoDS_Shape make_shape(const Mesh& mesh, const Labels& labels,
                        const std::vector<TopoDS_Shape>& shapes)
{
  const bool is_closed = CGAL::is_closed(mesh);
  const auto number = get(boost::face_index, mesh);
  std::vector<std::size_t> components(num_faces(mesh)), volumes(num_faces(mesh));
  PMP::connected_components(mesh, boost::make_iterator_property_map(components.begin(), number));
  if (is_closed)
    PMP::volume_connected_components(mesh,
                                     boost::make_iterator_property_map(volumes.begin(), number));
  BRep_Builder builder;
  std::map<std::size_t, std::map<std::size_t, TopoDS_Shell>> shells; // by volume and component
  std::set<std::size_t> added;
  for (auto f : faces(mesh))
    if (!shapes[labels[f]].IsNull() && added.insert(labels[f]).second) {
      TopoDS_Shell& shell = shells[volumes[f]][components[f]];
      if (shell.IsNull())
        builder.MakeShell(shell);
      builder.Add(shell, shapes[labels[f]]);
    }
  TopoDS_Compound result;
  builder.MakeCompound(result);
  for (auto& [volume, shells_of_volume] : shells) {
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    for (auto& [component, shell] : shells_of_volume) {
      shell.Closed(BRep_Tool::IsClosed(shell));
      if (is_closed)
        builder.Add(solid, shell);
      else
        builder.Add(result, shell);
    }
    if (is_closed)
      builder.Add(result, solid);
  }
  return result.NbChildren() == 1 ? TopoDS_Iterator(result).Value() : result;
}

} // namespace

Solid make_solid(Mesh mesh, const Labels& face_of_triangle,
                 std::vector<RS::Part_face<Kernel>> part_faces)
{
  constexpr int rounds = 4; // in which edges of facets can make neighbors wrong
  share_axes(part_faces, 1e-6 * size_of(mesh));
  Labelled_faces labelled;
  labelled.labels = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:solid_face").first;
  for (auto f : faces(mesh))
    labelled.labels[f] = face_of_triangle[f];
  for (const RS::Part_face<Kernel>& face : part_faces)
    labelled.surfaces.push_back(face.surface);
  labelled.is_facet.resize(part_faces.size(), false);
  Solid result;
  for (int round = 1;; ++round) {
    const Trimmed_faces trimmed(mesh, labelled);
    const std::set<std::size_t> wrong = wrong_faces(trimmed, labelled);
    if (wrong.empty() || round == rounds) {
      result.shape = make_shape(mesh, labelled.labels, trimmed.shapes());
      for (const Measures& m : trimmed.measures())
        result.expected_volume += m.volume;
      return result;
    }
    result.faces_as_facets.insert(wrong.begin(), wrong.end());
    divide_into_facets(mesh, wrong, labelled);
  }
}

Shape_properties properties_of(const TopoDS_Shape& shape)
{
  Shape_properties result{true, 0, 0, 0};
  std::size_t solids = 0;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    ++solids;
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
    result.is_solid = result.is_solid && BRep_Tool::IsClosed(shell.Current());
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    ++result.number_of_faces;
  for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next())
    result.gap = (std::max)(result.gap, BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
  result.is_solid = result.is_solid && solids > 0 && BRepCheck_Analyzer(shape).IsValid();
  GProp_GProps measured;
  BRepGProp::VolumeProperties(shape, measured);
  result.volume = measured.Mass();
  return result;
}

} // namespace mesh_to_step
