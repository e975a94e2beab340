// SPDX-License-Identifier: GPL-3.0-or-later

#include "segments.h"

#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace describe_segments_test {

using Description = RS::Segment_description<std::size_t, Kernel>;
using Vector_3 = Kernel::Vector_3;
using Point_3 = Kernel::Point_3;
const double pi = std::acos(-1.0);

template <typename Mesh = Surface_mesh>
std::vector<Description> descriptions_of(const Soup& soup, const Labels& labels)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  std::vector<Description> result;
  RS::describe_segments(mesh, face_labels(mesh, labels), std::back_inserter(result));
  return result;
}

Description description_of(const Soup& soup)
{
  return descriptions_of(soup, Labels(soup.polygons.size(), 0)).front();
}

template <typename Triple>
void expect_near(const Triple& a, const Triple& b, double tolerance)
{
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance);
}

/// An open surface of `across` times `around` quads; a point for each pair in [0, 1] x [0, 1).
Soup tube(std::size_t across, std::size_t around, const std::function<Point(double, double)>& point,
          double part = 1)
{
  const bool is_closed = part == 1;
  Soup soup;
  const std::size_t columns = is_closed ? around : around + 1;
  for (std::size_t i = 0; i <= across; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      soup.points.push_back(point(double(i) / double(across), part * double(j) / double(around)));
  for (std::size_t i = 0; i < across; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const std::size_t k = (j + 1) % columns;
      soup.polygons.push_back(
        {i * columns + j, i * columns + k, (i + 1) * columns + k, (i + 1) * columns + j});
    }
  return soup;
}

/// A motion that is no symmetry of anything.
Point moved(const Point& p)
{
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.9), t = std::sin(1.9);
  const double x = c * p[0] - s * p[1], y = s * p[0] + c * p[1];
  return {x + 5, d * y - t * p[2] - 3, t * y + d * p[2] + 11};
}

Point_3 moved_point(const Point& p)
{
  return {moved(p)[0], moved(p)[1], moved(p)[2]};
}

Vector_3 moved_direction(const Point& v)
{
  return moved_point(v) - moved_point({0, 0, 0});
}

TEST(Describe_segments_test, knows_a_box)
{
  const Soup box = mapped(cube(), [](const Point& p) {
    return moved({5 * p[0], 2 * p[1], 3 * p[2]});
  });
  for (const Soup& soup : {box, reversed(box)}) { // read as if it were not inside out
    const Description d = description_of(soup);
    EXPECT_EQ(d.number_of_faces, 6u);
    EXPECT_NEAR(d.area, 62, 1e-10);
    EXPECT_NEAR(d.volume, 30, 1e-10);
    EXPECT_DOUBLE_EQ(d.volume_share, 1);
    expect_near(d.centroid, moved_point({2.5, 1, 1.5}), 1e-10);
    EXPECT_NEAR(d.extents[0], 5, 1e-10);
    EXPECT_NEAR(d.extents[1], 3, 1e-10);
    EXPECT_NEAR(d.extents[2], 2, 1e-10);
    EXPECT_NEAR(std::abs(d.axes[0] * moved_direction({1, 0, 0})), 1, 1e-10);
    EXPECT_NEAR(std::abs(d.axes[1] * moved_direction({0, 0, 1})), 1, 1e-10);
    EXPECT_NEAR(CGAL::determinant(d.axes[0], d.axes[1], d.axes[2]), 1, 1e-10);
    EXPECT_TRUE(d.neighbors.empty());
    EXPECT_EQ(d.border_length, 0);
  }
}

