// SPDX-License-Identifier: GPL-3.0-or-later

#include "bad_input.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bad_ply_and_stl_test {

using sample::with;

class Bad_data : public testing::TestWithParam<Malformed>
{};

TEST_P(Bad_data, is_told_with_file_line_and_cause)
{
  expect_message(GetParam());
}

const std::string ply = sample::ply(), stl = sample::stl();

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
  Ply, Bad_data,
  testing::Values(
    Malformed{"empty", "a.ply", "", ": is empty"},
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
              ":11: 128 is too large for its type"},
    Malformed{"no_z", "a.ply", with(ply, "float z", "float w"),
              ":3: a vertex needs the properties x, y and z, once each"},
    Malformed{"index_type", "a.ply", with(ply, "uchar int", "uchar float"),
              ":8: property vertex_indices is not a list of integers"},
    Malformed{"size_type", "a.ply", with(ply, "uchar int", "float int"),
              ":8: a list whose size is not an integer"},
    Malformed{"no_indices", "a.ply", with(ply, "vertex_indices", "corners"),
              ":7: a face needs the property vertex_indices, once"},
    Malformed{"no_properties", "a.ply",
              with(ply, "end_header", "element x 9999999999999\nend_header"),
              ":9: element 'x' has no properties"},
    Malformed{"no_faces", "a.ply", with(ply, "face 4", "face 0"), ": no faces"},
    Malformed{"nan", "a.ply", with(ply, "1 0 0", "1 nan 0"), ":11: 'nan' is not a finite number"},
    Malformed{"float", "a.ply", with(ply, "1 0 0", "1 1e99 0"),
              ":11: '1e99' is not a finite number as a float"},
    Malformed{"text", "a.ply", with(ply, "1 0 0", "1 O 0"), ":11: 'O' is not a number"},
    Malformed{"index", "a.ply", with(ply, "3 1 2 3", "3 1 2 4"),
              ":16: index 4 is out of range: there are 4 vertices, from 0"},
    Malformed{"edge", "a.ply", with(ply, "3 1 2 3", "2 1 2"),
              ":16: a face with 2 vertices, fewer than 3"},
    Malformed{"size", "a.ply", with(ply, "3 1 2 3", "300 1 2"),
              ":16: 300 is too large for its type"},
    Malformed{
      "negative_list", "a.ply",
      with(with(ply, "element face", "element x 1\nproperty list char int ids\nelement face"),
           "3 0 2 1", "-1\n3 0 2 1"),
      ":16: a list of -1 values"},
    Malformed{"negative_face", "a.ply",
              with(with(ply, "uchar int", "char int"), "3 1 2 3", "-3 1 2 3"),
              ":16: a face with -3 vertices, fewer than 3"},
    Malformed{"strips_alone_of_two", "a.ply",
              with(with(ply, "face 4", "tristrips 1"), "3 0 2 1", "4 0 2 -1 1"), ": no faces"},
    Malformed{
      "strip_index", "a.ply",
      with(with(with(ply, "face 4", "tristrips 1"), "uchar int", "char int"), "3 0 2 1", "3 0 2 4"),
      ":14: index 4 is out of range: there are 4 vertices, from 0"},
    Malformed{"strip_properties", "a.ply",
              with(with(ply, "face 4", "tristrips 1"), "vertex_indices", "corners"),
              ":7: triangle strips need the property vertex_indices, once"},
    Malformed{"promises", "a.ply", with(ply, "face 4", "face 5"),
              ":17: the header promises 5 items of element 'face', the file ends after 4"},
    Malformed{"cut_off", "a.ply", ply.substr(0, ply.size() - 6),
              ":17: the header promises 4 items of element 'face', the file ends after 3"},
    Malformed{"binary_cut_off", "a.ply", binary_ply().substr(0, binary_ply().size() - 1),
              ": the header promises 4 items of element 'face', the file ends after 3"},
    Malformed{"binary_promises", "a.ply", with(binary_ply(), "vertex 4", "vertex 4000000000"),
              ": the header promises 4000000000 items of element 'vertex', the file ends after 8"},
    Malformed{"binary_nan", "a.ply", patched_ply(16, std::nanf("")),
              ": vertex 1, from 0: y is not a finite number"},
    Malformed{"binary_index", "a.ply", patched_ply(62, 4),
              ": face 1, from 0: index 4 is out of range: there are 4 vertices, from 0"},
    Malformed{"binary_negative", "a.ply", patched_ply(62, -1),
              ": face 1, from 0: index -1 is out of range: there are 4 vertices, from 0"}),
  [](const auto& info) { return info.param.name; });

