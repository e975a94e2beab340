// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the outputs tell of the faces of machine parts.

#include "../shapes_with_faces.h"
#include "Program.h"
#include "write/write_segmentation.h"
#include "page/write_page.h"
#include "segmentation/Segmentation_details.h"
#include "view/render_view.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace machine_part_test {

using namespace segment_mesh;

Polygon_soup soup_of(const shapes_with_faces::Shape& shape)
{
  Polygon_soup soup;
  for (const auto& p : shape.points)
    soup.points.push_back({p.x, p.y, p.z});
  for (const auto& t : shape.triangles)
    soup.polygons.push_back({t[0], t[1], t[2]});
  return soup;
}

/// A shape, segmented, and what is written of it.
class Part
{
public:
  explicit Part(const shapes_with_faces::Shape& shape, Method method = Method::SMOOTH_FACES,
                std::optional<std::size_t> number_of_segments = {})
  {
    m_input.soup = soup_of(shape);
    m_settings.method = method;
    m_settings.number_of_segments = number_of_segments;
    m_segmentation = run_segmentation(m_input.soup, m_marks, m_settings, {});
  }

  const Segmentation& segmentation() const { return m_segmentation; }
  const Segmentation_details& details() const { return m_details; }

  nlohmann::json segments() const
  {
    std::ostringstream out;
    write_json(out, result());
    return nlohmann::json::parse(out.str())["segments"];
  }

  /// By line and column.
  std::vector<std::vector<std::string>> table() const
  {
    std::stringstream text;
    write_csv(text, result());
    std::vector<std::vector<std::string>> lines;
    for (std::string line; std::getline(text, line);) {
      lines.emplace_back();
      std::istringstream in(line + ",");
      for (std::string field; std::getline(in, field, ',');)
        lines.back().push_back(field);
    }
    return lines;
  }

  Image picture(Coloring coloring) const
  {
    View_options options;
    options.width = options.height = 100;
    options.colors = m_details.colors(coloring, m_segmentation.segment_of_face,
                                      m_segmentation.number_of_segments);
    return render_view(m_input.soup, m_segmentation.segment_of_face, {}, options);
  }

  std::string page(Coloring coloring) const
  {
    std::ostringstream out;
    write_page(out, {m_name, m_input.soup, m_segmentation, m_details, coloring});
    return out.str();
  }

private:
  Result result() const
  {
    return {m_name, m_input, m_marks, m_settings, m_side_files, m_segmentation, m_details, m_view};
  }

  std::string m_name = "a";
  Input_mesh m_input;
  Marks m_marks;
  Side_files m_side_files;
  Segmentation_settings m_settings;
  Segmentation m_segmentation;
  Segmentation_details m_details{m_input.soup, m_settings, m_segmentation};
  View_options m_view;
};

/// A cylinder with a groove, a conical end, and a blind hole in it: segments are as listed.
shapes_with_faces::Shape shaft()
{
  return shapes_with_faces::revolved({{0, 0},     // to
                                      {2, 0},     // 0: a disc
                                      {2, 1},     // 1: a cylinder
                                      {1.5, 1},   // 2: a plane
                                      {1.5, 2},   // 3: the floor of the groove
                                      {2, 2},     // 4: a plane
                                      {2, 3},     // 5: the same cylinder as 1
                                      {1, 4},     // 6: a cone
                                      {0.5, 4},   // 7: a ring
                                      {0.5, 2.5}, // 8: a hole
                                      {0, 2.5}},  // 9: its bottom
                                     32);
}

/// What all segments have at a place of their JSON.
std::string words(const nlohmann::json& segments, const std::string& place)
{
  std::string result;
  for (const auto& segment : segments)
    result += segment.at(nlohmann::json::json_pointer(place)).get<std::string>() + " ";
  return result;
}

