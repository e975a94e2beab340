// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/write_mesh.h"
#include "write/write_segmentation.h"

#include "Temporary_folder.h"
#include "read/read_mesh.h"
#include "view/segment_colors.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>
#include <sstream>

namespace write_segmentation_test {

using namespace segment_mesh;

class Written : public testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    s_input = read_mesh(FIGURE);
    s_settings.number_of_segments = 10;
    s_settings.method = Method::TWO_STEP;
    s_segmentation = run_segmentation(s_input.soup, {}, s_settings, {});
    s_details = std::make_unique<Segmentation_details>(s_input.soup, s_settings, s_segmentation);
  }

  static Result result()
  {
    return {s_name,       s_input,        s_marks,    s_settings,
            s_side_files, s_segmentation, *s_details, s_no_viewpoint};
  }

  std::string write(const std::string& name) const
  {
    write_segmentation(make_output(m_folder.path(name)), result());
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
  static inline const Marks s_marks;
  static inline const Side_files s_side_files;
  static inline const View_options s_no_viewpoint;
  static inline std::unique_ptr<Segmentation_details> s_details;
  Temporary_folder m_folder;
};

TEST_F(Written, seg_has_a_label_a_line)
{
  std::istringstream in(text("a.seg"));
  std::vector<std::size_t> labels;
  for (std::string line; std::getline(in, line);)
    labels.push_back(std::stoul(line));
  EXPECT_EQ(labels, s_segmentation.segment_of_face);
}

TEST_F(Written, meshes_are_read_back_to_the_bit)
{
  for (const char* name : {"a.ply", "a.off"}) {
    const Input_mesh back = read_mesh(write(name));
    EXPECT_EQ(back.soup.points, s_input.soup.points) << name;
    EXPECT_EQ(back.soup.polygons, s_input.soup.polygons) << name;
    std::filesystem::remove(m_folder.path(name));
  }
}

/// Their faces are ordered by segment, within one as in the input.
TEST_F(Written, parts_are_read_back_to_the_bit)
{
  using Triangle = std::array<Point, 3>;
  const auto append = [](const Polygon_soup& soup, std::size_t f,
                         std::vector<Triangle>& triangles) {
    const Polygon_soup::Polygon face = soup.polygons[f];
    ASSERT_EQ(face.size(), 3u);
    triangles.push_back({soup.points[face[0]], soup.points[face[1]], soup.points[face[2]]});
  };
  std::vector<Triangle> expected;
  for (std::size_t s = 0; s < s_segmentation.number_of_segments; ++s)
    for (std::size_t f = 0; f < s_input.soup.polygons.size(); ++f)
      if (s_segmentation.segment_of_face[f] == s)
        append(s_input.soup, f, expected);
  for (const std::string name : {"a.obj", "a.stl", "{segment}.off"}) {
    const Output output = make_output(m_folder.path(name));
    write_segmentation(output, result());
    std::vector<Triangle> triangles;
    for (std::size_t s = 0; s < (output.is_for_each_segment() ? 10u : 1u); ++s) {
      const Polygon_soup part = read_mesh(with_segment(output.file, std::to_string(s))).soup;
      std::set<std::size_t> used;
      for (std::size_t f = 0; f < part.polygons.size(); ++f) {
        append(part, f, triangles);
        used.insert(part.polygons[f].begin(), part.polygons[f].end());
      }
      EXPECT_EQ(used.size(), part.points.size()) << name;
    }
    EXPECT_EQ(triangles, expected) << name;
  }
  EXPECT_EQ(m_folder.names().size(), 13u); // also a.mtl
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
  ASSERT_EQ(mesh.number_of_faces(), s_segmentation.segment_of_face.size());
  for (const Face f : mesh.faces()) {
    ASSERT_EQ(std::size_t(segment[f]), s_segmentation.segment_of_face[f]);
    const Color expected = segment_color(s_segmentation.segment_of_face[f]);
    ASSERT_EQ(color[f], CGAL::IO::Color(expected[0], expected[1], expected[2]));
  }
}