TEST(Describe_segments_test, signs_and_weighs_the_angles)
{
  // An L, one label for each square: convex edges everywhere but the reentrant one.
  const Soup soup = l_shape();
  Labels labels;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    labels.push_back(f);
  std::size_t convex = 0, concave = 0, flat = 0;
  for (const Description& d : descriptions_of(soup, labels)) {
    double sum = 0;
    for (const auto& neighbor : d.neighbors) {
      EXPECT_DOUBLE_EQ(neighbor.border_length, 1);
      sum += neighbor.border_length;
      convex += std::abs(neighbor.mean_signed_deviation - pi / 2) < 1e-12;
      concave += std::abs(neighbor.mean_signed_deviation + pi / 2) < 1e-12;
      flat += std::abs(neighbor.mean_signed_deviation) < 1e-12;
    }
    EXPECT_DOUBLE_EQ(d.border_length, sum);
  }
  EXPECT_EQ(concave, 2u); // one edge, from both sides
  EXPECT_GT(flat, 0u);
  std::size_t sides = 0; // of all edges
  for (const auto& [edge, both] : faces_of_edges(soup))
    sides += both.size();
  EXPECT_EQ(convex + concave + flat, sides);
}

TEST(Describe_segments_test, weighs_the_angles_of_one_joint_by_length)
{
  // Two labels that meet along 3 units of a crease of 90 degrees, and along 1 unit in the flat.
  Soup soup;
  soup.points = {{0, 0, 0}, {3, 0, 0}, {4, 0, 0},  {0, 1, 0},
                 {3, 1, 0}, {4, 1, 0}, {0, 0, -1}, {3, 0, -1}};
  soup.polygons = {{0, 1, 4, 3}, {1, 2, 5, 4}, {1, 0, 6, 7}};
  const auto d = descriptions_of(soup, {0, 1, 1});
  ASSERT_EQ(d.size(), 2u);
  ASSERT_EQ(d[0].neighbors.size(), 1u);
  EXPECT_DOUBLE_EQ(d[0].neighbors[0].border_length, 4);
  EXPECT_NEAR(d[0].neighbors[0].mean_signed_deviation, 3. / 4 * pi / 2, 1e-12);
  EXPECT_DOUBLE_EQ(d[0].boundary_length, 3 + 1);
}

TEST(Describe_segments_test, three_segments_that_meet_share_the_volume)
{
  for (const Description& d : descriptions_of(mapped(cube(), moved), {0, 1, 2, 3, 4, 5})) {
    EXPECT_NEAR(d.volume, 1. / 6, 1e-12);
    EXPECT_NEAR(d.volume_share, 1. / 6, 1e-12);
  }
}

TEST(Describe_segments_test, volumes_are_those_of_closed_segments)
{
  using Piece = RS::Segment_piece<Surface_mesh, Surface_mesh, std::size_t>;
  const auto families = {Family::SPHERE, Family::SHEET, Family::TORUS, Family::BLOCKS};
  for_each_random_mesh(families, 4, [&](const Soup& given, unsigned seed) {
    const Soup soup = triangulated(mapped(given, moved));
    const Labels labels = random_labels(soup, 5, seed);
    const std::vector<Description> found = descriptions_of(soup, labels);
    const double whole = description_of(soup).volume;
    const Surface_mesh mesh = to_surface_mesh(soup);
    std::vector<Piece> solids;
    RS::close_segments(mesh, face_labels(mesh, labels), std::back_inserter(solids));
    ASSERT_EQ(solids.size(), found.size());
    for (std::size_t i = 0; i < solids.size(); ++i) {
      EXPECT_EQ(solids[i].segment, found[i].segment);
      EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(solids[i].mesh), found[i].volume,
                  1e-6 * std::pow(found[i].area, 1.5));
      if (CGAL::is_closed(mesh)) {
        EXPECT_NEAR(found[i].volume_share, found[i].volume / whole, 1e-9);
      }
    }
  });
}

TEST(Describe_segments_test, a_flat_mesh_has_no_shares_of_its_volume)
{
  // Its volume is that of rounding.
  const Soup sheet = mapped(grid(3, 3), moved);
  for (const Description& d : descriptions_of(sheet, {0, 1, 2, 0, 1, 2, 0, 1, 2}))
    EXPECT_EQ(d.volume_share, 0);
}

