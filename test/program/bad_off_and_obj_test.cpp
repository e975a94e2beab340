// SPDX-License-Identifier: GPL-3.0-or-later

#include "bad_input.h"
#include "sample_files.h"

#include <gtest/gtest.h>

namespace bad_off_and_obj_test {

using sample::with;

class Bad_text : public testing::TestWithParam<Malformed>
{};

TEST_P(Bad_text, is_told_with_file_line_and_cause)
{
  expect_message(GetParam());
}

const std::string off = sample::off(), obj = sample::obj();

INSTANTIATE_TEST_SUITE_P(
  Off, Bad_text,
  testing::Values(
    Malformed{"empty", "a.off", "", ": is empty"},
    Malformed{"ending", "a.foo", off,
              ": unknown extension '.foo', not .off, .obj, .ply, .stl, .glb or .gltf"},
    Malformed{"header", "a.off", "hello\n", ":1: no OFF header, but 'hello'"},
    Malformed{"comments_only", "a.off", "# x\n# y\n", ":2: no OFF header, but ''"},
    Malformed{"binary", "a.off", "OFF BINARY\n", ":1: binary OFF is not supported"},
    Malformed{"dimension", "a.off", "nOFF\n3\n", ":1: no OFF header, but 'nOFF'"},
    Malformed{"count", "a.off", with(off, "4 4 0", "4 x 0"), ":2: 'x' is not a number of faces"},
    Malformed{"negative", "a.off", with(off, "4 4 0", "-4 4 0"),
              ":2: -4 is not a number of vertices"},
    Malformed{"huge", "a.off", with(off, "4 4 0", "4 99999999999999999999 0"),
              ":2: '99999999999999999999' is not a number of faces"},
    Malformed{"no_edges", "a.off", with(off, "4 4 0\n0 0 0", "4 4\n0.5 0 0"),
              ":3: '0.5' is not a number of edges"},
    Malformed{"short_header", "a.off", "OFF\n4",
              ":2: the file ends where the header has a number of faces"},
    Malformed{"no_faces", "a.off", "OFF\n1 0 0\n0 0 0\n", ":2: no faces"},
    Malformed{"cut_off", "a.off", off.substr(0, off.size() - 16),
              ":8: the header promises 4 faces, the file ends after 2 (each on a line of its own)"},
    Malformed{
      "cut_off_points", "a.off", "OFF\n4 4 0\n0 0 0\n",
      ":3: the header promises 4 vertices, the file ends after 1 (each on a line of its own)"},
    Malformed{"cut_off_line", "a.off", off.substr(0, off.size() - 3),
              ":10: a face with 2 of 3 indices"},
    Malformed{"carriage_returns", "a.off", "OFF # x\r4 4 0\r0 0 0\r",
              ": its lines end with carriage returns alone, not with line feeds"},
    Malformed{
      "vertices_on_a_line", "a.off", "OFF\n4 4 0\n0 0 0 1 0 0 0 1 0 0 0 1\n",
      ":3: the header promises 4 vertices, the file ends after 1 (each on a line of its own)"},
    Malformed{"faces_on_a_line", "a.off", with(off, "3 1 2 3\n", "3 1 2 3 "),
              ":9: the header promises 4 faces, the file ends after 3 (each on a line of its own)"},
    Malformed{"promises", "a.off", with(off, "4 4 0", "4 2000000000 0"),
              ":10: the header promises 2000000000 faces, the file ends after 4 (each on a line of "
              "its own)"},
    Malformed{"coordinate", "a.off", with(off, "1 0 0", "1 0"),
              ":4: a vertex with 2 of 3 coordinates"},
    Malformed{"text", "a.off", with(off, "1 0 0", "1 zero 0"), ":4: 'zero' is not a number"},
    Malformed{"nan", "a.off", with(off, "1 0 0", "1 nan 0"), ":4: 'nan' is not a finite number"},
    Malformed{"inf", "a.off", with(off, "1 0 0", "1 -inf 0"), ":4: '-inf' is not a finite number"},
    Malformed{"overflow", "a.off", with(off, "1 0 0", "1 1e999 0"),
              ":4: '1e999' is not a finite number"},
    Malformed{"infinity", "a.off",
              with(with(off, "OFF", "4OFF"), "0 0 0\n1 0 0", "0 0 0 1\n1 0 0 0"),
              ":4: a vertex at infinity: its fourth coordinate is 0"},
    Malformed{"homogeneous_overflow", "a.off",
              with(with(off, "OFF", "4OFF"), "0 0 0\n1 0 0", "0 0 0 1\n1e300 0 0 1e-300"),
              ":4: a vertex whose coordinates, divided by the fourth, are not finite numbers"},
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
  Obj, Bad_text,
  testing::Values(
    Malformed{"empty", "a.obj", "", ": is empty"},
    Malformed{"blank", "a.obj", "\n \n", ": no faces"},
    Malformed{"no_faces", "a.obj", "v 0 0 0\n", ": no faces"},
    Malformed{"text", "a.obj", "hello world\n", ":1: unknown statement 'hello'"},
    Malformed{"long_word", "a.obj", std::string(100, 'x') + "\n",
              ":1: unknown statement 'xxxxxxxxxxxxxxxxxxxxxxxx...'"},
    Malformed{"control", "a.obj", "\x1b[31m\n", ":1: unknown statement '?[31m'"},
    Malformed{"control_in_utf_8", "a.obj",
              "\xc2\x9b"
              "31m\n",
              ":1: unknown statement '?31m'"},
    Malformed{"control_in_8_bits", "a.obj",
              "\x9b"
              "31m\n",
              ":1: unknown statement '?31m'"},
    Malformed{"letters_in_utf_8", "a.obj", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x99\x82\xe4\n",
              ":1: unknown statement '\xc3\xa4\xe2\x82\xac\xf0\x9f\x99\x82\xe4'"},
    Malformed{"unknown_first", "a.obj", "v 0 0 0\nhello\nworld\n", ":2: unknown statement 'hello'"},
    Malformed{"continued", "a.obj", "v 0 0 \\\n 0\nv 0 \\\n x 0\n", ":4: 'x' is not a number"},
    Malformed{"cut_off", "a.obj", obj.substr(0, obj.size() - 3),
              ":8: a face with 2 vertices, fewer than 3"},
    Malformed{"coordinate", "a.obj", with(obj, "v 1 0 0", "v 1 0"),
              ":2: a vertex with 2 of 3 coordinates"},
    Malformed{"number", "a.obj", with(obj, "v 1 0 0", "v 1 0x1 0"), ":2: '0x1' is not a number"},
    Malformed{"nan", "a.obj", with(obj, "v 1 0 0", "v 1 NaN 0"),
              ":2: 'NaN' is not a finite number"},
    Malformed{"index", "a.obj", with(obj, "f 2 3 4", "f 2 3 5"),
              ":7: index 5 is out of range: there are 4 vertices, from 1"},
    Malformed{"zero", "a.obj", with(obj, "f 2 3 4", "f 2 3 0"),
              ":7: index 0 is out of range: there are 4 vertices, from 1"},
    Malformed{"negative", "a.obj", with(obj, "f 2 3 4", "f 2 3 -5"),
              ":7: index -5 is out of range: there are 4 vertices, from 1"},
    Malformed{"index_text", "a.obj", with(obj, "f 2 3 4", "f 2 3 x/1"),
              ":7: 'x' is not an index of a vertex"},
    Malformed{"edge", "a.obj", with(obj, "f 2 3 4", "f 2 3"),
              ":7: a face with 2 vertices, fewer than 3"}),
  [](const auto& info) { return info.param.name; });

} // namespace bad_off_and_obj_test