/// Where the last one cannot be written, neither is.
TEST_F(Written, obj_and_its_materials_appear_together_or_not_at_all)
{
  std::filesystem::create_directory(m_folder.path("a.mtl"));
  EXPECT_THROW(write_segmentation(make_output(m_folder.path("a.obj")), result()), Output_error);
  EXPECT_EQ(m_folder.names(), std::vector<std::string>{"a.mtl"});
}

TEST_F(Written, solids_are_closed)
{
  const auto is_closed = [](const Polygon_soup& soup) {
    std::map<std::array<Point, 2>, int> sides;
    for (const auto& face : soup.polygons)
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Point &a = soup.points[face[i]], &b = soup.points[face[(i + 1) % face.size()]];
        ++sides[{a, b}], --sides[{b, a}];
      }
    return std::all_of(sides.begin(), sides.end(), [](const auto& s) { return s.second == 0; });
  };
  for (const char* name : {"{segment}.ply", "{segment}.stl"})
    write_segmentation(make_output(m_folder.path(name), Output_content::SOLIDS), result());
  EXPECT_EQ(m_folder.names().size(), 2 * s_segmentation.number_of_segments);
  for (const std::string& name : m_folder.names())
    EXPECT_TRUE(is_closed(read_mesh(m_folder.path(name)).soup)) << name;
  EXPECT_EQ(make_output("a.seg", Output_content::SOLIDS).content, Output_content::SEGMENTS);
}

// A square and two triangles in two segments, a face of none, one without area, an unused point.
TEST(Write_mesh, msh_has_groups)
{
  Polygon_soup soup;
  soup.points = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.1, 0, 1}};
  soup.polygons = {{1, 2, 3, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {1, 1, 2}};
  std::ostringstream out;
  write_msh(out, {soup, {2, 0, 0, std::size_t(-1), 0}, {"hole_0_r2", "none", "top"}});
  EXPECT_EQ(out.str(), "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                       "$PhysicalNames\n2\n2 1 \"hole_0_r2\"\n2 3 \"top\"\n$EndPhysicalNames\n"
                       "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0.1 0 1\n$EndNodes\n"
                       "$Elements\n5\n1 2 2 3 3 4 1 2\n2 2 2 3 3 4 2 3\n3 2 2 1 1 1 2 5\n"
                       "4 2 2 1 1 2 3 5\n5 2 2 0 4 3 4 5\n$EndElements\n");
}

TEST(Write_mesh, painted_names_are_for_3mf)
{
  for (const char* name : {"a.ply", "a.csv"})
    EXPECT_EQ(make_output(name, Output_content::PAINTED).content, Output_content::SEGMENTS);
  EXPECT_EQ(make_output("a.3mf", Output_content::PAINTED).content, Output_content::PAINTED);
}

