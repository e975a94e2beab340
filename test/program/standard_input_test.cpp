// SPDX-License-Identifier: GPL-3.0-or-later

// The program on standard input, and on inputs whose endings do not name their format.

#include "Program.h"
#include "sample_files.h"

namespace standard_input_test {

using Standard_input = Program;

TEST_F(Standard_input, is_an_input)
{
  folder.write("a.off", sample::off());
  const Outcome outcome = run("- --input-format off -k 1 -o '{stem}.seg' < a.off");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(without_times(outcome.out), "-: 4 faces, 4 regions, 1 segment\n");
  EXPECT_EQ(folder.names(), (Names{"a.off", "stdin.seg"}));
  EXPECT_EQ(run("- --input-format ply < a.off").err, "-:1: no PLY header\n");
  EXPECT_EQ(run("- --input-format ply < /dev/null").err, "-: is empty\n");
}

TEST_F(Standard_input, may_come_through_a_pipe_and_be_one_of_several)
{
  folder.write("a.off", sample::off());
  folder.write("b.x", sample::off());
  const Outcome outcome = run("b.x - --input-format off -k 1", "gzip -c a.off |");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(without_times(outcome.out),
            "b.x: 4 faces, 4 regions, 1 segment\n-: 4 faces, 4 regions, 1 segment\n");
}

TEST_F(Standard_input, has_a_format_and_is_read_once)
{
  expect_wrong_usage("-", "-: standard input needs --input-format");
  expect_wrong_usage("- - --input-format off", "-: standard input can be read once");
  EXPECT_EQ(run("a.off --input-format xyz").status, 2);
}

TEST_F(Program, reads_compressed_files)
{
  folder.write("a.off", sample::off());
  ASSERT_EQ(std::system(("gzip '" + folder.path("a.off") + "'").c_str()), 0);
  const Outcome outcome = run("a.off.gz -k 1 -o '{stem}.seg'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(without_times(outcome.out), "a.off.gz: 4 faces, 4 regions, 1 segment\n");
  EXPECT_EQ(folder.names(), (Names{"a.off.gz", "a.seg"}));
}

} // namespace standard_input_test