TEST(MachinePart, json_has_faces)
{
  const nlohmann::json s = Part(shaft()).segments();
  ASSERT_EQ(s.size(), 10u);
  EXPECT_EQ(words(s, "/primitive/type"),
            "plane cylinder plane cylinder plane cylinder cone plane cylinder plane ");
  EXPECT_EQ(words(s, "/role"), "none none none none none none none none hole hole ");
  EXPECT_EQ(words(s, "/name"), "plane_0 cylinder_1 plane_2 cylinder_3 plane_4 cylinder_5 cone_6 "
                               "plane_7 hole_8_r0.5 hole_9 ");
  std::vector<std::size_t> surfaces, axes;
  for (const auto& segment : s) {
    surfaces.push_back(segment["same_surface"]);
    axes.push_back(segment["same_axis"]);
    EXPECT_LT(segment["primitive"]["error"], 1e-6);
    for (const auto& neighbor : segment["neighbors"])
      EXPECT_EQ(neighbor["border"], "sharp");
  }
  EXPECT_EQ(surfaces, (std::vector<std::size_t>{0, 1, 2, 3, 4, 1, 6, 7, 8, 9}));
  EXPECT_EQ(axes, (std::vector<std::size_t>{0, 1, 2, 1, 4, 1, 1, 7, 1, 9}));

  const nlohmann::json hole = s[8]["primitive"], cone = s[6]["primitive"];
  EXPECT_NEAR(hole["radius"], 0.5, 1e-9);
  EXPECT_EQ(hole["concave"], true);
  EXPECT_EQ(cone["concave"], false);
  EXPECT_NEAR(cone["half_angle"], 45, 1e-6);
  EXPECT_NEAR(cone["point"][2], 5, 1e-6); // the apex
  for (const auto& [p, lowest, highest] :
       {std::tuple(hole, 2.5, 4.0), std::tuple(cone, 3.0, 4.0)}) {
    const double z = p["point"][2], direction = p["direction"][2];
    const double a = z + direction * p["extent"][0].get<double>(),
                 b = z + direction * p["extent"][1].get<double>();
    EXPECT_NEAR((std::min)(a, b), lowest, 1e-6);
    EXPECT_NEAR((std::max)(a, b), highest, 1e-6);
  }
}

TEST(MachinePart, json_has_kinds_of_borders)
{
  const nlohmann::json s = Part(shapes_with_faces::filleted_bar(3, 1, 5, 4, 2)).segments();
  ASSERT_EQ(s.size(), 10u);
  std::size_t smooth = 0;
  for (const auto& segment : s)
    for (const auto& neighbor : segment["neighbors"])
      smooth += neighbor["border"] == "smooth";
  EXPECT_EQ(smooth, 16u);
  EXPECT_EQ(s[0]["role"], "none");
  EXPECT_EQ(s[1]["role"], "blend");
  EXPECT_EQ(s[1]["name"], "fillet_1");
}

TEST(MachinePart, csv_agrees_with_json)
{
  for (const auto& shape : {shaft(), shapes_with_faces::filleted_bar(3, 1, 5, 4, 2),
                            shapes_with_faces::torus(3, 1, 40, 16)}) {
    const Part part(shape);
    const nlohmann::json s = part.segments();
    const auto table = part.table();
    ASSERT_EQ(table.size(), s.size() + 1);
    for (std::size_t i = 0; i < s.size(); ++i) {
      ASSERT_EQ(table[i + 1].size(), table[0].size());
      const auto field = [&](const std::string& name) {
        const auto column = std::find(table[0].begin(), table[0].end(), name) - table[0].begin();
        return table[i + 1].at(std::size_t(column));
      };
      const nlohmann::json &segment = s[i], &surface = segment["primitive"];
      const auto expect_number = [&](const std::string& name, const nlohmann::json& value) {
        if (value.is_null())
          EXPECT_EQ(field(name), "") << name;
        else
          EXPECT_EQ(std::stod(field(name)), value.get<double>()) << name;
      };
      EXPECT_EQ(field("primitive"), surface["type"]);
      EXPECT_EQ(field("role"), segment["role"]);
      EXPECT_EQ(field("name"), segment["name"]);
      if (surface.contains("concave")) {
        EXPECT_EQ(field("concave"), surface["concave"] ? "1" : "0");
      }
      for (const char* name : {"radius", "minor_radius", "half_angle", "error"})
        expect_number(name, surface.value(name, nlohmann::json()));
      for (const char* name : {"same_surface", "same_axis"})
        expect_number(name, segment[name]);
      for (const auto& [x, j] : {std::pair("x", 0), std::pair("y", 1), std::pair("z", 2)}) {
        expect_number(std::string("point_") + x, surface["point"][j]);
        expect_number(std::string("direction_") + x, surface["direction"][j]);
      }
      expect_number("lowest", surface.contains("extent") ? surface["extent"][0] : nlohmann::json());
      expect_number("highest",
                    surface.contains("extent") ? surface["extent"][1] : nlohmann::json());
      std::size_t smooth = 0;
      for (const auto& neighbor : segment["neighbors"])
        smooth += neighbor["border"] == "smooth";
      std::istringstream in(field("smooth_neighbors"));
      EXPECT_EQ(smooth, std::size_t(std::distance(std::istream_iterator<std::size_t>(in), {})));
    }
  }
}