TEST_F(Written, json_has_all)
{
  const nlohmann::json json = nlohmann::json::parse(text("a.json"));
  EXPECT_EQ(json["format"], "segment_mesh");
  EXPECT_EQ(json["version"], 2);
  EXPECT_EQ(json["input"]["name"], s_name);
  EXPECT_EQ(json["settings"]["method"], "two-step");
  EXPECT_EQ(json["settings"]["segments"], 10);
  EXPECT_EQ(json["settings"]["smooth_borders"], false);
  EXPECT_EQ(json["settings"]["features"], "concave");
  EXPECT_NEAR(json["settings"]["max_angle"], 1.2372, 1e-4);
  EXPECT_EQ(json["times"]["stages"].size(), s_segmentation.stages.size());
  EXPECT_EQ(json["feature_lines"].get<std::vector<Polyline>>(), s_details->feature_lines());
  EXPECT_GT(json["feature_lines"].size(), 0u);
  EXPECT_EQ(json["face_segments"].get<std::vector<std::size_t>>(), s_segmentation.segment_of_face);
  EXPECT_EQ(json["regions"].size(), s_segmentation.number_of_regions);
  EXPECT_EQ(json["sections"].size(), s_details->sections().size());
  EXPECT_EQ(json["merges"].size(), s_segmentation.tree.merges().size());
  ASSERT_EQ(json["segments"].size(), s_segmentation.number_of_segments);
  std::vector<double> areas(json["segments"].size());
  for (const auto& region : json["regions"])
    areas[region["segment"]] += region["area"].get<double>();
  for (std::size_t s = 0; s < areas.size(); ++s) {
    EXPECT_NEAR(json["segments"][s]["area"], areas[s], 1e-9 * areas[s]);
    EXPECT_EQ(json["segments"][s]["faces"], std::count(s_segmentation.segment_of_face.begin(),
                                                       s_segmentation.segment_of_face.end(), s));
  }
}

TEST_F(Written, json_is_valid_whatever_the_name)
{
  const std::string latin_1 = "caf\xe9.off";
  std::ostringstream out;
  write_json(out, {latin_1, s_input, s_marks, s_settings, s_side_files, s_segmentation, *s_details,
                   s_no_viewpoint});
  EXPECT_EQ(nlohmann::json::parse(out.str())["input"]["name"], "caf\xef\xbf\xbd.off");
}

TEST_F(Written, details_agree_with_labels)
{
  const Segmentation& s = s_segmentation;
  const std::vector<Region> regions = s_details->regions();
  EXPECT_EQ(regions.size(), s.number_of_regions);
  std::vector<std::size_t> faces(s.number_of_regions);
  for (std::size_t f = 0; f < s.region_of_face.size(); ++f) {
    ++faces[s.region_of_face[f]];
    ASSERT_EQ(regions[s.region_of_face[f]].segment, s.segment_of_face[f]);
  }
  std::vector<double> perimeters(s.number_of_regions);
  for (const Section& section : s_details->sections())
    for (std::size_t region : section.regions)
      perimeters[region] += section.length;
  for (std::size_t r = 0; r < s.number_of_regions; ++r) {
    EXPECT_EQ(regions[r].number_of_faces, faces[r]);
    EXPECT_NEAR(regions[r].perimeter, perimeters[r], 1e-12 * (1 + perimeters[r]));
  }
}

/// Each node of the top of the tree against a description of that partition alone.
TEST_F(Written, nodes_are_described_as_segments_of_partitions)
{
  constexpr std::size_t greatest = 14;
  const std::vector<Node_description> nodes = s_details->nodes(greatest);
  std::size_t number_of_found = 0;
  const std::size_t least = s_segmentation.number_of_regions - s_segmentation.tree.merges().size();
  for (std::size_t k = least; k <= greatest; ++k) {
    Segmentation partitioned = s_segmentation;
    const auto partition = s_segmentation.tree.partition_at_count(k);
    for (std::size_t f = 0; f < partitioned.segment_of_face.size(); ++f)
      partitioned.segment_of_face[f] = partition[s_segmentation.region_of_face[f]];
    partitioned.number_of_segments = k;
    for (const Segment_description& segment :
         Segmentation_details(s_input.soup, s_settings, partitioned).segments())
      number_of_found += std::any_of(nodes.begin(), nodes.end(), [&](const Node_description& node) {
        return node.shape.number_of_faces == segment.number_of_faces &&
               node.shape.area == segment.area &&
               node.shape.extents == segment.extents; // a volume depends on the other segments, by
                                                      // the caps
      });
  }
  EXPECT_EQ(number_of_found, (least + greatest) * (greatest - least + 1) / 2);
  EXPECT_EQ(nodes.size(), 2 * greatest - least);
}

