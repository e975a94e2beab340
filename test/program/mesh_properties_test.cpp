// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a file has beside points and faces comes out with the segments, and can be the segments.

#include "Program.h"
#include "read/read_mesh.h"
#include "sample_files.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mesh_properties_test {

using namespace segment_mesh;

/// A pyramid with colors, texture points, of which the last one is not a number, two groups and two
/// materials; its last face has no texture.
const std::string pyramid = R"(mtllib wood steel.mtl
o box one
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0 0 0 1
v 0 1 0 0.5 0.5 0.5
v 0.5 0.5 1 1 1 1
vt 0 0
vt 0.25 0
vt 1 0.75
vt nan 1
usemtl wood (dark)
f 1/1 4/4 3/3
f 1/1 3/3 2/2
usemtl steel
f 1/1 2/2 5/3
g lid
f 2/1 3/2 5/3
f 3/-1 4 5/9
f 4//1 1//1 5//1
)";
const std::string labels_of_pyramid = "0\n0\n1\n1\n1\n1\n";

using Mesh_properties_program = Program;

TEST_F(Mesh_properties_program, obj_keeps_all)
{
  folder.write("a.obj", pyramid);
  folder.write("a.seg", labels_of_pyramid);
  std::filesystem::create_directory(folder.path("b"));
  EXPECT_EQ(run("a.obj --labels a.seg -o b/c.obj -o '{segment}.obj'").err, "");
  const std::string points = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 0.5 0.5 0.5\n"
                             "v 0.5 0.5 1 1 1 1\nvt 0 0\nvt 0.25 0\nvt 1 0.75\nvt 0 1\n";
  const std::string
    wood = "g segment_0 box_one\nusemtl wood (dark)\nf 1/1 4/4 3/3\nf 1/1 3/3 2/2\n",
    steel = "g segment_1 box_one\nusemtl steel\nf 1/1 2/2 5/3\n",
    lid = "g segment_1 lid\nusemtl steel\nf 2/1 3/2 5/3\nf 3/4 4 5\nf 4 1 5\n";
  EXPECT_EQ(folder.read("b/c.obj"), "mtllib ../wood steel.mtl\n" + points + wood + steel + lid);
  EXPECT_EQ(folder.read("1.obj"), "mtllib wood steel.mtl\n" + points + steel + lid);
  EXPECT_FALSE(std::filesystem::exists(folder.path("1.mtl")));
}

/// Of each corner of each triangle, in no order: the point, color and texture point, in 1/1000.
std::multiset<std::array<long, 8>> corners_of(const Input_mesh& input)
{
  std::multiset<std::array<long, 8>> result;
  const Mesh_properties& properties = input.properties;
  std::size_t corner = 0;
  for (const auto& polygon : input.soup.polygons)
    for (std::size_t i : polygon) {
      std::array<long, 8> values{};
      const auto color = properties.colors.at(corner, {9, 9, 9});
      const auto texture = properties.texture.at(corner++, {});
      for (std::size_t j = 0; j < 3; ++j) {
        values[j] = std::lround(1000 * input.soup.points[i][j]);
        values[3 + j] = std::lround(1000 * color[j]);
        if (j < 2)
          values[6 + j] = std::lround(1000 * texture[j]);
      }
      result.insert(values);
    }
  return result;
}

TEST_F(Mesh_properties_program, colors_and_textures_pass_through_formats)
{
  folder.write("a.obj", pyramid);
  folder.write("a.seg", labels_of_pyramid);
  const auto expected = corners_of(read_mesh(folder.path("a.obj")));
  ASSERT_EQ(expected.size(), 18u);
  EXPECT_EQ(run("a.obj --labels a.seg -o b.ply -o b.glb -o b.off").status, 0);
  EXPECT_EQ(run("b.ply -k 2 -o c.obj -o c.ply").status, 0);
  EXPECT_EQ(run("b.glb -k 2 -o d.glb -o d.obj").status, 0);
  // A byte for a channel is too coarse for .5.
  for (const char* file : {"b.glb", "d.glb", "d.obj"})
    EXPECT_EQ(corners_of(read_mesh(folder.path(file))), expected) << file;
  const Input_mesh ply = read_mesh(folder.path("b.ply"));
  for (const char* file : {"c.obj", "c.ply"})
    EXPECT_EQ(corners_of(read_mesh(folder.path(file))), corners_of(ply)) << file;
  const Input_mesh off = read_mesh(folder.path("b.off"));
  EXPECT_EQ(off.properties.colors.values, ply.properties.colors.values);
  EXPECT_NEAR(off.properties.colors.values.at(3)[0], 0.5, 1 / 255.0);
}

