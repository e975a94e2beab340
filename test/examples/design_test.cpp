// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round numbers and the table of holes of parts whose numbers are known: of formulas, and drilled
// by OpenCASCADE.

#include "bodies.h"
#include "step_part.h"

#include "../shapes_with_faces.h"
#include "mesh_of.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Json = nlohmann::json;
using Polygons = std::vector<std::vector<std::size_t>>;
using mesh_to_step::Design_intent;
using mesh_to_step::Facets;
using mesh_to_step::Mesh;
using mesh_to_step::Point;
using shapes_with_faces::pi;

namespace {

Json report_of(const Mesh& mesh, Design_intent intent = Design_intent::SET)
{
  return Json::parse(mesh_to_step::make_step_part(mesh, Facets::REFUSED, intent).report);
}

Mesh bar_with_noise(double radius, double deviation)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, deviation);
  const auto bar = shapes_with_faces::filleted_bar(3, radius, 10, 12, 6);
  std::vector<Point> points;
  for (const auto& p : bar.points)
    points.emplace_back(p.x + noise(random), p.y + noise(random), p.z + noise(random));
  Polygons triangles;
  for (const auto& triangle : bar.triangles)
    triangles.emplace_back(triangle.begin(), triangle.end());
  return mesh_to_step::make_bodies(points, triangles);
}

/// The round numbers that some faces were given.
std::vector<Json> round_numbers(const Json& report, const std::string& name)
{
  std::vector<Json> result;
  for (const Json& relation : report["relations"])
    if (relation["relation"] == name && relation.contains("to"))
      result.push_back(relation);
  return result;
}

TEST(Design, numbers_become_round_in_spite_of_noise)
{
  const Mesh mesh = bar_with_noise(1, 1e-4);
  const Json report = report_of(mesh);
  EXPECT_TRUE(report["is_right"]);
  const auto radii = round_numbers(report, "radius");
  ASSERT_EQ(radii.size(), 4u);
  for (const Json& radius : radii) {
    EXPECT_EQ(radius["to"], 1);
    EXPECT_NE(radius["from"], 1);
  }
  for (const Json& face : report["faces"])
    EXPECT_NEAR(face.value("radius", 1.0), 1, 1e-9);
  EXPECT_FALSE(round_numbers(report, "distance").empty());
  EXPECT_TRUE(report_of(mesh, Design_intent::AS_FOUND)["relations"].empty());
}

TEST(Design, numbers_that_are_not_round_or_not_known_well_stay)
{
  EXPECT_TRUE(round_numbers(report_of(bar_with_noise(1.004, 1e-6)), "radius").empty());
  EXPECT_TRUE(round_numbers(report_of(bar_with_noise(1, 2e-3)), "radius").empty());
}

/// A plate from z = 0 to 30 in which holes are drilled from above.
class Plate
{
public:
  const TopoDS_Shape& shape() const { return m_shape; }

  void drill(double x, double y, double diameter, double depth)
  {
    cut(BRepPrimAPI_MakeCylinder(axis(x, y, 30 - depth), diameter / 2, depth + 1).Shape());
  }

  void drill_cone(double x, double y, double z, double lower, double upper, double height)
  {
    cut(BRepPrimAPI_MakeCone(axis(x, y, z), lower / 2, upper / 2, height).Shape());
  }

private:
  static gp_Ax2 axis(double x, double y, double z) { return {{x, y, z}, {0, 0, 1}}; }

  void cut(const TopoDS_Shape& tool) { m_shape = BRepAlgoAPI_Cut(m_shape, tool).Shape(); }

  TopoDS_Shape m_shape = BRepPrimAPI_MakeBox(200, 120, 30).Shape();
};

const Json& hole_of_diameter(const Json& report, double diameter)
{
  const Json& holes = report["holes"];
  return *std::find_if(holes.begin(), holes.end(), [&](const Json& hole) {
    return std::fabs(double(hole["diameter"]) - diameter) < 1e-4;
  });
}

TEST(Design, holes_are_as_they_were_drilled)
{
  constexpr double through = 31;
  const double tip = 3.4 / std::tan(59 * pi / 180); // of a drill of 118 degrees
  Plate plate;
  plate.drill(180, 30, 5, through);
  plate.drill(180, 30, 12, 8);
  plate.drill(180, 60, 6, through);
  plate.drill_cone(180, 60, 27, 6, 12, 3);
  plate.drill(180, 90, 6.8, 15);
  plate.drill_cone(180, 90, 15 - tip, 0, 6.8, tip);
  plate.drill_cone(100, 60, 25, 0, 10, 5); // a cone alone
  const Json report = report_of(mesh_of(plate.shape()));
  EXPECT_TRUE(report["is_right"]);
  ASSERT_EQ(report["holes"].size(), 4u);
  const Json bored = hole_of_diameter(report, 5), sunk = hole_of_diameter(report, 6),
             blind = hole_of_diameter(report, 6.8), cone = hole_of_diameter(report, 0);
  EXPECT_FALSE(bored["is_blind"]);
  EXPECT_NEAR(bored["depth"], 30, 1e-6);
  EXPECT_NEAR(bored["counterbores"].at(0)["diameter"], 12, 1e-6);
  EXPECT_NEAR(bored["counterbores"].at(0)["depth"], 8, 1e-6);
  EXPECT_FALSE(sunk["is_blind"]);
  EXPECT_NEAR(sunk["countersinks"].at(0)["diameter"], 12, 1e-5);
  EXPECT_NEAR(sunk["countersinks"].at(0)["angle"], 90, 1e-6);
  EXPECT_TRUE(blind["is_blind"]);
  EXPECT_NEAR(blind["depth"], 15, 1e-6);
  EXPECT_NEAR(blind["tip_angle"], 118, 1e-6);
  EXPECT_TRUE(cone["is_blind"]);
  EXPECT_NEAR(cone["countersinks"].at(0)["diameter"], 10, 1e-5);
}

TEST(Design, holes_are_in_a_circle_or_grid)
{
  Plate plate;
  for (int i = 0; i < 6; ++i)
    plate.drill(50 + 35 * std::cos(i * pi / 3), 60 + 35 * std::sin(i * pi / 3), 8, 12);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      plate.drill(110 + 20 * i, 30 + 25 * j, 5, 12);
  for (const double x : {110, 120, 150})
    plate.drill(x, 100, 3, 12);
  for (const double x : {110, 120, 130}) // of unequal depths
    plate.drill(x, 90, 2, x / 10);
  const Json patterns = report_of(mesh_of(plate.shape()))["patterns"];
  ASSERT_EQ(patterns.size(), 2u);
  EXPECT_EQ(patterns[0]["holes"].size(), 6u);
  EXPECT_NEAR(patterns[0]["diameter"], 70, 1e-6);
  EXPECT_NEAR(patterns[0]["center"][0], 50, 1e-5);
  EXPECT_NEAR(patterns[0]["center"][1], 60, 1e-5);
  EXPECT_EQ(patterns[1]["numbers"], Json({3, 2}));
  EXPECT_NEAR(patterns[1]["pitches"][0], 20, 1e-5);
  EXPECT_NEAR(patterns[1]["pitches"][1], 25, 1e-5);
}

TEST(Bodies, a_polygon_that_meets_itself_is_refused)
{
  const std::vector<Point> bow{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}};
  EXPECT_THROW(mesh_to_step::make_bodies(bow, {{0, 1, 2, 0, 3, 4}}), std::invalid_argument);
}

} // namespace