TEST(Describe_segments_test, counts_the_areas_of_needles)
{
  // Degenerate, and of area 1/2 each: a fan of needles of 1e12 : 1.
  Soup needles;
  needles.points = {{0, 0, 0}, {1e6, 0, 0}, {1e6, 1e-6, 0}, {1e6, 2e-6, 0}};
  needles.polygons = {{0, 1, 2}, {0, 2, 3}};
  const Description d = description_of(needles);
  EXPECT_NEAR(d.area, 1, 1e-9);
  EXPECT_NEAR(d.centroid[0], 2e6 / 3, 1e-3);
}

TEST(Describe_segments_test, outputs_points_of_the_kernel_of_the_mesh)
{
  using Float_kernel = CGAL::Simple_cartesian<float>;
  const auto mesh = to_mesh<CGAL::Surface_mesh<Float_kernel::Point_3>>(cube());
  std::vector<RS::Segment_description<std::size_t, Float_kernel>> descriptions;
  RS::describe_segments(mesh, face_labels(mesh, Labels(6, 0)), std::back_inserter(descriptions));
  const Float_kernel::Point_3 centroid = descriptions.at(0).centroid;
  const Float_kernel::Vector_3 axis = descriptions.at(0).axes[0];
  EXPECT_EQ(centroid, Float_kernel::Point_3(.5f, .5f, .5f));
  EXPECT_NEAR(axis.squared_length(), 1, 1e-6);
}

/// Points that are not of a kernel.
TEST(Describe_segments_test, outputs_points_of_doubles_otherwise)
{
  const Surface_mesh mesh = to_surface_mesh(cube());
  using Array = std::array<double, 3>;
  std::map<Surface_mesh::Vertex_index, Array> points;
  for (auto v : vertices(mesh))
    points[v] = {mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]};
  const boost::associative_property_map<std::map<Surface_mesh::Vertex_index, Array>> arrays(points);
  std::vector<RS::Segment_description<std::size_t, CGAL::Simple_cartesian<double>>> descriptions;
  RS::describe_segments(mesh, face_labels(mesh, Labels(6, 0)), std::back_inserter(descriptions),
                        RS::parameters::vertex_point_map(arrays));
  EXPECT_EQ(descriptions.at(0).centroid, (CGAL::Simple_cartesian<double>::Point_3(.5, .5, .5)));
}

TEST(Describe_segments_test, agrees_with_cgal_on_random_meshes)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const auto families = {Family::SPHERE, Family::SHEET, Family::TORUS};
  for_each_random_mesh(families, 3, [&](const Soup& given, unsigned seed) {
    const Soup soup = triangulated(given);
    const Labels labels = random_labels(soup, 4, seed);
    const Surface_mesh mesh = to_surface_mesh(soup);
    for (const Description& d : descriptions_of(soup, labels)) {
      std::vector<Surface_mesh::Face_index> of_segment;
      double border = 0, boundary = 0;
      for (auto f : mesh.faces())
        if (labels[f] == d.segment) {
          of_segment.push_back(f);
          for (auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
            if (mesh.is_border(mesh.opposite(h)))
              boundary += PMP::edge_length(h, mesh);
            else if (labels[mesh.face(mesh.opposite(h))] != d.segment)
              border += PMP::edge_length(h, mesh);
        }
      EXPECT_EQ(d.number_of_faces, of_segment.size());
      EXPECT_NEAR(d.area, PMP::area(of_segment, mesh), 1e-9 * d.area);
      EXPECT_NEAR(d.border_length, border, 1e-9 * border);
      EXPECT_NEAR(d.boundary_length, boundary, 1e-9 * boundary);
    }
    if (CGAL::is_closed(mesh)) {
      EXPECT_NEAR(description_of(soup).volume, PMP::volume(mesh), 1e-9);
    }
  });
}