TEST_F(Mesh_properties_program, sets_are_numbered_in_ply_and_vtp)
{
  folder.write("a.obj", pyramid);
  folder.write("a.seg", labels_of_pyramid);
  EXPECT_EQ(run("a.obj --labels a.seg -o a.ply -o a.vtp").status, 0);
  const std::string ply = folder.read("a.ply"), vtp = folder.read("a.vtp");
  EXPECT_NE(ply.find("comment group 0 box one\ncomment group 1 lid\n"
                     "comment material 0 wood (dark)\ncomment material 1 steel\n"),
            std::string::npos);
  EXPECT_NE(vtp.find("Name=\"group\" NumberOfComponents=\"1\" format=\"ascii\">\n"
                     "0 \n0 \n0 \n1 \n1 \n1 \n"),
            std::string::npos);
  EXPECT_NE(vtp.find("Name=\"point_color\" NumberOfComponents=\"3\" format=\"ascii\">\n255 0 0 \n"),
            std::string::npos);
}

/// Of each line of text that starts so, the rest.
std::vector<std::string> lines_after(const std::string& start, const std::string& text)
{
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line.rfind(start, 0) == 0)
      result.push_back(line.substr(start.size()));
  return result;
}

TEST_F(Mesh_properties_program, labels_are_those_of_the_file)
{
  folder.write("a.obj", pyramid);
  const auto labels = [&](const std::string& arguments) {
    EXPECT_EQ(run(arguments + " -q -o labels.seg").status, 0) << arguments;
    return folder.read("labels.seg");
  };
  EXPECT_EQ(labels("a.obj --labels-from groups"), "0\n0\n0\n1\n1\n1\n");
  EXPECT_EQ(labels("a.obj --labels-from materials -o m.stl -o m.glb -o m.json"), labels_of_pyramid);
  const auto solids = lines_after("solid ", folder.read("m.stl"));
  EXPECT_EQ(solids, (std::vector<std::string>{"wood__dark_", "steel"}));
  const nlohmann::json json = nlohmann::json::parse(folder.read("m.json"));
  EXPECT_EQ(json["settings"], (nlohmann::json{{"labels_from", "materials"}}));
  EXPECT_EQ(json["segments"][0]["name"], "wood__dark_");

  EXPECT_EQ(labels("m.stl --labels-from solids"), labels_of_pyramid);
  EXPECT_EQ(labels("m.glb --labels-from groups"), labels_of_pyramid);
  EXPECT_EQ(labels("m.glb --labels-from materials"), labels_of_pyramid);

  EXPECT_EQ(run("a.obj --labels-from solids").err,
            "a.obj: has no solids; it has groups and materials\n");
  folder.write("a.off", sample::off());
  EXPECT_EQ(run("a.off --labels-from groups").err, "a.off: has no groups\n");
}

/// Solids of one name are several; faces before the first group of OBJ have one, too.
TEST_F(Mesh_properties_program, every_face_is_in_a_set)
{
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\n";
  folder.write("a.stl", "solid part\n" + facet + "endsolid part\nsolid part\n" + facet +
                          "endsolid\nsolid part_2\n" + facet + "endsolid\nsolid\n" + facet +
                          "endsolid\nsolid empty\nendsolid\n");
  EXPECT_EQ(run("a.stl --labels-from solids -o b.stl").status, 0);
  EXPECT_EQ(lines_after("solid ", folder.read("b.stl")),
            (std::vector<std::string>{"part", "part_2", "part_2_2", "unnamed"}));
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng a b\nf 1 2 3\ng a_b\nf 1 2 3\n"
                        "g\nf 1 2 3\ng a b\nf 1 2 3\n");
  EXPECT_EQ(run("a.obj --labels-from groups -o a.seg -o a.csv").status, 0);
  EXPECT_EQ(folder.read("a.seg"), "2\n0\n1\n2\n0\n");
  const std::string table = folder.read("a.csv");
  for (const char* name : {",unnamed\n", ",a_b\n", ",a_b_2\n"})
    EXPECT_NE(table.find(name), std::string::npos) << table;
}