/// Of every type: where a value is cut off, as a coordinate, a size, an index and what is skipped.
TEST(Bad_binary_ply, tells_where_a_value_of_any_type_is_cut_off)
{
  const std::pair<const char*, std::size_t> types[] = {{"char", 1},   {"uchar", 1}, {"short", 2},
                                                       {"ushort", 2}, {"int", 4},   {"uint", 4},
                                                       {"float", 4},  {"double", 8}};
  const std::string start = "ply\nformat binary_little_endian 1.0\n";
  for (const auto& [type_, size] : types) {
    const std::string type = type_, end = "end_header\n",
                      corners = "element face 1\nproperty list ";
    const auto vertices = [](const std::string& of_type) {
      return "element vertex 3\nproperty " + of_type + " x\nproperty " + of_type + " y\nproperty " +
             of_type + " z\n";
    };
    expect_message({"coordinate", "a.ply",
                    start + vertices(type) + corners + "uchar int vertex_indices\n" + end +
                      std::string(6 * size + size - 1, '\0'),
                    ": the header promises 3 items of element 'vertex', the file ends after 2"});
    expect_message({"skipped", "a.ply",
                    start + "element x 2\nproperty " + type + " w\n" + vertices("char") + corners +
                      "uchar int vertex_indices\n" + end + std::string(2 * size - 1, '\0'),
                    ": the header promises 2 items of element 'x', the file ends after 1"});
    if (type == "float" || type == "double")
      continue;
    const std::string
      no_face = ": the header promises 1 item of element 'face', the file ends after 0";
    expect_message({"size", "a.ply",
                    start + vertices("char") + corners + type + " int vertex_indices\n" + end +
                      std::string(9 + size - 1, '\0'),
                    no_face});
    expect_message({"index", "a.ply",
                    start + vertices("char") + corners + "uchar " + type + " vertex_indices\n" +
                      end + std::string(9, '\0') + '\3' + std::string(3 * size - 1, '\0'),
                    no_face});
  }
}

INSTANTIATE_TEST_SUITE_P(
  Stl, Bad_data,
  testing::Values(
    Malformed{"empty", "a.stl", "", ": is empty"},
    Malformed{"text", "a.stl", "hello\n",
              ": neither a text that starts with 'solid' nor long enough for a binary STL"},
    Malformed{"no_faces", "a.stl", "solid\nendsolid\n", ": no faces"},
    Malformed{"word", "a.stl", with(stl, "facet", "faucet"),
              ":2: 'faucet' where 'facet' or 'endsolid' is due"},
    Malformed{"nan", "a.stl", with(stl, "vertex 0.000000", "vertex nan"),
              ":4: 'nan' is not a finite number"},
    Malformed{"number", "a.stl", with(stl, "vertex 0.000000", "vertex x"),
              ":4: 'x' is not a number"},
    Malformed{"edge", "a.stl", with(stl, "vertex", "comment"),
              ":8: a face with 2 vertices, fewer than 3"},
    Malformed{"square", "a.stl", with(stl, "endloop", "vertex 0 0 0 endloop"),
              ":7: a facet with more than 3 vertices"},
    Malformed{"solid_in_a_solid", "a.stl", with(stl, "facet", "solid inner\nfacet"),
              ":2: 'solid' where 'facet' or 'endsolid' is due"},
    Malformed{"facet_outside", "a.stl", stl + "facet\n", ":31: 'facet' where 'solid' is due"},
    Malformed{"end_outside", "a.stl", stl + "endsolid\n", ":31: 'endsolid' where 'solid' is due"},
    Malformed{"cut_off", "a.stl", stl.substr(0, stl.find("endfacet")),
              ":7: the file ends within a facet"},
    Malformed{"cut_off_end", "a.stl", stl.substr(0, stl.find("endsolid")),
              ":29: the file ends before 'endsolid'"},
    Malformed{"binary_cut_off", "a.stl", sample::binary_stl().substr(0, 200),
              ": the header promises 4 triangles, the file ends after 2"},
    Malformed{"binary_promises", "a.stl", patched(sample::binary_stl(), 80, 0, 0x7fffffff),
              ": the header promises 2147483647 triangles, the file ends after 4"},
    Malformed{"binary_empty", "a.stl", patched(sample::binary_stl(), 80, 0, 0), ": no faces"},
    Malformed{"binary_nan", "a.stl", patched(sample::binary_stl(), 84, 50 + 12, std::nanf("")),
              ": triangle 1, from 0, has a coordinate that is not a finite number"}),
  [](const auto& info) { return info.param.name; });

} // namespace bad_ply_and_stl_test