TEST(Describe_segments_test, finds_a_plane)
{
  const Description d = description_of(mapped(grid(7, 4), moved));
  EXPECT_EQ(d.surface.kind, RS::Surface_kind::PLANE);
  EXPECT_NEAR(d.surface_error(), 0, 1e-9);
  expect_near(d.surface.direction, moved_direction({0, 0, 1}), 1e-9);
  EXPECT_NEAR(d.extents[0], 7, 1e-9);
  EXPECT_NEAR(d.extents[2], 0, 1e-9);
}

TEST(Describe_segments_test, the_normal_of_a_plane_points_to_the_side_of_most_faces)
{
  // Corrugated, so that no face has the normal of the plane.
  const Soup sheet = mapped(grid(9, 4), [](const Point& p) {
    return moved({p[0], p[1], int(p[0]) % 2 == 0 ? 0. : 0.1});
  });
  ASSERT_EQ(description_of(sheet).surface.kind, RS::Surface_kind::PLANE);
  EXPECT_GT(description_of(sheet).surface.direction * moved_direction({0, 0, 1}), 0.99);
  EXPECT_LT(description_of(reversed(sheet)).surface.direction * moved_direction({0, 0, 1}), -0.99);
}

TEST(Describe_segments_test, finds_nothing_but_a_plane_where_all_points_are_on_it)
{
  for (const Soup& sheet : {grid(7, 4), mapped(grid(7, 4), moved)}) {
    const Description d = description_of(sheet);
    EXPECT_NEAR(d.surface_error(), 0, 1e-12);
    for (RS::Surface_kind type :
         {RS::Surface_kind::SPHERE, RS::Surface_kind::CYLINDER, RS::Surface_kind::CONE})
      EXPECT_EQ(d.surface_errors[std::size_t(type)], std::numeric_limits<double>::infinity());
  }
}

/// Of the signed distance, by central differences, where the surface has a tangent plane.
TEST(Surface_distance_test, has_the_derivatives_of_its_profile)
{
  constexpr double step = 1e-6;
  std::mt19937 random(17);
  std::uniform_real_distribution<double> coordinate(0.1, 2);
  for (const RS::Surface_kind kind :
       {RS::Surface_kind::PLANE, RS::Surface_kind::CYLINDER, RS::Surface_kind::CONE,
        RS::Surface_kind::SPHERE, RS::Surface_kind::TORUS}) {
    RS::Fitted_surface<> surface;
    surface.kind = kind;
    surface.radius = 0.7;
    surface.minor_radius = 0.2;
    surface.angle = 0.4;
    const auto distance = [](const RS::Fitted_surface<>& s, double r, double z) {
      return RS::internal::Surface_distance(s)({s.point.x + r, s.point.y, s.point.z + z});
    };
    for (int i = 0; i < 100; ++i) {
      const double r = coordinate(random), z = coordinate(random) - 1;
      const RS::internal::Profile profile = RS::internal::Surface_distance(surface).profile(r, z);
      const auto changed = [&](double radius, double second) {
        RS::Fitted_surface<> s = surface;
        s.radius += radius;
        (kind == RS::Surface_kind::CONE ? s.angle : s.minor_radius) += second;
        return distance(s, r, z);
      };
      EXPECT_DOUBLE_EQ(profile.value, distance(surface, r, z));
      EXPECT_NEAR(profile.by_r,
                  (distance(surface, r + step, z) - distance(surface, r - step, z)) / (2 * step),
                  1e-6);
      EXPECT_NEAR(profile.by_z,
                  (distance(surface, r, z + step) - distance(surface, r, z - step)) / (2 * step),
                  1e-6);
      EXPECT_NEAR(profile.by_radius, (changed(step, 0) - changed(-step, 0)) / (2 * step), 1e-6);
      EXPECT_NEAR(profile.by_second, (changed(0, step) - changed(0, -step)) / (2 * step), 1e-6);
    }
  }
}

