// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Evaluation/labels.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace labels_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

template <typename Label = long long>
std::vector<Label> read(const std::string& text)
{
  std::istringstream in(text);
  return RS::IO::read_labels<Label>(in);
}

/// The message of what a text is refused with.
template <typename Label = long long>
std::string refusal(const std::string& text)
{
  return message_of([&] { read<Label>(text); });
}

TEST(Labels_test, are_one_a_line)
{
  EXPECT_EQ(read("0\n-3\n12\n"), (std::vector<long long>{0, -3, 12}));
  EXPECT_EQ(read("7"), (std::vector<long long>{7})) << "without an end of line";
  EXPECT_EQ(read(" 1\t\r\n2\r\n\r\n\n"), (std::vector<long long>{1, 2})) << "of other systems";
  EXPECT_TRUE(read("").empty());
}

TEST(Labels_test, a_refusal_names_the_line)
{
  for (const std::string bad : {"x", "1.5", "1 2", "99999999999999999999", "0x1", "--1"})
    EXPECT_NE(refusal("1\n2\n" + bad + "\n4\n").find("line 3"), std::string::npos) << bad;
  EXPECT_NE(refusal("1\n\n\n2\n").find("line 2"), std::string::npos) << "an empty line inside";
}

TEST(Labels_test, a_file_that_is_not_there_is_refused)
{
  std::ifstream in("there/is/no/such.seg");
  EXPECT_THROW(RS::IO::read_labels(in), RS::Invalid_input);
}

TEST(Labels_test, a_label_must_fit_its_type)
{
  EXPECT_EQ(read<std::uint8_t>("255\n"), (std::vector<std::uint8_t>{255}));
  EXPECT_NE(refusal<std::uint8_t>("256\n").find("line 1"), std::string::npos);
  EXPECT_NE(refusal<std::size_t>("-1\n").find("line 1"), std::string::npos);
}

TEST(Labels_test, what_is_written_is_read)
{
  Surface_mesh mesh = to_surface_mesh(cube());
  auto a = mesh.add_property_map<Surface_mesh::Face_index, std::uint8_t>("f:a").first;
  auto b = mesh.add_property_map<Surface_mesh::Face_index, std::uint8_t>("f:b").first;
  std::uint8_t label = 48; // '0': as a character it would be read as 0
  for (auto f : faces(mesh))
    put(a, f, label++);
  std::stringstream stream;
  EXPECT_TRUE(RS::IO::write_labels(stream, mesh, a));
  EXPECT_EQ(stream.str(), "48\n49\n50\n51\n52\n53\n");
  RS::IO::read_labels(stream, mesh, b);
  for (auto f : faces(mesh))
    EXPECT_EQ(get(a, f), get(b, f));
}

TEST(Labels_test, a_wrong_number_leaves_the_map_alone)
{
  const Surface_mesh mesh = to_surface_mesh(cube());
  for (const char* text : {"1\n2\n3\n4\n5\n", "1\n2\n3\n4\n5\n6\n7\n", "1\n2\n3\n4\n5\nsix\n"}) {
    auto map = face_map(mesh, 9);
    std::istringstream in(text);
    EXPECT_THROW(RS::IO::read_labels(in, mesh, map), RS::Invalid_input);
    EXPECT_EQ(labels_of(mesh, map), Labels(6, 9));
  }
}

TEST(Labels_test, removed_faces_have_no_label)
{
  Surface_mesh mesh = to_surface_mesh(cube());
  CGAL::Euler::remove_face(halfedge(Surface_mesh::Face_index(2), mesh), mesh);
  auto map = face_map(mesh, 9);
  std::istringstream in("0\n1\n3\n4\n5\n");
  RS::IO::read_labels(in, mesh, map);
  EXPECT_EQ(labels_of(mesh, map), (Labels{0, 1, 3, 4, 5}));
  std::ostringstream out;
  EXPECT_TRUE(RS::IO::write_labels(out, mesh, map));
  EXPECT_EQ(out.str(), "0\n1\n3\n4\n5\n");
}

TEST(Labels_test, a_stream_that_fails_is_told)
{
  const Surface_mesh mesh = to_surface_mesh(cube());
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_FALSE(RS::IO::write_labels(out, mesh, face_map(mesh, 0)));
}

} // namespace labels_test