TEST_F(Written, borders_have_the_length_of_the_borders)
{
  write_segmentation(make_output(m_folder.path("b.obj"), Output_content::BORDERS), result());
  std::istringstream in(m_folder.read("b.obj"));
  std::vector<Point> points;
  double length = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(2));
    Point p;
    if (line[0] == 'v' && words >> p[0] >> p[1] >> p[2])
      points.push_back(p);
    if (line[0] != 'l')
      continue;
    std::size_t last = 0;
    for (std::size_t i; words >> i; last = i)
      if (last != 0)
        length += std::sqrt(std::pow(points[i - 1][0] - points[last - 1][0], 2) +
                            std::pow(points[i - 1][1] - points[last - 1][1], 2) +
                            std::pow(points[i - 1][2] - points[last - 1][2], 2));
  }
  double expected = 0; // a border is that of two segments
  for (const Segment_description& segment : s_details->segments())
    expected += segment.border_length / 2;
  EXPECT_GT(length, 0);
  EXPECT_NEAR(length, expected, 1e-9 * expected);
}

TEST_F(Written, coordinates_that_a_format_cannot_have_are_refused)
{
  for (const auto& [name, scale] : std::vector<std::pair<std::string, double>>{
         {"a.glb", 1e300}, {"a.glb", 1e-300}, {"a.3mf", 1e40}, {"a.stl", 1e40}}) {
    Input_mesh input = s_input;
    for (Point& p : input.soup.points)
      for (double& x : p)
        x *= scale;
    const std::string file = m_folder.path(name);
    try {
      write_segmentation(make_output(file), {s_name, input, s_marks, s_settings, s_side_files,
                                             s_segmentation, *s_details, s_no_viewpoint});
      ADD_FAILURE() << name << " " << scale;
    } catch (const Output_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(file + ": coordinates reach ", 0), 0u)
        << error.what();
    }
    EXPECT_TRUE(m_folder.names().empty());
  }
}

TEST_F(Written, gzip_is_undone_by_gzip)
{
  const std::string plain = text("a.off");
  std::filesystem::remove(m_folder.path("a.off"));
  write("b.off.gz");
  ASSERT_EQ(std::system(("gzip -d '" + m_folder.path("b.off.gz") + "'").c_str()), 0);
  EXPECT_EQ(m_folder.read("b.off"), plain);
}

/// By two-step, which does not move borders itself.
TEST_F(Written, smoothed_borders_are_shorter_and_regions_stay_nested)
{
  Segmentation_settings settings = s_settings;
  const auto border_length = [](const Segmentation& s) {
    double sum = 0;
    for (const Segment_description& segment :
         Segmentation_details(s_input.soup, s_settings, s).segments())
      sum += segment.border_length;
    return sum;
  };
  const Segmentation rough = run_segmentation(s_input.soup, {}, settings, {});
  settings.borders = Border_treatment::SMOOTHING;
  const Segmentation smooth = run_segmentation(s_input.soup, {}, settings, {});
  EXPECT_NE(smooth.segment_of_face, rough.segment_of_face);
  EXPECT_EQ(smooth.number_of_segments, rough.number_of_segments);
  EXPECT_LT(border_length(smooth), border_length(rough));
  std::map<std::size_t, std::size_t> segment_of_region;
  for (std::size_t f = 0; f < smooth.region_of_face.size(); ++f) {
    const auto
      entry = segment_of_region.emplace(smooth.region_of_face[f], smooth.segment_of_face[f]).first;
    ASSERT_EQ(entry->second, smooth.segment_of_face[f]) << f;
  }
}

TEST(Segmentation_from_labels, numbers_them_in_their_order)
{
  const Segmentation s = segmentation_from_labels({7, -2, 7, 3});
  EXPECT_EQ(s.number_of_segments, 3u);
  EXPECT_EQ(s.segment_of_face, (std::vector<std::size_t>{2, 0, 2, 1}));
}

} // namespace write_segmentation_test