TEST_F(Mesh_properties_program, borders_of_sets_are_constraints)
{
  // A flat strip of six squares, each two triangles; the second square has points of its own.
  std::string strip;
  for (int i = 0; i <= 6; ++i)
    strip += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i) + " 1 0\n";
  strip += "v 1 0 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\n"; // 15 to 18
  const auto square = [](int a, int b) {
    const auto s = [](int i) { return std::to_string(i) + " "; };
    return "f " + s(a) + s(b) + s(b + 1) + "\nf " + s(a) + s(b + 1) + s(a + 1) + "\n";
  };
  folder.write("a.obj", strip + "g left\n" + square(1, 3) + "g middle\n" + square(15, 17) +
                          square(5, 7) + "g right\n" + square(7, 9) + square(9, 11) +
                          square(11, 13));
  for (const std::string method : {"learned", "visibility", "two-step", "smooth-faces"}) {
    EXPECT_EQ(run("a.obj -k 1 -q --constraints-from groups -o a.seg --method " + method).status, 0);
    EXPECT_EQ(folder.read("a.seg"), "0\n0\n1\n1\n1\n1\n2\n2\n2\n2\n2\n2\n") << method;
  }
}

/// Colors and textures are no reason to refuse a mesh.
TEST_F(Mesh_properties_program, colors_and_textures_may_be_wrong)
{
  folder.write("a.obj",
               "v 0 0 0 nan 1 x\nv 1 0 0 1\nv 0 1 0 1e300 -1e300 2\nvt x\nvt 1e300 -1e300 0\n"
               "f 1/7 2/x 3/-9\nf 1/ 2/99999999999999999999 3/0\n");
  const std::string
    header = " 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nproperty double red\nproperty list uchar float blue\n"
             "element face 1\nproperty list uchar int vertex_indices\n"
             "property list uchar float texcoord\nend_header\n";
  folder.write("a.ply", "ply\nformat ascii" + header +
                          "0 0 0 nan 0\n1 0 0 x 1 2\n0 1 0 1e999 0\n3 0 1 2 3 nan 1 x\n");
  folder.write("a.off", "COFF\n3 1 0\n0 0 0 x 1\n1 0 0 nan nan nan 1\n0 1 0\n3 0 1 2\n");
  for (const std::string file : {"a.obj", "a.ply", "a.off"})
    for (const char* format : {"obj", "ply", "glb", "off", "vtp"}) {
      const Outcome outcome = run(file + " -k 1 -q -o b." + format);
      EXPECT_EQ(outcome.status, 0) << file << " " << outcome.err;
      const std::string bytes = folder.read(std::string("b.") + format);
      for (const char* wrong : {"nan", "inf", "null", "e+"})
        EXPECT_EQ(bytes.find(wrong), std::string::npos) << file << " " << format;
    }
}

