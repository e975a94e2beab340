// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write_segmentation.h"

#include "Temporary_folder.h"
#include "demo/articulated_figure.h"
#include "view/segment_colors.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <gtest/gtest.h>

#include <set>
#include <sstream>

using namespace segment_mesh;

namespace {

class Written : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    s_input = make_input_mesh("figure", make_articulated_figure().soup);
    s_settings.number_of_segments = 10;
    s_settings.method = Method::TWO_STEP;
    s_segmentation = run_segmentation(s_input.mesh_soup(), s_settings, {});
    s_labels = labels_of_faces(s_input, s_segmentation);
  }

  std::string write(const std::string& name) const
  {
    write_segmentation(m_folder.path(name), {s_name, s_input, s_settings, s_segmentation});
    EXPECT_EQ(m_folder.names(), std::vector<std::string>{name}); // nothing temporary is left
    return m_folder.path(name);
  }

  std::string text(const std::string& name) const
  {
    write(name);
    return m_folder.read(name);
  }

  static inline const std::string s_name = "a \"name\"";
  static inline Input_mesh s_input;
  static inline Segmentation_settings s_settings;
  static inline Segmentation s_segmentation;
  static inline std::vector<std::size_t> s_labels;
  Temporary_folder m_folder;
};

TEST_F(Written, seg_has_a_label_a_line)
{
  std::istringstream in(text("a.seg"));
  std::vector<std::size_t> labels;
  for (std::string line; std::getline(in, line);)
    labels.push_back(std::stoul(line));
  EXPECT_EQ(labels, s_labels);
}

TEST_F(Written, meshes_are_read_back_to_the_bit)
{
  for (const char* name : {"a.ply", "a.off", "a.obj"}) {
    const Input_mesh back = read_mesh(write(name));
    EXPECT_EQ(back.soup.points, s_input.soup.points) << name;
    EXPECT_EQ(back.soup.polygons, s_input.soup.polygons) << name;
    std::filesystem::remove(m_folder.path(name));
  }
}

TEST_F(Written, ply_has_segments_and_colors)
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  std::ifstream in(write("a.PLY"), std::ios::binary);
  std::string comments;
  ASSERT_TRUE(CGAL::IO::read_PLY(in, mesh, comments));
  using Face = CGAL::SM_Face_index;
  const auto segment = mesh.add_property_map<Face, std::int32_t>("f:segment").first;
  const auto color = mesh.add_property_map<Face, CGAL::IO::Color>("f:color").first;
  ASSERT_EQ(mesh.number_of_faces(), s_labels.size());
  for (const Face f : mesh.faces()) {
    ASSERT_EQ(std::size_t(segment[f]), s_labels[f]);
    const Color expected = segment_color(s_labels[f]);
    ASSERT_EQ(color[f], CGAL::IO::Color(expected[0], expected[1], expected[2]));
  }
}

TEST_F(Written, off_has_colors)
{
  std::istringstream in(text("a.off"));
  std::string line;
  for (std::size_t i = 0; i < 2 + s_input.soup.points.size(); ++i)
    std::getline(in, line);
  for (std::size_t f = 0; f < s_labels.size(); ++f) {
    std::size_t size, a, b, c;
    int red, green, blue;
    ASSERT_TRUE(in >> size >> a >> b >> c >> red >> green >> blue);
    const Color expected = segment_color(s_labels[f]);
    ASSERT_EQ((std::array<int, 3>{red, green, blue}),
              (std::array<int, 3>{expected[0], expected[1], expected[2]}));
  }
}

TEST_F(Written, obj_has_groups_and_lines)
{
  std::istringstream in(text("a.obj"));
  std::vector<std::size_t> labels;
  std::size_t label = 0, number_of_lines = 0;
  const std::string group = "g segment_";
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(group, 0) == 0)
      label = std::stoul(line.substr(group.size()));
    else if (line[0] == 'f')
      labels.push_back(label);
    else if (line[0] == 'l')
      ++number_of_lines;
    else
      ASSERT_TRUE(line[0] == 'v' || line == "g feature_lines") << line;
  }
  EXPECT_EQ(labels, s_labels);
  EXPECT_EQ(number_of_lines, s_segmentation.feature_lines.size());
  EXPECT_GT(number_of_lines, 0u);
}

std::size_t count(const std::string& text, const std::string& what)
{
  std::size_t result = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++result;
  return result;
}

TEST_F(Written, json_has_all)
{
  const std::string json = text("a.json");
  EXPECT_EQ(json.rfind("{\n  \"format\": \"segment_mesh\",\n  \"version\": 2,", 0), 0u);
  EXPECT_NE(json.find("\"name\": \"a \\\"name\\\"\""), std::string::npos);
  EXPECT_NE(json.find("\"segments\": 10, \"mesh\": \"surface_mesh\", \"features\": \"concave\", "
                      "\"max_angle\": 1.237"),
            std::string::npos);
  EXPECT_EQ(count(json, "\"perimeter\""), s_segmentation.regions.size());
  EXPECT_EQ(count(json, "\"mean_angle\""), s_segmentation.sections.size());
  EXPECT_EQ(count(json, "\"stage\":"), s_segmentation.stages.size());
  EXPECT_EQ(count(json, "{"), count(json, "}"));
  EXPECT_EQ(count(json, "["), count(json, "]"));
}

TEST_F(Written, details_agree_with_labels)
{
  const Segmentation& s = s_segmentation;
  EXPECT_EQ(s.regions.size(), s.number_of_regions);
  std::vector<std::size_t> faces(s.number_of_regions);
  for (std::size_t f = 0; f < s.region_of_face.size(); ++f) {
    ++faces[s.region_of_face[f]];
    ASSERT_EQ(s.regions[s.region_of_face[f]].segment, s.segment_of_face[f]);
  }
  std::vector<double> perimeters(s.number_of_regions);
  for (const Section& section : s.sections)
    for (std::size_t region : section.regions)
      perimeters[region] += section.length;
  for (std::size_t r = 0; r < s.number_of_regions; ++r) {
    EXPECT_EQ(s.regions[r].number_of_faces, faces[r]);
    EXPECT_NEAR(s.regions[r].perimeter, perimeters[r], 1e-12 * (1 + perimeters[r]));
  }
}

TEST_F(Written, all_mesh_types_give_the_same)
{
  for (const Mesh_type type : {Mesh_type::POLYHEDRON, Mesh_type::OPENMESH}) {
    if (!is_available(type))
      continue;
    Segmentation_settings settings = s_settings;
    settings.mesh_type = type;
    const Segmentation other = run_segmentation(s_input.mesh_soup(), settings, {});
    EXPECT_EQ(other.segment_of_face, s_segmentation.segment_of_face);
    EXPECT_EQ(other.region_of_face, s_segmentation.region_of_face);
    EXPECT_EQ(other.feature_lines.size(), s_segmentation.feature_lines.size());
    ASSERT_EQ(other.sections.size(), s_segmentation.sections.size());
    for (std::size_t i = 0; i < other.sections.size(); ++i) {
      EXPECT_EQ(other.sections[i].length, s_segmentation.sections[i].length);
      EXPECT_EQ(other.sections[i].mean_angle, s_segmentation.sections[i].mean_angle);
    }
  }
}

TEST(Segment_colors, differ)
{
  std::set<Color> colors;
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_TRUE(colors.insert(segment_color(i)).second) << i;
}

} // namespace
