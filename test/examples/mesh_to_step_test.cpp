// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids of parts whose faces, radii and volumes are known, as they are read from their STEP files.

#include "bodies.h"
#include "check_solid.h"
#include "design_intent.h"
#include "step_part.h"
#include "step_text.h"

#include "../shapes_with_faces.h"
#include "mesh_of.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include <Standard_Failure.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using mesh_to_step::Certificate;
using mesh_to_step::Facets;
using mesh_to_step::Labels;
using mesh_to_step::Mesh;
using mesh_to_step::Part_faces;

namespace {

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
  std::vector<std::string> names; // of faces of the solid
  mesh_to_step::Named_shape read;
  Certificate measured;
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
  for (const std::size_t label : result.solid.label_of_face)
    result.names.push_back(std::to_string(label));
  result.read = mesh_to_step::shape_of(mesh_to_step::step_text(result.solid.shape, result.names));
  result.measured = mesh_to_step::compare(result.read, result.solid, result.names);
  return result;
}

Result through_a_file(const Mesh& mesh)
{
  return through_a_file(mesh, [](const Part_faces&) {});
}

bool is_solid(const Result& result)
{
  return result.measured.is_valid && result.measured.is_closed;
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
  EXPECT_TRUE(is_solid(result));
  EXPECT_EQ(result.measured.bodies.size(), 1u);
  EXPECT_TRUE(result.solid.faces_as_facets.empty());
  EXPECT_EQ(result.faces.size(), number_of_faces);
  EXPECT_EQ(result.measured.number_of_faces, number_of_faces);
  EXPECT_NEAR(result.measured.volume, volume, 1e-4 * volume);
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(result.solid.mesh), volume,
              result.measured.volume_error + 1e-9 * volume);
  const double rounding = 2e-7 * mesh_to_step::size_of(result.solid.mesh);
  EXPECT_LT(result.measured.gap, rounding);
  for (const auto& errors : result.measured.faces) {
    EXPECT_LT(errors.of_vertices, rounding);
    EXPECT_LE(errors.of_surface, 2 * errors.of_sides + rounding);
  }
  const std::multiset<double> found = radii(result.read.shape);
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
  const double pi = shapes_with_faces::pi,
               disc = 1e4 * 20 + 9025 * 5 + 190 * 25 * pi / 4 + 250. / 3, // with its rounding
    hub = 36000 - 120 * 25 * pi + 2000. / 3 + 2500 * 35 +                 // with its blend
          5. / 3 * (2500 + 2250 + 2025),                                  // and chamfer
    bore = 625 * 75, holes = 6 * 64 * 25;
  expect_solid(through_a_file(mesh), 15, {5, 8, 8, 8, 8, 8, 8, 10, 25, 50, 100},
               pi * (disc + hub - bore - holes));
}

TEST(Mesh_to_step, a_tube_with_oblique_ends)
{
  const auto torus = BRepPrimAPI_MakeTorus(9, 2).Shape();
  const auto box = BRepPrimAPI_MakeBox(gp_Pnt(3, -20, -20), gp_Pnt(20, 20, 20)).Shape();
  const TopoDS_Shape tube = BRepAlgoAPI_Cut(torus, box).Shape();
  GProp_GProps volume;
  BRepGProp::VolumeProperties(tube, volume, 1e-6);
  const Result result = through_a_file(mesh_of(tube));
  EXPECT_TRUE(is_solid(result));
  EXPECT_TRUE(result.solid.faces_as_facets.empty());
  EXPECT_EQ(result.faces.size(), 3u);
  EXPECT_EQ(result.measured.faces.size(), 3u);
  EXPECT_NEAR(result.measured.volume, volume.Mass(), 1e-4 * volume.Mass());
}

TEST(Mesh_to_step, a_freeform_face_with_a_hole)
{
  auto shape = shapes_with_faces::ring(9, 9, 4, 6, 64, 1);
  for (auto& p : shape.points)
    if (p.z > 3)
      p.z += 0.02 * p.x * p.x + 0.001 * p.x * p.y * p.y;
  const Result result = through_a_file(to_mesh(shape));
  EXPECT_TRUE(is_solid(result));
  EXPECT_TRUE(result.solid.faces_as_facets.empty());
  EXPECT_EQ(result.measured.number_of_faces, 4u);
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
  EXPECT_TRUE(open.text.empty());
  ASSERT_EQ(open.remarks.size(), 2u);
  EXPECT_EQ(open.remarks[1].find("the mesh is open: 3 edges have one face, the first near ("), 0u);
}