/// A file whose triangles have two materials of three, with an image in the file and one beside it.
TEST_F(Mesh_properties_program, glb_keeps_materials)
{
  nlohmann::json json = nlohmann::json::parse(sample::gltf_json(""));
  const std::string image(std::string("\x89PNG\0image", 10));
  const std::string buffer = sample::gltf_buffer();
  json["materials"] = {{{"name", "a"}, {"emissiveFactor", {1, 0, 0}}},
                       {{"name", "b"}},
                       {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  json["images"] = {{{"mimeType", "image/png"}, {"bufferView", json["bufferViews"].size()}},
                    {{"uri", "b%20c.png"}}};
  json["bufferViews"].push_back(
    {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", image.size()}});
  json["buffers"][0]["byteLength"] = buffer.size() + image.size();
  auto& primitives = json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[0]["material"] = 2;
  primitives.push_back(primitives[0]);
  primitives[2]["material"] = 0;
  folder.write("a.glb", sample::glb(json.dump(), buffer + image));
  std::filesystem::create_directory(folder.path("b"));
  ASSERT_EQ(run("a.glb --labels-from groups -o b/b.glb -o b.csv").err, "");

  const std::string bytes = folder.read("b/b.glb");
  const auto number = [&](std::size_t at) {
    return std::size_t(read_little_endian<std::uint32_t>(&bytes.at(at)));
  };
  const nlohmann::json out = nlohmann::json::parse(bytes.substr(20, number(12)));
  const std::string data = bytes.substr(28 + number(12));
  EXPECT_EQ(out["materials"], json["materials"]);
  EXPECT_EQ(out["textures"], json["textures"]);
  EXPECT_EQ(out["images"][1]["uri"], "../b%20c.png");
  const auto view = out["bufferViews"].at(out["images"][0]["bufferView"].get<std::size_t>());
  EXPECT_EQ(data.substr(view.value("byteOffset", 0), view["byteLength"]), image);
  std::multiset<int> materials; // -1: none
  for (const auto& mesh : out["meshes"])
    for (const auto& primitive : mesh["primitives"])
      materials.insert(primitive.value("material", -1));
  EXPECT_EQ(materials, (std::multiset<int>{-1, 0, 2}));
  for (const auto& v : out["bufferViews"])
    EXPECT_EQ(v["byteOffset"].get<std::size_t>() % 4, 0u);

  EXPECT_EQ(run("b/b.glb --labels-from materials -o b.csv").status, 0);
  const std::string table = folder.read("b.csv");
  for (const char* name : {",a\n", ",material_2\n", ",unnamed\n"})
    EXPECT_NE(table.find(name), std::string::npos) << table;
  EXPECT_EQ(table.find(",b\n"), std::string::npos) << table;
}

/// `#` begins a comment, but not in a name; a line of libraries is one name if there is such a
/// file.
TEST_F(Mesh_properties_program, names_of_obj_are_kept)
{
  const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Material #25\nf 1 2 3 # x\n"
                            "usemtl  a  b \nf 3 2 1\n";
  folder.write("a.obj", "mtllib lib#1.mtl\nmtllib b c.mtl\nmtllib c.mtl d.mtl\n" + faces);
  folder.write("b c.mtl", "");
  folder.write("c.mtl", "");
  EXPECT_EQ(run("a.obj --labels-from materials -o b.obj -o b.csv").err, "");
  const std::string obj = folder.read("b.obj");
  EXPECT_EQ(lines_after("mtllib ", obj),
            (std::vector<std::string>{"lib#1.mtl", "b c.mtl", "c.mtl", "d.mtl"}));
  EXPECT_EQ(lines_after("usemtl ", obj), (std::vector<std::string>{"Material #25", "a  b"}));
  EXPECT_EQ(lines_after("g ", obj), (std::vector<std::string>{"Material__25", "a__b"}));

  folder.write("c.obj", faces); // without the file of its materials their names are groups
  EXPECT_EQ(run("c.obj -k 1 -o d.obj").status, 0);
  EXPECT_EQ(lines_after("g ", folder.read("d.obj")),
            (std::vector<std::string>{"segment_0 Material_#25", "segment_0 a__b"}));

  const Outcome outcome = run("a.obj -k 1 --solids -o c.obj");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(folder.read("c.mtl"), "");
  EXPECT_NE(outcome.err.find("c.obj: its .mtl would replace the materials of the input"),
            std::string::npos)
    << outcome.err;
}

TEST_F(Mesh_properties_program, names_are_of_ascii_and_different)
{
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng W\xc3\xa4nde/\xff\nf 1 2 3\ng a b\nf 1 2 3\n"
                        "g a_b_2\nf 1 2 3\ng a/b\nf 1 2 3\ng " +
                          std::string(300, 'x') + "\nf 1 2 3\n");
  EXPECT_EQ(run("a.obj --labels-from groups -o a.stl").status, 0);
  EXPECT_EQ(lines_after("solid ", folder.read("a.stl")),
            (std::vector<std::string>{"W_nde__", "a_b", "a_b_2", "a_b_3", std::string(100, 'x')}));
}

/// Of PLY: texture coordinates of vertices stay with them, the names of images stay, too.
TEST_F(Mesh_properties_program, ply_keeps_textures)
{
  const std::string start = "ply\nformat ascii 1.0\ncomment TextureFile my tex.png\n"
                            "element vertex 4\nproperty float x\nproperty float y\n"
                            "property float z\nproperty float s\nproperty float t\n",
                    points = "0 0 0 0 .25\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n";
  folder.write("a.ply", start +
                          "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
                          points + "3 0 1 2\n3 0 2 3\n");
  std::filesystem::create_directory(folder.path("b"));
  EXPECT_EQ(run("a.ply -k 1 -o b/b.ply").err, "");
  const std::string ply = folder.read("b/b.ply");
  EXPECT_NE(ply.find("comment TextureFile ../my tex.png\n"), std::string::npos);
  EXPECT_NE(ply.find("property float s\nproperty float t\n"), std::string::npos);
  EXPECT_EQ(ply.find("texcoord"), std::string::npos);
  EXPECT_EQ(read_mesh(folder.path("b/b.ply")).properties.texture.values.at(0)[1], 0.25);
}

/// Channels are from 0 to 1 where one of all has a fraction.
TEST_F(Mesh_properties_program, colors_of_off_have_one_unit)
{
  const std::string rest = "0 0 1\n1 0 0 1 0 0 1\n0 1 0 0 1 0 1\n3 0 1 2\n";
  folder.write("a.off", "COFF\n3 1 0\n0 0 0 0.5 1 " + rest);
  folder.write("b.off", "COFF\n3 1 0\n0 0 0 51 1 " + rest);
  using Rgb = Mesh_properties::Rgb;
  const auto colors = [&](const char* file) {
    return read_mesh(folder.path(file)).properties.colors.values;
  };
  EXPECT_EQ(colors("a.off"), (std::vector<Rgb>{{0.5f, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(colors("b.off")[0], (Rgb{51 / 255.f, 1 / 255.f, 0}));
}

/// Points at one place are one, their colors need not be.
TEST_F(Mesh_properties_program, glb_keeps_colors_of_corners)
{
  nlohmann::json json = nlohmann::json::parse(sample::gltf_json(""));
  std::string buffer = sample::gltf_buffer();
  for (int c = 0; c < 2; ++c) // red for all points of one triangle, blue for those of another
    for (int i = 0; i < 4; ++i)
      for (float x : {1.f - float(c), 0.f, float(c)})
        append_little_endian(buffer, x);
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 72}, {"byteLength", 96}});
  json["buffers"][0]["byteLength"] = buffer.size();
  auto& primitives = json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  for (int c = 0; c < 2; ++c) {
    json["accessors"].push_back({{"bufferView", 2},
                                 {"byteOffset", 48 * c},
                                 {"componentType", 5126},
                                 {"count", 4},
                                 {"type", "VEC3"}});
    primitives[std::size_t(c)]["attributes"]["COLOR_0"] = 2 + c;
  }
  folder.write("a.glb", sample::glb(json.dump(), buffer));
  ASSERT_EQ(run("a.glb --labels-from groups -o b.glb").err, "");
  for (const char* file : {"a.glb", "b.glb"}) {
    const Input_mesh input = read_mesh(folder.path(file));
    std::map<Mesh_properties::Rgb, int> corners;
    for (std::size_t i = 0; i < 24; ++i)
      ++corners[input.properties.colors.at(i, {})];
    EXPECT_EQ(corners, (std::map<Mesh_properties::Rgb, int>{{{1, 0, 0}, 12}, {{0, 0, 1}, 12}}));
    EXPECT_EQ(input.soup.points.size(), 4u);
  }
}

/// What is wrong with colors, textures and materials of glTF is told.
TEST_F(Mesh_properties_program, glb_may_have_wrong_materials)
{
  for (
    const char* wrong :
    {R"("materials":[{}],"images":[5])", R"("materials":[{}],"images":[{"uri":5}])",
     R"("materials":[{}],"images":[{"bufferView":9}])", R"("materials":[{"name":5}])",
     R"("materials":[{}],"images":[{"bufferView":0},{"bufferView":1},{"bufferView":2}],"x":1)"}) {
    std::string json = sample::with(sample::gltf_json(""), R"("POSITION":0)",
                                    R"("POSITION":0,"COLOR_0":1,"TEXCOORD_0":7)");
    json = sample::with(json, R"("meshes")", std::string(wrong) + R"(,"meshes")");
    folder.write("a.glb", sample::glb(json));
    const Outcome outcome = run("a.glb -k 1 -q -o b.glb -o b.obj");
    EXPECT_EQ(outcome.status, 0) << wrong << outcome.err;
    EXPECT_EQ(read_mesh(folder.path("a.glb")).remarks.size(), 1u) << wrong;
    EXPECT_EQ(read_mesh(folder.path("b.glb")).soup.polygons.size(), 4u) << wrong;
  }
}

} // namespace mesh_properties_test