// A segment of several faces has no surface of one; other methods know no faces.
TEST(MachinePart, merged_faces_have_primitives)
{
  const Part merged(shapes_with_faces::filleted_bar(3, 1, 5, 4, 2), Method::SMOOTH_FACES, 3);
  std::size_t faces = 0;
  for (const auto& segment : merged.segments()) {
    faces += segment.contains("role");
    EXPECT_EQ(segment["name"].get<std::string>().rfind("segment_", 0) == 0,
              !segment.contains("role"));
    EXPECT_EQ(segment["primitive"].contains("extent"), false);
  }
  EXPECT_LT(faces, 3u);
  const nlohmann::json other = Part(shaft(), Method::VISIBILITY, 2).segments();
  EXPECT_FALSE(other[0].contains("role"));
  EXPECT_FALSE(other[0]["neighbors"][0].contains("border"));
}

TEST(MachinePart, colors_tell_kinds)
{
  const Part part(shaft());
  const auto& segmentation = part.segmentation();
  EXPECT_EQ(part.details().colors(Coloring::KINDS, segmentation.segment_of_face, 10),
            (std::vector<std::size_t>{0, 1, 0, 1, 0, 1, 2, 0, 1, 0}));
  EXPECT_EQ(part.details().colors(Coloring::SEGMENTS, segmentation.segment_of_face, 10)[7], 7u);
  const Part merged(shaft(), Method::SMOOTH_FACES, 1);
  EXPECT_EQ(merged.details().colors(Coloring::KINDS, merged.segmentation().segment_of_face, 1),
            std::vector<std::size_t>{color_of_no_kind});
  // one torus: the picture by segments is blue, that by kinds has the color of tori
  const Part torus(shapes_with_faces::torus(3, 1, 40, 16));
  const auto green_over_red = [&](Coloring coloring) {
    const Image image = torus.picture(coloring);
    long difference = 0;
    for (std::size_t y = 0; y < image.height; ++y)
      for (std::size_t x = 0; x < image.width; ++x)
        difference += long(image.at(x, y)[1]) - long(image.at(x, y)[0]);
    return difference;
  };
  const Color by_segment = segment_color(0), by_kind = segment_color(4);
  EXPECT_LT(by_segment[1] - by_segment[0], by_kind[1] - by_kind[0]);
  EXPECT_GT(green_over_red(Coloring::KINDS), 1.5 * double(green_over_red(Coloring::SEGMENTS)));
}

// A cylinder that widens half way, by less than a tolerance of 0.05.
TEST_F(Program, finds_faces_within_a_tolerance)
{
  const shapes_with_faces::Shape shape = shapes_with_faces::revolved(
    {{0, 0}, {2, 0}, {2, 1}, {2.02, 1.1}, {2.02, 2}, {0, 2}}, 32);
  std::ostringstream mesh;
  mesh << std::setprecision(17) << "OFF\n"
       << shape.points.size() << " " << shape.triangles.size() << " 0\n";
  for (const auto& p : shape.points)
    mesh << p.x << " " << p.y << " " << p.z << "\n";
  for (const auto& t : shape.triangles)
    mesh << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  folder.write("a.off", mesh.str());
  const auto segments = [&](const std::string& arguments) {
    const Outcome outcome = run("a.off --method smooth-faces -o a.json " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(folder.read("a.json"))["segments"];
  };
  for (const char* found : {"", "--tolerance 0", "--tolerance 1e-5"})
    EXPECT_EQ(words(segments(found), "/primitive/type"), "plane cylinder cone cylinder plane ")
      << found;
  const nlohmann::json s = segments("--tolerance 0.05");
  EXPECT_EQ(words(s, "/primitive/type"), "plane cylinder plane ");
  // A segment has a role where it is one of the faces that are found again for outputs.
  EXPECT_EQ(words(s, "/role"), "none none none ");
}

TEST(MachinePart, page_has_kinds)
{
  if (!can_write_pages())
    GTEST_SKIP() << "no three.js";
  const Part part(shaft());
  EXPECT_NE(part.page(Coloring::KINDS).find("\"coloring\":\"kinds\""), std::string::npos);
  EXPECT_NE(part.page(Coloring::SEGMENTS).find("\"coloring\":\"segments\""), std::string::npos);
  EXPECT_NE(part.page(Coloring::SEGMENTS).find("\"type\":\"cone\""), std::string::npos);
}

} // namespace machine_part_test
