// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/read_mesh.h"

#include "Temporary_folder.h"
#include "read/errors.h"
#include "sample_files.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

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

/// The tetrahedron as strips of one triangle, of two with repeated points between them, of none,
/// and of one.
std::string strips_ply(const std::string& format)
{
  std::string
    bytes = "ply\nformat " + format +
            " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const std::vector<std::int32_t> strips = {0, 2, 1,  -1, 0, 1,  3, 3, 2, 2,
                                            1, 3, -1, 2,  2, -1, 0, 3, 2, -1};
  if (format == "ascii") {
    bytes += "0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + std::to_string(strips.size());
    for (const std::int32_t i : strips)
      bytes += " " + std::to_string(i);
    return bytes + "\n";
  }
  for (const auto& p : sample::points)
    for (const double x : p)
      sample::append(bytes, float(x), format);
  sample::append(bytes, std::int32_t(strips.size()), format);
  for (const std::int32_t i : strips)
    sample::append(bytes, i, format);
  return bytes;
}

TEST(Triangle_strips, alternate_their_orientation)
{
  const Temporary_folder folder;
  const std::string
    header = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float "
             "y\nproperty float z\n"
             "element tristrips 2\nproperty list int int vertex_indices\nend_header\n",
    points = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n";
  const Input_mesh input = read_mesh(
    folder.write("a.ply", header + points + "6 0 2 1 3 -1 4\n4 2 4 3 5\n"));
  EXPECT_EQ(input.soup.polygons, (Polygons{{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}}));
  EXPECT_TRUE(input.remarks.empty());
}

INSTANTIATE_TEST_SUITE_P(
  Input, Well_formed,
  testing::Values(
    Sample{"off", "a.off", sample::off()}, Sample{"ending", "A.OFF", sample::off()},
    Sample{"off_crlf", "a.off", crlf_off}, Sample{"off_colored", "a.off", colored_off},
    Sample{"off_one_header_line", "a.off", with(sample::off(), "OFF\n", "OFF ")},
    Sample{"off_homogeneous", "a.off",
           "4OFF\n4 4 0\n0 0 0 1\n2 0 0 2\n0 1 0 1\n0 0 3 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"},
    Sample{"off_glued_header", "a.off", with(sample::off(), "OFF\n4 4 0", "OFF4 4 0")},
    Sample{"off_byte_order_mark", "a.off", "\xef\xbb\xbf" + sample::off()},
    Sample{"obj", "a.obj", sample::obj()}, Sample{"obj_rich", "a.obj", rich_obj},
    Sample{"obj_byte_order_mark", "a.obj", "\xef\xbb\xbf" + sample::obj()},
    Sample{"obj_continued", "a.obj", continued_obj},
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
    Sample{"ply_strips", "a.ply", strips_ply("ascii")},
    Sample{"ply_strips_little", "a.ply", strips_ply("binary_little_endian")},
    Sample{"ply_strips_big", "a.ply", strips_ply("binary_big_endian")},
    Sample{"ply_big", "a.ply", sample::binary_ply("binary_big_endian")},
    Sample{"stl", "a.stl", sample::stl()}, Sample{"stl_binary", "a.stl", sample::binary_stl()},
    Sample{"stl_byte_order_mark", "a.stl", "\xef\xbb\xbf" + sample::stl()},
    Sample{"stl_capitals", "a.stl", boost::algorithm::to_upper_copy(sample::stl())},
    Sample{"stl_name", "a.stl", with(sample::stl(), "tetrahedron", "facet vertex endsolid")},
    Sample{"stl_normal", "a.stl", with(sample::stl(), "normal 0 0 0", "normal nan nan nan")},
    Sample{"off_signs_and_tiny_numbers", "a.off", with(sample::off(), "1 0 0", "+1 +0 1e-400")},
    Sample{"stl_two_solids", "a.stl",
           with(sample::stl(), "endfacet\n", "endfacet\nendsolid\n\nsolid second\n")},
    Sample{"stl_solid_binary", "a.stl", sample::binary_stl("solid facet vertex")}),
  [](const auto& info) { return info.param.name; });

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

TEST(Lines_of_off, beyond_the_header_are_not_read_with_a_remark)
{
  const Temporary_folder folder;
  const auto remarks = [&folder](const std::string& end) {
    return read_mesh(folder.write("a.off", sample::off() + end)).remarks;
  };
  EXPECT_EQ(remarks("\n# the end\n\n"), Remarks{});
  const std::string text = sample::off();
  const auto lines = std::size_t(std::count(text.begin(), text.end(), '\n'));
  EXPECT_EQ(remarks("\n3 0 1 2\n3 0 1 2\n"),
            Remarks{folder.path("a.off") + ":" + std::to_string(lines + 2) +
                    ": not read, nor what follows: the header promises 4 faces"});
}

TEST(Items_of_ply, beyond_the_header_are_not_read_with_a_remark)
{
  const Temporary_folder folder;
  const auto remarks = [&folder](const std::string& bytes) {
    return read_mesh(folder.write("a.ply", bytes)).remarks;
  };
  const std::string start = folder.path("a.ply") + ":",
                    end = ": the header promises 4 items of element 'face'";
  const std::string text = sample::ply();
  const auto lines = std::size_t(std::count(text.begin(), text.end(), '\n'));
  EXPECT_EQ(remarks(text + "\n \n"), Remarks{});
  EXPECT_EQ(remarks(text + "\n3 0 1 2\n3 0 1 2\n"),
            Remarks{start + std::to_string(lines + 2) + ": not read, nor what follows" + end});
  for (const char* format : {"binary_little_endian", "binary_big_endian"})
    EXPECT_EQ(remarks(sample::binary_ply(format) + "xyz"),
              Remarks{start + " not read: 3 bytes at the end" + end});
}

TEST(Bytes_of_stl, beyond_the_header_are_not_read_with_a_remark)
{
  const Temporary_folder folder;
  const Input_mesh input = read_mesh(folder.write("a.stl", sample::binary_stl() + "xyz"));
  EXPECT_EQ(input.soup.polygons.size(), 4u);
  EXPECT_EQ(input.remarks, Remarks{folder.path("a.stl") + ": not read: 3 bytes at the end: the "
                                                          "header promises 4 triangles"});
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

/// A file of sysfs has the size of a page, whatever it holds.
TEST(Bad_file, that_ends_while_it_is_read_is_told)
{
  const char* const shorter_than_its_size = "/sys/devices/system/cpu/online";
  if (!std::filesystem::exists(shorter_than_its_size))
    GTEST_SKIP() << "no sysfs here";
  const Temporary_folder folder;
  std::filesystem::create_symlink(shorter_than_its_size, folder.path("a.off"));
  try {
    read_mesh(folder.path("a.off"));
    ADD_FAILURE() << "was read";
  } catch (const Input_error& error) {
    const std::string start = folder.path("a.off") + ": was cut off while it was read: ";
    EXPECT_EQ(std::string(error.what()).substr(0, start.size()), start);
  }
}

} // namespace read_mesh_test
