// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/read_mesh.h"

#include "Temporary_folder.h"
#include "batch/scores.h"
#include "read/read_marks.h"
#include "sample_files.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <regex>

namespace read_mesh_test {

using namespace segment_mesh;
using sample::with;

/// The tetrahedron of sample_files.h, whatever the order of its points.
void expect_tetrahedron(const Input_mesh& input)
{
  ASSERT_EQ(input.soup.points.size(), 4u);
  ASSERT_EQ(input.soup.polygons.size(), 4u);
  for (std::size_t f = 0; f < 4; ++f) {
    ASSERT_EQ(input.soup.polygons[f].size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      const double* expected = sample::points[sample::faces[f][i]];
      const Point& p = input.soup.points[input.soup.polygons[f][i]];
      EXPECT_EQ(p, (Point{expected[0], expected[1], expected[2]})) << "face " << f;
    }
  }
  EXPECT_TRUE(input.remarks.empty());
}

struct Sample
{
  const char* name;
  const char* file;
  std::string bytes;
};

std::ostream& operator<<(std::ostream& out, const Sample& s)
{
  return out << s.name;
}

class Well_formed : public testing::TestWithParam<Sample>
{};

TEST_P(Well_formed, is_read)
{
  const Temporary_folder folder;
  expect_tetrahedron(read_mesh(folder.write(GetParam().file, GetParam().bytes)));
}

const std::string
  crlf_off = "OFF\r\n4 4 6\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n3 0 2 1\r\n3 0 1 3\r\n"
             "3 1 2 3\r\n3 0 3 2";
const std::string colored_off = "# a comment\n\nSTCNOFF # textures, colors, normals\n# another\n4 "
                                "4\n0\n0 0 0 0 0 1 255 0 0 255 0 0\n\n"
                                "1 0 0\n0 1 0 0 0 1 -7\n0 0 1 0 0 1 3 4 5 # no more\n3 0 2 1 255 0 "
                                "0\n3 0 1 3\n3 1 2 3 -5\n3 0 3 2 0.5 0.5\n";
const std::string rich_obj =
  "# a comment\nmtllib x.mtl\no thing\nv 0 0 0 1 0 0\nv\t1\t0\t0\nvt 0 0\nvn 0 0 1\nv 0 1 \\\n0\n"
  "g a\nusemtl red\ns off\nf 1/1/1 3/1/1 2/1/1\nf\t1//1\t2//1\t4//1\nv 0 0 1\nf -3 -2 -1\nf 1/1 "
  "4/1 3/1\n"
  "l 1 2 3\n";
/// The text with each character of `from` replaced.
std::string changed(std::string text, char from, const std::string& to)
{
  std::string result;
  for (const char c : text)
    result += c == from ? to : std::string(1, c);
  return result;
}

const std::string off_in_words = "OFF # x\n4 # vertices\n4\n0 0 0 0 1 0 0 0\n1 0 0\n0\n1 3 0\n2 1 "
                                 "# face\n3 0 1 3 3 1 2 3 3\n0 3 2\n";
const std::string stl_with_more_words = with(with(sample::stl(), "outer", "color 1 0 0\nouter"),
                                             "facet", "color 1 0 0\nfacet");

/// The header's lines end with carriage returns alone, and the data begin with a line feed.
std::string ply_of_returns(const std::string& format)
{
  const std::string header = sample::ply_header(format);
  const std::string start = with(header, "element vertex",
                                 "element x 1\nproperty char w\nelement vertex");
  return changed(start, '\n', "\r") + "\n" + sample::binary_ply(format).substr(header.size());
}

const std::string continued_obj = "v 0 0 \\\n0\nv 1 \\ \r\n\\\n 0 0\nl 1 2 \\\n 1\nv 0 1 0 # not "
                                  "continued \\\nv 0 0 1\nf 1\\\n3 2\nf 1 2 4\n"
                                  "f 2 3 4\nf 1 4 3\\\n";
const std::string rich_ply = "ply\ncomment before the format\nformat ascii 1.0\nobj_info "
                             "x\n\nelement vertices 4\nproperty uchar red\n"
                             "property double x\nproperty double y\nproperty double z\nelement "
                             "halfedge 1\nproperty int source\n"
                             "property list uchar float uv\nelement faces 4\nproperty list int "
                             "uint vertex_index\nproperty int id\n"
                             "end_header\n9 0 0 0 9 1 0\n0 9 0 1 0 9 0 0 1\n7 2 0.5 0.5\n3 0 2 1 0 "
                             "3 0 1 3 0\n3 1 2 3 0 3 0 3 2 0\n";

INSTANTIATE_TEST_SUITE_P(
  Input, Well_formed,
  testing::Values(
    Sample{"off", "a.off", sample::off()}, Sample{"ending", "A.OFF", sample::off()},
    Sample{"off_crlf", "a.off", crlf_off}, Sample{"off_colored", "a.off", colored_off},
    Sample{"off_cr", "a.off", changed(sample::off(), '\n', "\r")},
    Sample{"off_mixed_lines", "a.off", with(crlf_off, "1 0 0\r\n", "1 0 0\r# x\n\n\r")},
    Sample{"off_colored_cr", "a.off", with(changed(colored_off, '\n', "\r"), "STCN", "NCST")},
    Sample{"off_word_a_line", "a.off", changed(sample::off(), ' ', "\n")},
    Sample{"off_on_a_line", "a.off", changed(sample::off(), '\n', "\t")},
    Sample{"off_two_faces_on_a_line", "a.off", with(sample::off(), "3 1 2 3\n", "3 1 2 3 ")},
    Sample{"off_in_words", "a.off", off_in_words},
    Sample{"off_one_header_line", "a.off", with(sample::off(), "OFF\n", "OFF ")},
    Sample{"off_glued_header", "a.off", with(sample::off(), "OFF\n4 4 0", "OFF4 4 0")},
    Sample{"off_byte_order_mark", "a.off", "\xef\xbb\xbf" + sample::off()},
    Sample{"obj", "a.obj", sample::obj()}, Sample{"obj_rich", "a.obj", rich_obj},
    Sample{"obj_byte_order_mark", "a.obj", "\xef\xbb\xbf" + sample::obj()},
    Sample{"obj_continued", "a.obj", continued_obj},
    Sample{"obj_cr", "a.obj", changed(rich_obj, '\n', "\r")},
    Sample{"obj_capitals", "a.obj", boost::algorithm::to_upper_copy(rich_obj)},
    Sample{"obj_faces_first", "a.obj",
           "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1"},
    Sample{"ply", "a.ply", sample::ply()}, Sample{"ply_rich", "a.ply", rich_ply},
    Sample{"ply_little", "a.ply", sample::binary_ply("binary_little_endian")},
    Sample{"ply_no_properties", "a.ply",
           with(sample::ply(), "element vertex", "element empty 0\nelement vertex")},
    Sample{"ply_binary_no_properties", "a.ply",
           with(sample::binary_ply("binary_little_endian"), "element vertex",
                "element empty 0\nelement vertex")},
    Sample{"ply_not_a_number_elsewhere", "a.ply",
           with(with(sample::ply(), "element face", "property float quality\nelement face"),
                "0 0 0\n1 0 0\n0 1 0\n0 0 1", "0 0 0 nan\n1 0 0 inf\n0 1 0 1\n0 0 1 -")},
    Sample{"ply_cr", "a.ply", changed(rich_ply, '\n', "\r")},
    Sample{"ply_crlf", "a.ply", changed(rich_ply, '\n', "\r\n")},
    Sample{"ply_capitals", "a.ply",
           with(with(sample::ply(), "ply\nformat", "PLY\nFORMAT"), "ascii", "ASCII")},
    Sample{"ply_little_cr", "a.ply", ply_of_returns("binary_little_endian")},
    Sample{"ply_big_cr", "a.ply", ply_of_returns("binary_big_endian")},
    Sample{"ply_name_like_a_coordinate", "a.ply",
           with(with(sample::ply(), "property float z\n", "property float z\nproperty float xx\n"),
                "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n")},
    Sample{"ply_big", "a.ply", sample::binary_ply("binary_big_endian")},
    Sample{"stl", "a.stl", sample::stl()}, Sample{"stl_binary", "a.stl", sample::binary_stl()},
    Sample{"stl_cr", "a.stl", changed(sample::stl(), '\n', "\r")},
    Sample{"stl_on_a_line", "a.stl", changed(sample::stl(), '\n', " ")},
    Sample{"stl_two_solids_on_a_line", "a.stl",
           changed(with(sample::stl(), "endfacet\n", "endfacet\nendsolid solid\nsolid second\n"),
                   '\n', " ")},
    Sample{"stl_word_a_line", "a.stl",
           changed(with(with(sample::stl(), " tetrahedron", ""), " tetrahedron", ""), ' ', "\n")},
    Sample{"stl_colors", "a.stl", stl_with_more_words},
    Sample{"stl_end_in_two_words", "a.stl",
           std::regex_replace(sample::stl(), std::regex("end"), "end ")},
    Sample{"stl_byte_order_mark", "a.stl", "\xef\xbb\xbf" + sample::stl()},
    Sample{"stl_capitals", "a.stl", boost::algorithm::to_upper_copy(sample::stl())},
    Sample{"stl_name", "a.stl", with(sample::stl(), "tetrahedron", "facet vertex endsolid")},
    Sample{"stl_normal", "a.stl", with(sample::stl(), "normal 0 0 0", "normal nan nan nan")},
    Sample{"off_signs_and_tiny_numbers", "a.off", with(sample::off(), "1 0 0", "+1 +0 1e-400")},
    Sample{"stl_two_solids", "a.stl",
           with(sample::stl(), "endfacet\n", "endfacet\nendsolid\n\nsolid second\n")},
    Sample{"stl_solid_binary", "a.stl", sample::binary_stl("solid facet vertex")}),
  [](const auto& info) { return info.param.name; });

TEST(Labels_and_marks, may_end_lines_with_carriage_returns)
{
  const Temporary_folder folder;
  Input_mesh input = read_mesh(folder.write("a.off", sample::off()));
  const std::string labels = folder.write("a.seg", "5\r# x\r6\r\n7\n8\r");
  EXPECT_EQ(read_truth(labels, 4).labels, (std::vector<std::int64_t>{5, 6, 7, 8}));
  const Marks marks = read_marks(
    {"", folder.write("a.txt", "0 1\r1 2\r"), folder.write("b.txt", "1 3\r2 4\r"), {}, {}}, "a.off",
    input);
  EXPECT_EQ(marks.constrained_edges, (std::vector<Vertex_pair>{{0, 1}, {1, 2}}));
  EXPECT_EQ(marks.seed_of_face, (std::vector<std::size_t>{no_seed, 3, 4, no_seed}));
  EXPECT_THROW(read_truth(folder.write("c.seg", std::string("\xff\xfe\0\0", 4)), 4), Input_error);
}

TEST(Unknown_statements, are_skipped_with_a_remark)
{
  const Temporary_folder folder;
  const auto remarks = [&folder](const std::string& statements) {
    return read_mesh(folder.write("a.obj", statements + sample::obj())).remarks;
  };
  const std::string start = folder.path("a.obj") + ":2: unknown statement 'hello' skipped";
  EXPECT_EQ(remarks("\nhello world\n"), Remarks{start});
  EXPECT_EQ(remarks("\nhello\nworld\nhello\n"), Remarks{start + ", and 2 more"});
}

TEST(Rest_of_a_file, is_not_read_with_a_remark)
{
  const Temporary_folder folder;
  const auto expect_remark = [&folder](const std::string& name, const std::string& bytes,
                                       const std::string& remark) {
    const std::string file = folder.write(name, bytes);
    EXPECT_EQ(read_mesh(file).remarks, remark.empty() ? Remarks() : Remarks{file + remark});
  };
  expect_remark("a.off", sample::off() + "\n# the end\n\n", "");
  expect_remark("a.off", sample::off() + "\n3 0 1 2\n3 0 1 2\n",
                ":12: not read, nor what follows: the header promises 4 faces");
  const std::string items = ": the header promises 4 items of element 'face'";
  expect_remark("a.ply", sample::ply() + "\n \n", "");
  expect_remark("a.ply", sample::ply() + "\n3 0 1 2\n", ":19: not read, nor what follows" + items);
  for (const char* format : {"binary_little_endian", "binary_big_endian"})
    expect_remark("a.ply", sample::binary_ply(format) + "xyz",
                  ": not read: 3 bytes at the end" + items);
  expect_remark("a.stl", sample::binary_stl() + "xyz",
                ": not read: 3 bytes at the end: the header promises 4 triangles");
}

TEST(Format, is_that_of_the_ending_or_a_given_one)
{
  EXPECT_EQ(mesh_format("a/b.off"), Mesh_format::OFF);
  EXPECT_EQ(mesh_format("b.x.OBJ"), Mesh_format::OBJ);
  EXPECT_EQ(mesh_format("b.Ply.gz"), Mesh_format::PLY);
  EXPECT_EQ(mesh_format("b.off.STL.GZ"), Mesh_format::STL);
  EXPECT_THROW(mesh_format("off.gz"), Input_error);
  EXPECT_THROW(mesh_format("-"), Input_error);
  EXPECT_TRUE(is_compressed("b.Ply.GZ"));
  EXPECT_FALSE(is_compressed("b.gz.ply"));
  EXPECT_EQ(stem_of_input("a/b.off"), "b");
  EXPECT_EQ(stem_of_input("a.c/b.x.off.gz"), "b.x");
  EXPECT_EQ(stem_of_input("-"), "stdin");

  const Temporary_folder folder;
  expect_tetrahedron(read_mesh(folder.write("a.off", sample::ply()), Mesh_format::PLY));
}

TEST(Bad_file, is_told)
{
  const Temporary_folder folder;
  const auto message = [](const std::string& file) -> std::string {
    try {
      read_mesh(file);
    } catch (const Input_error& error) {
      return error.what();
    }
    return "was read";
  };
  EXPECT_EQ(message(folder.path("none.off")), folder.path("none.off") + ": no such file");
  std::filesystem::create_directory(folder.path("folder.off"));
  EXPECT_EQ(message(folder.path("folder.off")), folder.path("folder.off") + ": is a directory");
}

} // namespace read_mesh_test