TEST(Mesh_to_step, a_hole_without_its_wall_is_no_solid)
{
  auto shape = frustum_with_bore();
  constexpr int wall = 1;
  for (std::size_t i = shape.triangles.size(); i-- > 0;)
    if (shape.faces[i] == wall)
      shape.triangles.erase(shape.triangles.begin() + std::ptrdiff_t(i));
  EXPECT_FALSE(mesh_to_step::make_step_part(to_mesh(shape)).is_solid);
}

/// Moves the points at random.
void add_noise(shapes_with_faces::Shape& shape, double deviation)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, deviation);
  for (auto& p : shape.points)
    p = p + shapes_with_faces::Point{noise(random), noise(random), noise(random)};
}

TEST(Mesh_to_step, relations_hold_in_spite_of_noise)
{
  const double size = 3, radius = 1, length = 10;
  auto bar = shapes_with_faces::filleted_bar(size, radius, length, 12, 6);
  add_noise(bar, 1e-5 * length);
  const Mesh mesh = to_mesh(bar);
  const mesh_to_step::Step_part part = mesh_to_step::make_step_part(mesh),
                                found = mesh_to_step::make_step_part(
                                  mesh, Facets::REFUSED, mesh_to_step::Design_intent::AS_FOUND);
  ASSERT_TRUE(part.is_solid) << part.remarks.back();
  const std::multiset<double> equal = radii(mesh_to_step::shape_of(part.text).shape);
  ASSERT_EQ(equal.size(), 4u);
  EXPECT_NEAR(*equal.begin(), radius, 1e-4);
  EXPECT_LT(*equal.rbegin() - *equal.begin(), 1e-9);
  if (found.is_solid) {
    const std::multiset<double> others = radii(mesh_to_step::shape_of(found.text).shape);
    EXPECT_GT(*others.rbegin() - *others.begin(), 1e-7);
  }
  EXPECT_NE(part.report.find("\"tangent\""), std::string::npos);
  EXPECT_EQ(found.report.find("\"tangent\""), std::string::npos);
}

TEST(Mesh_to_step, a_hole_is_through_or_blind)
{
  const auto with_blind_hole = shapes_with_faces::revolved(
    {{0, 0}, {3, 0}, {3, 5}, {1, 5}, {1, 2}, {0, 2}}, 24);
  const auto report = [](const shapes_with_faces::Shape& shape) {
    return mesh_to_step::make_step_part(to_mesh(shape)).report;
  };
  EXPECT_NE(report(frustum_with_bore()).find("\"is_blind\": false"), std::string::npos);
  EXPECT_NE(report(with_blind_hole).find("\"is_blind\": true"), std::string::npos);
}

TEST(Mesh_to_step, a_right_angle_that_is_none_stays)
{
  auto box = shapes_with_faces::box(3, 4, 5, 2);
  constexpr double shear = 1e-5;
  for (auto& p : box.points)
    p.x += shear * p.z;
  Mesh mesh = to_mesh(box);
  const Labels labels = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part_face").first;
  Part_faces faces;
  RS::find_part_faces(mesh, labels, std::back_inserter(faces));
  const mesh_to_step::Design_log log = mesh_to_step::set_design_intent(mesh, labels, faces);
  std::multiset<std::string> names;
  for (const auto& relation : log.relations)
    names.insert(relation.name);
  EXPECT_EQ(names.count("parallel"), 3u);
  EXPECT_EQ(names.count("perpendicular"), 2u);
  for (const auto& face : faces)
    EXPECT_LT(face.surface.deviation, 1e-9);
}

TEST(Mesh_to_step, a_surface_that_is_not_that_of_its_triangles_is_told)
{
  const Result result = through_a_file(to_mesh(frustum_with_bore()), [](Part_faces& faces) {
    for (auto& face : faces)
      if (face.surface.kind == RS::Surface_kind::CYLINDER)
        face.surface.radius *= 1.05;
  });
  double farthest = 0;
  for (const auto& errors : result.measured.faces)
    farthest = (std::max)(farthest, errors.of_vertices);
  EXPECT_TRUE(!result.solid.faces_as_facets.empty() || farthest > 0.04);
}

