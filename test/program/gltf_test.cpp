// SPDX-License-Identifier: GPL-3.0-or-later

// Reading of .glb and .gltf.

#include "Temporary_folder.h"
#include "read/read_mesh.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace gltf_test {

using namespace segment_mesh;
using sample::glb;
using sample::gltf_json;
using sample::with;

class Gltf : public testing::Test
{
protected:
  Input_mesh read(const std::string& name, const std::string& bytes) const
  {
    return read_mesh(m_folder.write(name, bytes));
  }

  Temporary_folder m_folder;
};

/// The corners of each triangle.
std::vector<std::array<Point, 3>> triangles_of(const Polygon_soup& soup)
{
  std::vector<std::array<Point, 3>> result;
  for (const auto& polygon : soup.polygons)
    result.push_back({soup.points[polygon[0]], soup.points[polygon[1]], soup.points[polygon[2]]});
  return result;
}

std::vector<std::array<Point, 3>> tetrahedron()
{
  std::vector<std::array<Point, 3>> result;
  for (const auto& face : sample::faces) {
    result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        result.back()[i][j] = sample::points[face[i]][j];
  }
  return result;
}

TEST_F(Gltf, is_read_as_text_and_binary)
{
  EXPECT_EQ(triangles_of(read("a.glb", glb()).soup), tetrahedron());
  EXPECT_EQ(triangles_of(read("a.GLTF", sample::gltf()).soup), tetrahedron());
  EXPECT_EQ(triangles_of(read("b.gltf", glb()).soup), tetrahedron()); // the bytes tell
  m_folder.write("c.bin", sample::gltf_buffer());
  EXPECT_EQ(triangles_of(read("c.gltf", gltf_json(R"("uri":"c.bin",)")).soup), tetrahedron());
  EXPECT_EQ(read("a.glb", glb()).soup.points.size(), 4u);
}

TEST_F(Gltf, has_a_file_of_data_that_may_be_longer_than_said)
{
  m_folder.write("my data.bin", sample::gltf_buffer() + "more");
  EXPECT_EQ(triangles_of(read("c.gltf", gltf_json(R"("uri":"my%20data.bin",)")).soup),
            tetrahedron());
}

TEST_F(Gltf, is_placed_by_its_nodes)
{
  // x goes to 2 y by the child, whose rotation is a quarter turn around z; then all to x + 10.
  const std::string
    nodes = R"("nodes":[{"children":[1],"translation":[10,0,0]},{"mesh":0,"scale":[2,1,1],)"
            R"("rotation":[0,0,0.7071067811865476,0.7071067811865476]}])";
  const Polygon_soup
    soup = read("a.glb", glb(with(gltf_json(""), R"("nodes":[{"mesh":0}])", nodes))).soup;
  const Point expected[] = {{10, 0, 0}, {10, 2, 0}, {9, 0, 0}, {10, 0, 1}};
  ASSERT_EQ(soup.points.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(soup.points[i][j], expected[i][j], 1e-14);

  // The columns of a matrix; it mirrors, so that corners run the other way round.
  const std::string
    mirrored = R"("nodes":[{"mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]}])";
  const auto triangles = triangles_of(
    read("a.glb", glb(with(gltf_json(""), R"("nodes":[{"mesh":0}])", mirrored))).soup);
  EXPECT_EQ(triangles[0], (std::array<Point, 3>{{{5, 6, 7}, {4, 6, 7}, {5, 7, 7}}}));
}

TEST_F(Gltf, shows_the_scene_that_is_named)
{
  const std::string two =
    R"("scene":1,"scenes":[{"nodes":[0]},{"nodes":[1,0]}],"nodes":[{"mesh":0},{"mesh":0,"translation":[3,0,0]}])";
  const std::string one = R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])";
  const Polygon_soup soup = read("a.glb", glb(with(gltf_json(""), one, two))).soup;
  ASSERT_EQ(soup.polygons.size(), 8u);
  EXPECT_EQ(soup.points[0], (Point{3, 0, 0})); // nodes in their order
  const std::string none = R"("nodes":[{"mesh":0},{"children":[0]}])";
  EXPECT_EQ(read("a.glb", glb(with(gltf_json(""), one, none))).soup.polygons.size(), 4u);
}

