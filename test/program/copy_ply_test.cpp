// SPDX-License-Identifier: GPL-3.0-or-later

// PLY files with the segments added, and all else kept.

#include "io/copy_ply.h"

#include "Program.h"
#include "sample_files.h"

#include "view/segment_colors.h"

namespace copy_ply_test {

using namespace segment_mesh;

const std::vector<std::size_t> segments = {0, 1, 1, 2};

const std::string added = "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int segment\n";

std::string color_of(std::size_t segment)
{
  std::string words;
  for (int channel : segment_color(segment))
    words += std::to_string(channel) + " ";
  return words;
}

TEST(Copy_ply, keeps_comments_properties_and_elements)
{
  const std::string header = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
                             "property float z\nproperty float quality\nelement face 4\n",
                    before = "property uchar red\n", list = "property list uchar int vertex_indices\nproperty int group\n",
                    rest = "element camera 1\nproperty float view_x\nend_header\n0 0 0 .5\n1 0 0 1e3\n0 1 0 -2\n0 0 1 7\n";
  const std::string input = header + before + list + rest + "9 3 0 2 1 5\n9 3 0 1 3 6\n9 3 1 2 3\n7\n9 3 0 3 2 8\n0.25\n";
  const std::string expected = header + list + added + rest + "3 0 2 1 5 " + color_of(0) + "0\n3 0 1 3 6 " + color_of(1) +
                               "1\n3 1 2 3 7 " + color_of(1) + "1\n3 0 3 2 8 " + color_of(2) + "2\n0.25\n";
  EXPECT_EQ(copy_ply(input, segments), expected);
  EXPECT_EQ(copy_ply(expected, segments), expected); // its own properties are replaced
}

TEST(Copy_ply, takes_both_orders_of_bytes)
{
  for (const std::string format : {"binary_little_endian", "binary_big_endian"}) {
    const std::string input = sample::binary_ply(format);
    const std::size_t faces = input.size() - 4 * 13;
    std::string expected = sample::with(input.substr(0, faces), "end_header\n", added + "end_header\n");
    for (std::size_t f = 0; f < 4; ++f) {
      expected += input.substr(faces + 13 * f, 13);
      for (std::uint8_t channel : segment_color(segments[f]))
        expected += char(channel);
      sample::append(expected, std::int32_t(segments[f]), format);
    }
    EXPECT_EQ(copy_ply(input, segments), expected) << format;
  }
}

TEST(Copy_ply, keeps_lists_of_every_size_type_and_all_elements_of_faces)
{
  const std::string header = "ply\r\nformat binary_big_endian 1.0\r\nelement faces 1\r\n"
                             "property list uint uchar vertex_index\r\nproperty list short double values\r\n",
                    more = "element vertex 3\r\nproperty char x\r\nproperty char y\r\nproperty char z\r\nelement face 1\r\n"
                           "property list char char vertex_index\r\nproperty double segment\r\n",
                    end = "end_header\r\n", first = std::string("\0\0\0\3\0\1\2", 7) + std::string("\0\1", 2) + "12345678",
                    points = std::string("\0\0\0\1\0\0\0\1\0", 9), second = std::string("\3\0\2\1", 4);
  const auto label = [](std::size_t segment) {
    std::string bytes;
    for (std::uint8_t channel : segment_color(segment))
      bytes += char(channel);
    return bytes + std::string(3, '\0') + char(segment);
  };
  const std::string input = header + more + end + first + points + second + "8 bytes.",
                    less = sample::with(more, "property double segment\r\n", "");
  EXPECT_EQ(copy_ply(input, {7, 9}),
            header + added + less + added + end + first + label(7) + points + second + label(9));
  for (std::size_t size = 0; size < input.size(); ++size)
    EXPECT_EQ(copy_ply(input.substr(0, size), {7, 9}), std::nullopt) << size;
}

TEST(Copy_ply, refuses_lists_that_no_file_holds)
{
  const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\n"
                             "property char z\nelement face 1\nproperty list uint double values\n"
                             "property list int int vertex_index\nend_header\n...";
  for (const std::string size : {"\xff\xff\xff\xff", "\xff\xff\xff\x1f"})
    EXPECT_EQ(copy_ply(header + size + std::string(100, '\0'), {0}), std::nullopt);
}

TEST(Copy_ply, refuses_what_it_does_not_understand)
{
  const std::string binary = sample::binary_ply("binary_little_endian");
  EXPECT_EQ(copy_ply("", segments), std::nullopt);
  EXPECT_EQ(copy_ply(sample::off(), segments), std::nullopt);
  EXPECT_EQ(copy_ply(sample::ply(), {0, 1}), std::nullopt);
  for (std::size_t size = 0; size < binary.size(); ++size)
    EXPECT_EQ(copy_ply(binary.substr(0, size), segments), std::nullopt) << size;
}

TEST_F(Program, keeps_the_properties_of_a_ply_input)
{
  const std::string input = sample::with(
    sample::with(sample::ply(), "element face", "property float quality\nelement face"),
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "0 0 0 .5\n1 0 0 1\n0 1 0 2\n0 0 1 3\n");
  folder.write("a.ply", input);
  const Outcome outcome = run("a.ply -k 4 -o b.ply");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.read("b.ply"), copy_ply(input, {0, 1, 2, 3}));
  if (std::system(("gzip -k " + folder.path("a.ply")).c_str()) != 0)
    GTEST_SKIP() << "no gzip";
  EXPECT_EQ(run("a.ply.gz -k 4 -o c.ply").status, 0);
  EXPECT_EQ(folder.read("c.ply"), folder.read("b.ply"));
}

} // namespace copy_ply_test