/// Points of weight 0 do not count, and one of weight 2 is two points.
TEST(Surface_fitter_test, weights_points)
{
  const std::vector<RS::Double_3> points = {{1, 0, 0},   {0, 1.1, 0}, {-1, 0, 0},  {0, -0.9, 0},
                                            {0, 0, 1.2}, {0, 0, -1},  {0.9, 0, 0}, {5, 5, 5}};
  std::vector<RS::Double_3> repeated(points.begin(), points.end() - 1);
  repeated.push_back(points[4]);
  RS::Fitted_surface<> weighted, expected;
  weighted.kind = expected.kind = RS::Surface_kind::SPHERE;
  weighted.radius = expected.radius = 1;
  const double misfit = RS::internal::Surface_fitter(points, 0, {1, 1, 1, 1, 2, 1, 1, 0})(weighted,
                                                                                          50);
  EXPECT_NEAR(misfit, RS::internal::Surface_fitter(repeated, 0)(expected, 50), 1e-9);
  EXPECT_NEAR(weighted.radius, expected.radius, 1e-6);
  EXPECT_NEAR(norm(weighted.point - expected.point), 0, 1e-6);
}

TEST(Describe_segments_test, finds_a_sphere_and_a_part_of_it)
{
  Soup whole = mapped(sphere(3), [](const Point& p) {
    return moved({2 * p[0], 2 * p[1], 2 * p[2]});
  });
  Labels labels(whole.polygons.size());
  for (std::size_t f = 0; f < labels.size(); ++f)
    labels[f] = sphere(3).points[whole.polygons[f][0]][2] > 0.6;
  auto all = descriptions_of(whole, labels);
  all.push_back(description_of(whole));
  for (const Description& d : all) {
    EXPECT_EQ(d.surface.kind, RS::Surface_kind::SPHERE);
    EXPECT_NEAR(d.surface.radius, 2, 1e-6);
    EXPECT_NEAR(d.surface_error(), 0, 1e-6);
    expect_near(d.surface.point, moved_point({0, 0, 0}), 1e-6);
  }
}

TEST(Describe_segments_test, finds_a_cylinder)
{
  for (double part : {1., 0.3}) { // all around, and a third
    const Description d = description_of(tube(
      5, 24,
      [](double u, double v) {
        return moved({2 * std::cos(2 * pi * v), 2 * std::sin(2 * pi * v), 6 * u});
      },
      part));
    EXPECT_EQ(d.surface.kind, RS::Surface_kind::CYLINDER);
    EXPECT_NEAR(d.surface.radius, 2, 1e-6);
    EXPECT_NEAR(std::abs(d.surface.direction * moved_direction({0, 0, 1})), 1, 1e-6);
    EXPECT_NEAR(d.surface_error(), 0, 1e-6);
    EXPECT_NEAR(d.surface.deviation, 0, 1e-6);
    EXPECT_NEAR(d.surface.highest, 3, 1e-6);
    EXPECT_NEAR(d.surface.lowest, -3, 1e-6);
    const Vector_3 away = d.surface.point - moved_point({0, 0, 0});
    EXPECT_NEAR(CGAL::cross_product(away, d.surface.direction).squared_length(), 0, 1e-10);
    EXPECT_NEAR((d.surface.point - d.centroid) * d.surface.direction, 0, 1e-6);
  }
}

TEST(Describe_segments_test, finds_a_cone)
{
  for (double part : {1., 0.3})
    for (bool is_hole : {false, true}) {
      Soup soup = tube(
        5, 24,
        [](double u, double v) {
          const double r = 1 + 2 * u;
          return moved({r * std::cos(2 * pi * v), r * std::sin(2 * pi * v), 4 * r});
        },
        part);
      const Description d = description_of(is_hole ? reversed(soup) : soup);
      EXPECT_EQ(d.surface.kind, RS::Surface_kind::CONE);
      EXPECT_NEAR(d.surface.angle, std::atan(0.25), 1e-6);
      EXPECT_EQ(d.surface.side, is_hole ? -1 : 1);
      EXPECT_NEAR((d.surface.point - d.centroid) * d.surface.direction, 0, 1e-6);
      EXPECT_NEAR(d.surface_error(), 0, 1e-6);
      expect_near(d.surface.apex(), moved_point({0, 0, 0}), 1e-4);
      expect_near(d.surface.direction, moved_direction({0, 0, 1}), 1e-6);
    }
}

