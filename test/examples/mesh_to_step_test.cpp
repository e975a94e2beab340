// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids of parts whose faces, radii and volumes are known, as they are read from their STEP files.

#include "make_solid.h"
#include "step_text.h"

#include "../shapes_with_faces.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <BRepAdaptor_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <Standard_Failure.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using mesh_to_step::Shape_properties;

namespace {

using Part_faces = std::vector<RS::Part_face<Kernel>>;
using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;

Mesh to_mesh(const shapes_with_faces::Shape& shape)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const auto& p : shape.points)
    vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (const auto& t : shape.triangles)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return mesh;
}

struct Result
{
  Part_faces faces;
  mesh_to_step::Solid solid;
  TopoDS_Shape read;
  Shape_properties properties;
};

/// `change(faces)` may change what is found.
template <typename Change>
Result through_a_file(Mesh mesh, const Change& change)
{
  Result result;
  const Labels labels = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part_face").first;
  RS::find_part_faces(mesh, labels, std::back_inserter(result.faces));
  change(result.faces);
  result.solid = mesh_to_step::make_solid(mesh, labels, result.faces);
  result.read = mesh_to_step::shape_of(mesh_to_step::step_text(result.solid.shape));
  result.properties = mesh_to_step::properties_of(result.read);
  return result;
}

Result through_a_file(const Mesh& mesh)
{
  return through_a_file(mesh, [](const Part_faces&) {});
}

std::multiset<double> radii(const TopoDS_Shape& shape)
{
  std::multiset<double> result;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(face.Current()));
    if (surface.GetType() == GeomAbs_Cylinder)
      result.insert(surface.Cylinder().Radius());
    if (surface.GetType() == GeomAbs_Sphere)
      result.insert(surface.Sphere().Radius());
    if (surface.GetType() == GeomAbs_Torus)
      result.insert(surface.Torus().MinorRadius());
  }
  return result;
}

/// The solid has all faces, of these radii, and this volume.
void expect_solid(const Result& result, std::size_t number_of_faces,
                  const std::vector<double>& expected_radii, double volume)
{
  EXPECT_TRUE(result.properties.is_solid);
  EXPECT_TRUE(result.solid.faces_as_facets.empty());
  EXPECT_EQ(result.faces.size(), number_of_faces);
  EXPECT_EQ(result.properties.number_of_faces, number_of_faces);
  EXPECT_NEAR(result.properties.volume, volume, 1e-4 * volume);
  EXPECT_NEAR(result.solid.expected_volume, volume, 1e-3 * volume);
  const std::multiset<double> found = radii(result.read);
  ASSERT_EQ(found.size(), expected_radii.size());
  EXPECT_TRUE(std::equal(found.begin(), found.end(), expected_radii.begin(),
                         [](double a, double b) { return std::fabs(a - b) < 1e-4 * b; }));
}

shapes_with_faces::Shape frustum_with_bore()
{
  return shapes_with_faces::ring(3, 2, 1, 4, 24, 3);
}

TEST(Mesh_to_step, a_bar_with_fillets)
{
  const double size = 3, radius = 1, length = 10, width = 2 * (size + radius);
  const auto bar = shapes_with_faces::filleted_bar(size, radius, length, 6, 4);
  expect_solid(through_a_file(to_mesh(bar)), 10, {1, 1, 1, 1},
               (width * width - (4 - shapes_with_faces::pi) * radius * radius) * length);
}

TEST(Mesh_to_step, a_frustum_with_a_bore)
{
  const double pi = shapes_with_faces::pi;
  expect_solid(through_a_file(to_mesh(frustum_with_bore())), 4, {1},
               pi * 4 / 3 * (9 + 6 + 4) - pi * 4);
}

TEST(Mesh_to_step, a_whole_torus)
{
  const double pi = shapes_with_faces::pi;
  expect_solid(through_a_file(to_mesh(shapes_with_faces::torus(5, 2, 40, 24))), 1, {2},
               2 * pi * pi * 5 * 4);
}

TEST(Mesh_to_step, the_flange)
{
  Mesh mesh;
  ASSERT_TRUE(
    CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(CGAL::data_file_path("flange.off"), mesh));
  const Result result = through_a_file(mesh);
  expect_solid(result, 15, {5, 8, 8, 8, 8, 8, 8, 10, 25, 50, 100}, result.solid.expected_volume);
}

TEST(Mesh_to_step, tells_what_is_wrong)
{
  Mesh mesh = to_mesh(frustum_with_bore());
  const mesh_to_step::Step_part whole = mesh_to_step::make_step_part(mesh);
  EXPECT_TRUE(whole.is_solid);
  EXPECT_EQ(whole.remarks.size(), 2u);
  CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  mesh.collect_garbage();
  const mesh_to_step::Step_part open = mesh_to_step::make_step_part(mesh);
  EXPECT_FALSE(open.is_solid);
  ASSERT_EQ(open.remarks.size(), 3u);
  EXPECT_EQ(open.remarks[1].find("the mesh is open: 3 edges have one face, the first near ("), 0u);
}

TEST(Mesh_to_step, a_mesh_without_a_triangle_is_no_solid)
{
  Mesh mesh = to_mesh(frustum_with_bore());
  CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  mesh.collect_garbage();
  const Result result = through_a_file(mesh);
  EXPECT_FALSE(result.properties.is_solid);
  EXPECT_GE(result.properties.number_of_faces, 4u);
}

TEST(Mesh_to_step, a_hole_without_its_wall_is_no_solid)
{
  auto shape = frustum_with_bore();
  constexpr int wall = 1;
  for (std::size_t i = shape.triangles.size(); i-- > 0;)
    if (shape.faces[i] == wall)
      shape.triangles.erase(shape.triangles.begin() + std::ptrdiff_t(i));
  const Result result = through_a_file(to_mesh(shape));
  EXPECT_FALSE(result.properties.is_solid);
  EXPECT_EQ(result.properties.number_of_faces, 3u);
}

TEST(Mesh_to_step, a_surface_that_is_not_that_of_its_triangles_is_told)
{
  const Result result = through_a_file(to_mesh(frustum_with_bore()), [](Part_faces& faces) {
    for (auto& face : faces)
      if (face.surface.kind == RS::Surface_kind::CYLINDER)
        face.surface.radius *= 1.05;
  });
  const double volume = result.solid.expected_volume;
  EXPECT_TRUE(!result.properties.is_solid || !result.solid.faces_as_facets.empty() ||
              std::fabs(result.properties.volume - volume) > 1e-3 * volume ||
              result.properties.gap > 0.01);
}

TEST(Mesh_to_step, two_sides_of_a_triangle_are_no_solid)
{
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
             c = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, b);
  const mesh_to_step::Step_part part = mesh_to_step::make_step_part(mesh);
  EXPECT_FALSE(part.is_solid);
  EXPECT_NE(part.remarks.back().find("the mesh encloses nothing"), std::string::npos);
}

TEST(Mesh_to_step, a_size_out_of_range_is_told)
{
  for (double factor : {1e-9, 1e200}) {
    auto shape = frustum_with_bore();
    for (auto& p : shape.points)
      p = factor * p;
    EXPECT_THROW(mesh_to_step::make_step_part(to_mesh(shape)), Standard_Failure) << factor;
  }
}

} // namespace
