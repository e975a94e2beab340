// SPDX-License-Identifier: GPL-3.0-or-later

// Hostile input: every row of the table is run.

#include "Program.h"
#include "sample_files.h"

#include <zlib.h>

#include <algorithm>
#include <ostream>

#include <sys/stat.h>

namespace hostile_input_test {

using sample::with;

/// A row of the table. The program is run as `segment_mesh FILE -k 1 -o a.seg`, and what it does is
/// compared with words that the row has in quotes.
struct Row
{
  const char* given;
  const char* happens;
  const char* file;
  std::string bytes;
  std::size_t labels; ///< 0: the file is refused
};

std::ostream& operator<<(std::ostream& out, const Row& row)
{
  return out << row.given;
}

std::string off_of(const std::string& points, const std::string& faces)
{
  const auto lines = [](const std::string& text) {
    return std::to_string(std::count(text.begin(), text.end(), '\n'));
  };
  return "OFF\n" + lines(points) + " " + lines(faces) + " 0\n" + points + faces;
}

std::string gzip(const std::string& bytes)
{
  const Temporary_folder folder;
  const gzFile file = gzopen(folder.path("a").c_str(), "wb");
  gzwrite(file, bytes.data(), unsigned(bytes.size()));
  gzclose(file);
  return folder.read("a");
}

const std::string off = sample::off(), obj = sample::obj(), ply = sample::ply();
const std::string binary_ply = sample::binary_ply("binary_little_endian");
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

const std::vector<Row> rows = {
  {"no bytes", "refused: `is empty`", "a.obj", "", 0},
  {"no faces", "refused: `no faces`", "a.obj", "v 0 0 0\n", 0},
  {"a header that promises more than the file holds",
   "refused: `the header promises` n, `the file ends after` m; no memory is reserved for n",
   "a.ply", with(binary_ply, "face 4", "face 4000000000"), 0},
  {"an OFF, PLY or binary STL file that holds more than its header promises",
   "the rest is `not read`, with a remark", "a.ply", ply + "3 0 1 2\n", 4},
  {"a file that is cut off within an item", "refused, with the line: `a face with 2 of 3 indices`",
   "a.off", off.substr(0, off.size() - 3), 0},
  {"an index that is negative or too large",
   "refused, with the line: `is out of range: there are` n vertices", "a.off",
   with(off, "3 1 2 3", "3 1 2 9"), 0},
  {"a coordinate that is not finite: nan, 1e999",
   "refused, with the line: `is not a finite number`", "a.off", with(off, "1 0 0", "1 1e999 0"), 0},
  {"a coordinate that is not a number", "refused, with the line: `is not a number`", "a.off",
   with(off, "1 0 0", "1 zero 0"), 0},
  {"coordinates near the least and the largest double", "segmented as any others", "a.off",
   off_of("0 0 0\n1e308 0 0\n0 -1e308 1e-320\n0 0 1e308\n", "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"),
   4},
  {"a face of two corners", "refused, with the line: `a face with 2 vertices, fewer than 3`",
   "a.off", with(off, "3 1 2 3", "2 1 2"), 0},
  {"a PLY list of negative size", "refused, with the line: `a list of -1 values`", "a.ply",
   with(with(ply, "element face", "element x 1\nproperty list char int ids\nelement face"),
        "3 0 2 1", "-1\n3 0 2 1"),
   0},
  {"a PLY element without properties", "refused, with the line: `has no properties`", "a.ply",
   with(ply, "end_header", "element x 9\nend_header"), 0},
  {"a statement that OBJ does not have", "`skipped`, with a remark on the `unknown statement`",
   "a.obj", "hello\n" + obj, 4},
  {"bytes that control a terminal", "`?` in messages, which stay on their line", "a.obj",
   "\x1b[31m\n", 0},
  {"a gzip file that is cut off or damaged", "refused: `is a gzip file that is cut off`", "a.off",
   gzip(off).substr(0, 50), 0},
  {"a gzip file that would grow without bound",
   "refused: `is a gzip file that grows by more than 100 times`", "a.off",
   gzip(std::string(200000000, '0')), 0},
  {"faces of different orientation", "segmented: neighbors are oriented alike", "a.off",
   with(off, "3 1 2 3", "3 1 3 2"), 4},
  {"three faces at an edge", "segmented: each two that follow each other around it are adjacent",
   "a.off", off_of(square + "1 0 1\n2 0 0\n", "3 0 1 3\n3 1 0 4\n3 0 1 5\n"), 3},
  {"two parts of the surface that meet in a point", "segmented: they are adjacent there", "a.off",
   off_of(square + "2 2 0\n", "3 0 1 2\n3 2 3 4\n"), 2},
  {"a face that is there twice", "segmented: the copy has the label of the other", "a.off",
   off_of(square, "3 0 1 2\n3 0 2 3\n3 2 0 1\n"), 3},
  {"a polygon that visits a vertex twice", "segmented", "a.off",
   off_of(square + "2 2 0\n3 2 0\n", "6 0 1 2 4 5 2\n"), 1},
  {"faces without area alone", "segmented", "a.off", off_of(square, "3 0 1 0\n"), 1},
  {"all points at one place", "segmented: the faces have no area and no normal", "a.off",
   with(with(with(off, "1 0 0", "0 0 0"), "0 1 0", "0 0 0"), "0 0 1", "0 0 0"), 4},
  {"points that no face uses", "no effect", "a.off",
   off_of(square + "1e300 0 0\n", "3 0 1 2\n3 0 2 3\n"), 2},
  {"points of an STL file that are equal", "merged, as usual", "a.stl", sample::stl(), 4},
};

class Hostile_input : public Program, public testing::WithParamInterface<Row>
{};

/// The parts of a text that are in backquotes.
std::vector<std::string> quotes_of(const std::string& text)
{
  std::vector<std::string> result;
  for (std::size_t start = text.find('`'); start != std::string::npos;) {
    const std::size_t end = text.find('`', start + 1);
    result.push_back(text.substr(start + 1, end - start - 1));
    start = text.find('`', end + 1);
  }
  return result;
}

TEST_P(Hostile_input, is_dealt_with_as_the_manual_says)
{
  const Row& row = GetParam();
  folder.write(row.file, row.bytes);
  const Outcome outcome = run(std::string(row.file) + " -k 1 -o a.seg");
  EXPECT_EQ(outcome.status, row.labels > 0 ? 0 : 1) << outcome.err;
  EXPECT_LE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  const std::string labels = row.labels > 0 ? folder.read("a.seg") : "";
  EXPECT_EQ(std::size_t(std::count(labels.begin(), labels.end(), '\n')), row.labels);

  const std::string happens = row.happens;
  const bool has_word = happens.find("refused") == 0 ||
                        happens.find("remark") != std::string::npos || happens[0] == '`';
  EXPECT_EQ(outcome.err.empty(), !has_word) << outcome.err;
  for (const std::string& quote : quotes_of(happens))
    EXPECT_NE(outcome.err.find(quote), std::string::npos) << quote << "\n" << outcome.err;
  const bool needs_line = happens.find("with the line") != std::string::npos;
  EXPECT_TRUE(!needs_line || std::regex_search(outcome.err, std::regex("^[^ ]*:[0-9]+: ")))
    << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(Table, Hostile_input, testing::ValuesIn(rows));

} // namespace hostile_input_test