TEST(Mesh_to_step, a_solid_elsewhere_is_told)
{
  const Result result = through_a_file(to_mesh(frustum_with_bore()));
  gp_Trsf move;
  move.SetTranslation({0.01, 0, 0.01});
  mesh_to_step::Named_shape moved = result.read;
  moved.shape = BRepBuilderAPI_Transform(moved.shape, move, true).Shape();
  const Certificate measured = mesh_to_step::compare(moved, result.solid, result.names);
  ASSERT_EQ(measured.faces.size(), 4u);
  for (const auto& errors : measured.faces)
    EXPECT_GT(errors.of_vertices, 0.005);
}

using Polygons = std::vector<std::vector<std::size_t>>;

/// Adds a box of quads.
void add_box(const mesh_to_step::Point& low, const mesh_to_step::Point& high, bool is_void,
             std::vector<mesh_to_step::Point>& points, Polygons& polygons)
{
  const std::size_t first = points.size();
  for (int i = 0; i < 8; ++i)
    points.emplace_back((i & 1 ? high : low).x(), (i & 2 ? high : low).y(),
                        (i & 4 ? high : low).z());
  for (std::vector<std::size_t> quad : Polygons{
         {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    if (is_void)
      std::reverse(quad.begin(), quad.end());
    for (std::size_t& v : quad)
      v += first;
    polygons.push_back(quad);
  }
}

TEST(Mesh_to_step, bodies_that_touch_are_solids)
{
  std::vector<mesh_to_step::Point> points;
  Polygons polygons;
  add_box({0, 0, 0}, {2, 3, 4}, false, points, polygons);
  add_box({2, 0, 0}, {7, 3, 4}, false, points, polygons); // at a whole face of the first one
  add_box({0, 3, 0}, {2, 4, 4}, false, points, polygons);
  add_box({3, 1, 1}, {4, 2, 2}, true, points, polygons);
  std::mt19937 random(7);
  std::shuffle(polygons.begin(), polygons.end(), random);
  const Result result = through_a_file(mesh_to_step::make_bodies(points, polygons));
  EXPECT_TRUE(is_solid(result));
  ASSERT_EQ(result.measured.bodies.size(), 3u);
  EXPECT_EQ(result.measured.number_of_faces, 24u);
  std::multiset<double> volumes, numbers_of_faces;
  for (const auto& body : result.measured.bodies) {
    volumes.insert(std::round(body.volume));
    numbers_of_faces.insert(double(body.face_names.size()));
  }
  EXPECT_EQ(volumes, (std::multiset<double>{8, 24, 59}));
  EXPECT_EQ(numbers_of_faces, (std::multiset<double>{6, 6, 12}));
  EXPECT_NEAR(result.measured.volume, 24 + 60 + 8 - 1, 1e-9);
}

TEST(Mesh_to_step, facets_are_refused)
{
  auto shape = shapes_with_faces::torus(5, 2, 20, 12);
  for (auto& p : shape.points) // no face without a border is flattened
    p.z *= 1 + 0.2 * std::sin(p.x);
  const mesh_to_step::Step_part refused = mesh_to_step::make_step_part(to_mesh(shape)),
                                allowed = mesh_to_step::make_step_part(to_mesh(shape),
                                                                       Facets::ALLOWED);
  EXPECT_FALSE(refused.is_solid);
  EXPECT_TRUE(allowed.is_solid) << allowed.remarks.back();
}

TEST(Mesh_to_step, two_sides_of_a_triangle_are_no_solid)
{
  const Polygons two_sides{{0, 1, 2}, {0, 2, 1}};
  EXPECT_FALSE(mesh_to_step::make_step_part(
                 mesh_to_step::make_bodies({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, two_sides))
                 .is_solid);
}

TEST(Mesh_to_step, two_sides_of_a_square_are_no_solid)
{
  const std::vector<mesh_to_step::Point> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Polygons two_sides{{0, 1, 2}, {0, 2, 3}, {3, 1, 0}, {3, 2, 1}};
  const mesh_to_step::Step_part part = mesh_to_step::make_step_part(
    mesh_to_step::make_bodies(points, two_sides));
  EXPECT_FALSE(part.is_solid);
  EXPECT_NE(part.remarks.back().find("the mesh encloses nothing"), std::string::npos)
    << part.remarks.back();
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