TEST_F(Gltf, has_strips_fans_and_triangles_without_indices)
{
  const auto triangles = [this](const std::string& primitive) {
    return read("a.glb", glb(with(gltf_json(""), R"("indices":1,"mode":4)", primitive)))
      .soup.polygons;
  };
  EXPECT_EQ(triangles(R"("mode":4)"), (Polygons{{0, 1, 2}}));
  EXPECT_EQ(triangles(R"("mode":5)"), (Polygons{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(triangles(R"("mode":6)"), (Polygons{{0, 1, 2}, {0, 2, 3}}));
  // 0 2 1 0 1 3 1 2 3 0 3 2 without those that have a point twice
  EXPECT_EQ(
    triangles(R"("indices":1,"mode":5)"),
    (Polygons{{0, 2, 1}, {2, 0, 1}, {0, 3, 1}, {3, 2, 1}, {1, 2, 3}, {2, 0, 3}, {0, 2, 3}}));
  std::string buffer = sample::gltf_buffer().substr(0, 48);
  for (const std::uint16_t i : {0, 0, 1, 2, 2, 3, 3, 3, 1, 0, 0, 2})
    append_little_endian(buffer, i);
  const std::string strip = with(gltf_json(""), R"("mode":4)", R"("mode":5)");
  EXPECT_EQ(read("a.glb", glb(strip, buffer)).soup.polygons, (Polygons{{0, 2, 1}, {3, 0, 1}}));
}

TEST_F(Gltf, has_quantized_positions)
{
  std::string buffer;
  for (const auto& p : sample::points) {
    for (double x : p)
      append_little_endian(buffer, std::int16_t(32767 * x));
    append_little_endian(buffer, std::int16_t(0)); // to the next multiple of four bytes
  }
  buffer.resize(48, '\0');
  buffer += sample::gltf_buffer().substr(48);
  std::string json = with(gltf_json(""), R"("componentType":5126,"count":4)",
                          R"("componentType":5122,"normalized":true,"count":4)");
  json = with(json, R"("byteLength":48)", R"("byteLength":48,"byteStride":8)");
  EXPECT_EQ(triangles_of(read("a.glb", glb(json, buffer)).soup), tetrahedron());
}

/// The point at (0, 0, 1) is one of those that replace others, or that replace zeros.
TEST_F(Gltf, has_sparse_positions)
{
  std::string buffer = sample::gltf_buffer();
  const std::string point = buffer.substr(36, 12);
  buffer += std::string("\3\0\0\0", 4) + point;
  const std::string views =
    R"("byteLength":24},{"buffer":0,"byteOffset":72,"byteLength":2},{"buffer":0,"byteOffset":76,"byteLength":12}])";
  const std::string sparse =
    R"("sparse":{"count":1,"indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":3}},"count":4)";
  const std::string json = with(with(gltf_json(""), R"("byteLength":24}])", views), R"("count":4)",
                                sparse);
  EXPECT_EQ(triangles_of(read("a.glb", glb(json, buffer.replace(36, 12, 12, 'x'))).soup),
            tetrahedron());
  const Polygon_soup zeros = read("a.glb", glb(with(json, R"("bufferView":0,)", ""), buffer)).soup;
  EXPECT_EQ(zeros.points, (std::vector<Point>{{0, 0, 0}, {0, 0, 1}}));
  EXPECT_THROW(read("a.glb", glb(json, buffer.replace(72, 1, "\4"))), Input_error);
}

/// Extensions that change no triangle.
TEST_F(Gltf, may_need_materials)
{
  const std::string
    needs = R"({"extensionsRequired":["KHR_materials_unlit","KHR_mesh_quantization"],)";
  EXPECT_EQ(read("a.glb", glb(with(gltf_json(""), "{", needs))).soup.polygons.size(), 4u);
}

TEST_F(Gltf, points_and_lines_are_left_out)
{
  const std::string more =
    R"("mode":4},{"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},"mode":3)";
  const Input_mesh input = read("a.glb", glb(with(gltf_json(""), R"("mode":4)", more)));
  EXPECT_EQ(input.soup.polygons.size(), 4u);
  EXPECT_EQ(input.remarks,
            Remarks{m_folder.path("a.glb") + ": 2 primitives of points or lines left out"});
}

/// A file cannot make the program read what is not in its folder.
TEST_F(Gltf, reads_no_file_elsewhere)
{
  m_folder.write("a.bin", sample::gltf_buffer());
  std::filesystem::create_directory(m_folder.path("inner"));
  const std::string file = m_folder.write("inner/a.gltf", gltf_json(R"("uri":"../a.bin",)"));
  EXPECT_THROW(read_mesh(file), Input_error);
  EXPECT_THROW(read("inner/a.gltf", gltf_json(R"("uri":")" + m_folder.path("a.bin") + "\",")),
               Input_error);
}

/// A small file cannot exhaust the memory.
TEST_F(Gltf, repeats_no_mesh_without_end)
{
  std::string buffer = sample::gltf_buffer() + std::string(12 * 50000, '\0');
  const std::string primitive = R"({"attributes":{"POSITION":2}})";
  std::string primitives = primitive;
  for (int i = 0; i < 2000; ++i)
    primitives += "," + primitive;
  std::string json = with(gltf_json(""), R"({"attributes":{"POSITION":0},"indices":1,"mode":4})",
                          primitives);
  json = with(json, R"("byteLength":72)", R"("byteLength":)" + std::to_string(buffer.size()));
  json = with(json, R"("byteLength":24})",
              R"("byteLength":24},{"buffer":0,"byteOffset":72,"byteLength":600000})");
  json = with(
    json, R"("type":"SCALAR"})",
    R"("type":"SCALAR"},{"bufferView":2,"componentType":5126,"count":50000,"type":"VEC3"})");
  EXPECT_THROW(read("a.glb", glb(json, buffer)), Input_error);
}

} // namespace gltf_test