TEST(Describe_segments_test, tells_two_circles_of_corners_from_a_sphere)
{
  // As machine parts are meshed: the corners alone also lie on a sphere.
  for (double taper : {0., 0.5}) {
    const Description d = description_of(triangulated(tube(1, 16, [&](double u, double v) {
      const double r = 1 - taper * u;
      return moved({r * std::cos(2 * pi * v), r * std::sin(2 * pi * v), 1.5 * u});
    })));
    EXPECT_NEAR(d.surface_errors[std::size_t(RS::Surface_kind::SPHERE)], 0, 1e-6);
    EXPECT_EQ(d.surface.kind, taper == 0 ? RS::Surface_kind::CYLINDER : RS::Surface_kind::CONE);
    EXPECT_NEAR(d.surface_error(), 0, 1e-6);
  }
}

TEST(Describe_segments_test, finds_the_primitive_under_noise)
{
  std::mt19937 random(1);
  Soup soup = tube(20, 40, [](double u, double v) {
    return Point{std::cos(2 * pi * v), std::sin(2 * pi * v), 4 * u};
  });
  bump(soup, 0.02, random);
  const Description d = description_of(soup);
  EXPECT_EQ(d.surface.kind, RS::Surface_kind::CYLINDER);
  EXPECT_NEAR(d.surface.radius, 1, 0.01);
  EXPECT_LT(d.surface_error(), 0.02);
  EXPECT_GT(d.surface_error(), 0.005);
  EXPECT_GT(d.surface_errors[std::size_t(RS::Surface_kind::PLANE)], 0.5);
}

TEST(Describe_segments_test, scales_with_the_mesh)
{
  const Soup soup = random_mesh(Family::SPHERE, 4);
  const Labels labels = random_labels(soup, 3, 4);
  const double factor = std::ldexp(1.0, 80); // beyond which the flat mesh has a unit of its own
  const auto small = descriptions_of(soup, labels),
             large = descriptions_of(scaled(soup, factor), labels);
  ASSERT_EQ(small.size(), large.size());
  for (std::size_t i = 0; i < small.size(); ++i) {
    EXPECT_EQ(small[i].area * factor * factor, large[i].area);
    EXPECT_EQ(small[i].volume * factor * factor * factor, large[i].volume);
    EXPECT_EQ(small[i].border_length * factor, large[i].border_length);
    EXPECT_NEAR(small[i].surface_error() * factor, large[i].surface_error(),
                1e-6 * large[i].surface_error());
    for (RS::Surface_kind type : {RS::Surface_kind::PLANE, RS::Surface_kind::SPHERE}) {
      const double error = large[i].surface_errors[std::size_t(type)];
      ASSERT_TRUE(std::isfinite(error));
      EXPECT_NEAR(small[i].surface_errors[std::size_t(type)] * factor, error, 1e-6 * error);
    }
  }
}

TEST(Describe_segments_test, an_area_of_zero_stays_zero_where_others_are_infinite)
{
  const Soup point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}};
  const std::vector<Description> found = descriptions_of(scaled(joined(cube(), point), 1e300),
                                                         {0, 0, 0, 0, 0, 0, 1});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].area, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found[0].volume, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found[1].area, 0);
  EXPECT_EQ(found[1].volume, 0);
}

TEST(Describe_segments_test, bears_surfaces_without_extent)
{
  EXPECT_TRUE(descriptions_of(Soup(), {}).empty());
  Soup point;
  point.points = {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}};
  point.polygons = {{0, 1, 2}};
  const Description d = description_of(point);
  EXPECT_EQ(d.area, 0);
  EXPECT_EQ(d.surface_error(), 0);
  expect_near(d.centroid, Point_3(1, 2, 3), 0);
  Soup infinite = grid(1, 1);
  infinite.points[2][1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(description_of(infinite), RS::Invalid_input);
}

} // namespace describe_segments_test
