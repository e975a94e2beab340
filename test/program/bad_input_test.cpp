// SPDX-License-Identifier: GPL-3.0-or-later

// Files that are malformed, each with the message that it must get.

#include "Temporary_folder.h"
#include "read/errors.h"
#include "read/read_mesh.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

namespace bad_input_test {

using sample::with;

/// A malformed file, and the expected diagnosis.
struct Malformed
{
  const char* name;
  const char* file;
  std::string bytes;
  std::string message; ///< after the name of the file
};

std::ostream& operator<<(std::ostream& out, const Malformed& m)
{
  return out << m.name;
}

class Bad_input : public testing::TestWithParam<Malformed>
{};

TEST_P(Bad_input, is_told_with_file_line_and_cause)
{
  const Temporary_folder folder;
  const std::string file = folder.write(GetParam().file, GetParam().bytes);
  try {
    segment_mesh::read_mesh(file);
    ADD_FAILURE() << "was read";
  } catch (const segment_mesh::Input_error& error) {
    EXPECT_EQ(error.what(), file + GetParam().message);
  }
}

const std::string off = sample::off(), obj = sample::obj(), ply = sample::ply(),
                  stl = sample::stl();

INSTANTIATE_TEST_SUITE_P(
  Off, Bad_input,
  testing::Values(
    Malformed{"empty", "a.off", "", ": is empty"},
    Malformed{"ending", "a.foo", off,
              ": unknown extension '.foo', not .off, .obj, .ply, .stl, .glb or .gltf"},
    Malformed{"header", "a.off", "hello\n", ":1: no OFF header, but 'hello'"},
    Malformed{"comments_only", "a.off", "# x\n# y\n", ":2: no OFF header, but ''"},
    Malformed{"binary", "a.off", "OFF BINARY\n", ":1: binary OFF is not supported"},
    Malformed{"dimension", "a.off", "nOFF\n3\n", ":1: no OFF header, but 'nOFF'"},
    Malformed{"count", "a.off", with(off, "4 4 0", "4 x 0"), ":2: 'x' is not a number of faces"},
    Malformed{"no_edges", "a.off", with(off, "4 4 0\n0 0 0", "4 4\n0.5 0 0"),
              ":3: '0.5' is not a number of edges"},
    Malformed{"short_header", "a.off", "OFF\n4",
              ":2: the file ends where the header has a number of faces"},
    Malformed{"no_faces", "a.off", "OFF\n1 0 0\n0 0 0\n", ":2: no faces"},
    Malformed{"cut_off", "a.off", off.substr(0, off.size() - 16),
              ":8: the header promises 4 faces, the file ends after 2"},
    Malformed{"cut_off_line", "a.off", off.substr(0, off.size() - 3),
              ":10: a face with 2 of 3 indices"},
    Malformed{"carriage_returns", "a.off", "OFF # x\r4 4 0\r0 0 0\r\n1 0 0\n\r",
              ":5: the header promises 4 vertices, the file ends after 2"},
    Malformed{"index_in_words", "a.off", with(with(off, "3 1 2 3", "3\n1\n2\n9"), "9\n", "9 "),
              ":9: a face with 0 of 3 indices"},
    Malformed{"coordinate", "a.off", with(off, "1 0 0", "1 0"),
              ":4: a vertex with 2 of 3 coordinates"},
    Malformed{"text", "a.off", with(off, "1 0 0", "1 zero 0"), ":4: 'zero' is not a number"},
    Malformed{"nan", "a.off", with(off, "1 0 0", "1 nan 0"), ":4: 'nan' is not a finite number"},
    Malformed{"glued_count", "a.off", with(off, "OFF\n4", "OFF4x"),
              ":1: no OFF header, but 'OFF4x'"},
    Malformed{"index", "a.off", with(off, "3 1 2 3", "3 1 2 4"),
              ":9: index 4 is out of range: there are 4 vertices, from 0"},
    Malformed{"negative_index", "a.off", with(off, "3 1 2 3", "3 1 2 -1"),
              ":9: index -1 is out of range: there are 4 vertices, from 0"},
    Malformed{"index_text", "a.off", with(off, "3 1 2 3", "3 1 2 c"),
              ":9: 'c' is not an index of a vertex"},
    Malformed{"edge", "a.off", with(off, "3 1 2 3", "2 1 2"),
              ":9: a face with 2 vertices, fewer than 3"},
    Malformed{"size", "a.off", with(off, "3 1 2 3", "99999999 1 2"),
              ":9: a face with 2 of 99999999 indices"}),
  [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
  Obj, Bad_input,
  testing::Values(
    Malformed{"text", "a.obj", "hello world\n", ":1: unknown statement 'hello'"},
    Malformed{"long_word", "a.obj", std::string(100, 'x') + "\n",
              ":1: unknown statement 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...'"},
    Malformed{"control", "a.obj", "\x1b[31m\n", ":1: unknown statement '?[31m'"},
    Malformed{"not_ascii", "a.obj", "a\x7f\xff z\n", ":1: unknown statement 'a?\?'"},
    Malformed{"unknown_first", "a.obj", "v 0 0 0\nhello\nworld\n", ":2: unknown statement 'hello'"},
    Malformed{"continued", "a.obj", "v 0 0 \\\n 0\nv 0 \\\n x 0\n", ":4: 'x' is not a number"},
    Malformed{"cut_off", "a.obj", obj.substr(0, obj.size() - 3),
              ":8: a face with 2 vertices, fewer than 3"},
    Malformed{"number", "a.obj", with(obj, "v 1 0 0", "v 1 0x1 0"), ":2: '0x1' is not a number"},
    Malformed{"index", "a.obj", with(obj, "f 2 3 4", "f 2 3 5"),
              ":7: index 5 is out of range: there are 4 vertices, from 1"},
    Malformed{"zero", "a.obj", with(obj, "f 2 3 4", "f 2 3 0"),
              ":7: index 0 is out of range: there are 4 vertices, from 1"},
    Malformed{"negative", "a.obj", with(obj, "f 2 3 4", "f 2 3 -5"),
              ":7: index -5 is out of range: there are 4 vertices, from 1"},
    Malformed{"edge", "a.obj", with(obj, "f 2 3 4", "f 2 3"),
              ":7: a face with 2 vertices, fewer than 3"}),
  [](const auto& info) { return info.param.name; });

std::string binary_ply()
{
  return sample::binary_ply("binary_little_endian");
}

/// Binary data with the four bytes at `offset` from the end of the header replaced.
template <typename T>
std::string patched(std::string bytes, std::size_t start, std::size_t offset, T value)
{
  std::string patch;
  segment_mesh::append_little_endian(patch, value);
  return bytes.replace(start + offset, patch.size(), patch);
}

std::string patched_ply(std::size_t offset, float value)
{
  return patched(binary_ply(), sample::ply_header("binary_little_endian").size(), offset, value);
}

std::string patched_ply(std::size_t offset, std::int32_t value)
{
  return patched(binary_ply(), sample::ply_header("binary_little_endian").size(), offset, value);
}

INSTANTIATE_TEST_SUITE_P(
  Ply, Bad_input,
  testing::Values(
    Malformed{"magic", "a.ply", sample::off(), ":1: no PLY header"},
    Malformed{"header_cut_off", "a.ply", ply.substr(0, ply.find("property float z")),
              ":5: the file ends before 'end_header'"},
    Malformed{"format", "a.ply", with(ply, "ascii", "ebcdic"),
              ": unknown format 'ebcdic' in the PLY header"},
    Malformed{"keyword", "a.ply", with(ply, "element", "elephant"),
              ":3: unknown line of a PLY header: 'elephant'"},
    Malformed{"count", "a.ply", with(ply, "vertex 4", "vertex -4"),
              ":3: -4 is not a number of items"},
    Malformed{"type", "a.ply", with(ply, "float x", "quad x"),
              ":4: unknown type of a property: 'quad'"},
    Malformed{"coordinate_type", "a.ply", with(ply, "float x", "list uchar float x"),
              ":4: property x is a list, not a number"},
    Malformed{"coordinate_range", "a.ply", with(with(ply, "float x", "char x"), "1 0 0", "128 0 0"),
              ":11: 128 is out of the range of its type"},
    Malformed{"no_z", "a.ply", with(ply, "float z", "float w"),
              ":3: a vertex needs the properties x, y and z, once each"},
    Malformed{"index_type", "a.ply", with(ply, "uchar int", "uchar float"),
              ":8: property vertex_indices is not a list of integers"},
    Malformed{"size_type", "a.ply", with(ply, "uchar int", "float int"),
              ":8: a list whose size is not an integer"},
    Malformed{"no_indices", "a.ply", with(ply, "vertex_indices", "corners"),
              ":7: a face needs the property vertex_indices, once"},
    Malformed{"no_faces", "a.ply", with(ply, "face 4", "face 0"), ": no faces"},
    Malformed{"float", "a.ply", with(ply, "1 0 0", "1 1e99 0"), ":11: y is not a finite number"},
    Malformed{"index", "a.ply", with(ply, "3 1 2 3", "3 1 2 4"),
              ":16: index 4 is out of range: there are 4 vertices, from 0"},
    Malformed{"edge", "a.ply", with(ply, "3 1 2 3", "2 1 2"),
              ":16: a face with 2 vertices, fewer than 3"},
    Malformed{"negative_face", "a.ply",
              with(with(ply, "uchar int", "char int"), "3 1 2 3", "-3 1 2 3"),
              ":16: a face with -3 vertices, fewer than 3"},
    Malformed{"cut_off", "a.ply", ply.substr(0, ply.size() - 6),
              ":17: the header promises 4 items of element 'face', the file ends after 3"},
    Malformed{"binary_cut_off", "a.ply", binary_ply().substr(0, binary_ply().size() - 1),
              ": the header promises 4 items of element 'face', the file ends after 3"},
    Malformed{"binary_promises", "a.ply", with(binary_ply(), "vertex 4", "vertex 4000000000"),
              ": the header promises 4000000000 items of element 'vertex', the file ends after 8"},
    Malformed{"binary_nan", "a.ply", patched_ply(16, std::nanf("")),
              ": item 1 of element 'vertex', from 0: y is not a finite number"},
    Malformed{
      "binary_index", "a.ply", patched_ply(62, 4),
      ": item 1 of element 'face', from 0: index 4 is out of range: there are 4 vertices, from 0"},
    Malformed{"binary_negative", "a.ply", patched_ply(62, -1),
              ": item 1 of element 'face', from 0: index -1 is out of range: there are 4 vertices, "
              "from 0"}),
  [](const auto& info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(
  Stl, Bad_input,
  testing::Values(
    Malformed{"text", "a.stl", "hello\n",
              ": neither a text that starts with 'solid' nor long enough for a binary STL"},
    Malformed{"no_faces", "a.stl", "solid\nendsolid\n", ": no faces"},
    Malformed{"word", "a.stl", with(stl, "facet", "faucet"),
              ":2: 'faucet' where 'facet' or 'endsolid' is due"},
    Malformed{"nan", "a.stl", with(stl, "vertex 0.000000", "vertex nan"),
              ":4: 'nan' is not a finite number"},
    Malformed{"edge", "a.stl", with(stl, "vertex", "comment"),
              ":8: a face with 2 vertices, fewer than 3"},
    Malformed{"square", "a.stl", with(stl, "endloop", "vertex 0 0 0 endloop"),
              ":7: a facet with more than 3 vertices"},
    Malformed{"solid_in_a_solid", "a.stl", with(stl, "facet", "solid inner\nfacet"),
              ":2: 'solid' where 'facet' or 'endsolid' is due"},
    Malformed{"facet_outside", "a.stl", stl + "facet\n", ":31: 'facet' where 'solid' is due"},
    Malformed{"cut_off", "a.stl", stl.substr(0, stl.find("endfacet")),
              ":7: the file ends within a facet"},
    Malformed{"cut_off_end", "a.stl", stl.substr(0, stl.find("endsolid")),
              ":29: the file ends before 'endsolid'"},
    Malformed{
      "binary_cut_off", "a.stl", sample::binary_stl().substr(0, 200),
      ": the header promises 4 triangles, the file ends after 2: no whole binary STL, and no text "
      "that starts with 'solid'"},
    Malformed{
      "binary_promises", "a.stl", patched(sample::binary_stl(), 80, 0, 0x7fffffff),
      ": the header promises 2147483647 triangles, the file ends after 4: no whole binary STL, and "
      "no text that starts with 'solid'"},
    Malformed{"binary_empty", "a.stl", patched(sample::binary_stl(), 80, 0, 0), ": no faces"},
    Malformed{"binary_nan", "a.stl", patched(sample::binary_stl(), 84, 50 + 12, std::nanf("")),
              ": triangle 1, from 0, has a coordinate that is not a finite number"}),
  [](const auto& info) { return info.param.name; });

/// A file of glTF with a part of its text replaced.
Malformed gltf(const char* name, const std::string& from, const std::string& to,
               const std::string& message)
{
  return {name, "a.glb", sample::glb(with(sample::gltf_json(""), from, to)), message};
}

Malformed extension(const char* name, const std::string& extension, const std::string& hint)
{
  return gltf(name, "{", R"({"extensionsRequired":[")" + extension + R"("],)",
              ": needs the extension '" + extension + "', which is not read" + hint);
}

std::string infinite_buffer()
{
  return sample::gltf_buffer().replace(0, 4, std::string("\0\0\x80\x7f", 4));
}

INSTANTIATE_TEST_SUITE_P(
  Gltf, Bad_input,
  testing::Values(
    Malformed{"empty", "a.glb", "", ": is empty"},
    Malformed{"no_json", "a.gltf", "{\n\"secret\": x}", ":2: the text is not JSON"},
    Malformed{"array", "a.gltf", "[]", ": a value of another type than glTF has there"},
    Malformed{"short", "a.glb", "glTF", ": is cut off"},
    Malformed{"cut_off", "a.glb", sample::glb().substr(0, sample::glb().size() - 1),
              ": is cut off: a chunk has 71 bytes of 72"},
    Malformed{"binary_version", "a.glb", sample::glb().replace(4, 1, "\1"),
              ": is of glTF version 1; version 2 is read"},
    gltf("version", "2.0", "1.0", ": is of glTF version '1.0'; version 2 is read"),
    extension("draco", "KHR_draco_mesh_compression", ": save it without compression"),
    extension("meshopt", "EXT_meshopt_compression", ": save it without compression"),
    extension("instances", "EXT_mesh_gpu_instancing", ""),
    gltf("more_instances", R"({"mesh":0})",
         R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}}})",
         ": nodes[0]: is repeated by the extension 'EXT_mesh_gpu_instancing', which is not read"),
    gltf("accessor", R"("POSITION":0)", R"("POSITION":7)",
         ": accessors[7]: array index 7 is out of range"),
    gltf("no_positions", R"("POSITION":0)", R"("NORMAL":0)",
         ": meshes[0]: key 'POSITION' not found"),
    gltf("type", R"("POSITION":0)", R"("POSITION":1)",
         ": accessors[1]: has another type than its use"),
    gltf("component", "5126", "5130", ": accessors[0]: an unknown type of numbers"),
    gltf("many", R"("count":4)", R"("count":5)",
         ": accessors[0]: reaches beyond the end of its data"),
    gltf("huge", R"("count":4)", R"("count":4000000000000)",
         ": accessors[0]: more points than the file has, or a mesh that is repeated too often"),
    gltf("few", R"("count":4)", R"("count":3)",
         ": accessors[1]: an index of a vertex that does not exist"),
    gltf("view", R"("byteLength":48)", R"("byteLength":47)",
         ": accessors[0]: reaches beyond the end of its data"),
    gltf("no_data", R"("bufferView":0,)", "", ": accessors[0]: has no data"),
    gltf("sparse", R"("bufferView":0,)", R"("sparse":{},)",
         ": accessors[0]: key 'count' not found"),
    gltf("mesh", R"({"mesh":0})", R"({"mesh":3})", ": meshes[3]: array index 3 is out of range"),
    gltf("negative", R"({"mesh":0})", R"({"mesh":-1})",
         ": nodes[0]: mesh is not an integer of at least 0"),
    gltf("parents", R"({"mesh":0})", R"({"mesh":0,"children":[0]})", ": nodes[0]: has two parents"),
    gltf("child", R"({"mesh":0})", R"({"mesh":0,"children":[9]})",
         ": nodes[9]: array index 9 is out of range"),
    gltf("no_faces", R"({"mesh":0})", "{}", ": no faces"),
    gltf("mode", R"("mode":4)", R"("mode":7)", ": meshes[0]: an unknown mode"),
    gltf("matrix", R"({"mesh":0})", R"({"mesh":0,"matrix":[1,0]})",
         ": nodes[0]: matrix has 2 of 16 numbers"),
    Malformed{"short_buffer", "a.glb", sample::glb(sample::gltf_json(""), "1234"),
              ": buffers[0]: has 4 of 72 bytes"},
    Malformed{"no_buffer", "a.gltf", sample::gltf_json(""), ": accessors[0]: has no data"},
    Malformed{"fallback", "a.gltf",
              with(sample::gltf_json(""), "{", R"({"extensionsUsed":["EXT_meshopt_compression"],)"),
              ": accessors[0]: has no data: the file uses the extension 'EXT_meshopt_compression', "
              "which is not read: save it without compression"},
    Malformed{"text_buffer", "a.gltf", sample::gltf_json(R"("uri":"data:text/plain,x",)"),
              ": buffers[0]: data that are not in base64"},
    Malformed{"bad_base64", "a.gltf", sample::gltf_json(R"("uri":"data:;base64,!!!!",)"),
              ": buffers[0]: has 0 of 72 bytes"},
    Malformed{"large_number", "a.gltf", with(sample::gltf_json(""), "72", "1e9999"),
              ": a number of the text is not a finite number"},
    Malformed{"no_scene", "a.gltf", with(sample::gltf_json(""), R"("scene":0)", R"("scene":null)"),
              ": scene is not an integer of at least 0"},
    Malformed{"no_file", "a.gltf", sample::gltf_json(R"("uri":"none.bin",)"),
              ": buffers[0]: 'none.bin' is not a file"},
    Malformed{"infinite", "a.glb", sample::glb(sample::gltf_json(""), infinite_buffer()),
              ": accessors[0]: a position that is not a finite number"}),
  [](const auto& info) { return info.param.name; });

std::string utf_16(const std::string& text, bool is_little_endian, const std::string& mark)
{
  std::string bytes = mark;
  for (const char c : text)
    bytes += is_little_endian ? std::string{c, '\0'} : std::string{'\0', c};
  return bytes;
}

const std::string utf_16_message = ": is a text in UTF-16: save it as UTF-8";

INSTANTIATE_TEST_SUITE_P(
  Utf_16, Bad_input,
  testing::Values(Malformed{"off", "a.off", utf_16(off, true, "\xff\xfe"), utf_16_message},
                  Malformed{"obj", "a.obj", utf_16(obj, false, "\xfe\xff"), utf_16_message},
                  Malformed{"ply", "a.ply", utf_16(ply, true, ""), utf_16_message},
                  Malformed{"stl", "a.stl", utf_16(stl, true, "\xff\xfe"), utf_16_message},
                  Malformed{"short_stl", "a.stl", utf_16("solid", false, ""), utf_16_message},
                  Malformed{"gltf", "a.gltf", utf_16(sample::gltf(), false, ""), utf_16_message}),
  [](const auto& info) { return info.param.name; });

} // namespace bad_input_test
