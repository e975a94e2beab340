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

TEST_F(Standard_input, is_read_in_blocks)
{
  constexpr std::size_t block = std::size_t(1) << 20;
  for (const std::size_t size : {block - 1, block, block + 1, 2 * block}) {
    const std::string mesh = sample::off();
    folder.write("a.off", mesh + "#" + std::string(size - mesh.size() - 1, 'x'));
    const Outcome outcome = run("- --input-format off -k 1 < a.off");
    EXPECT_EQ(without_times(outcome.out), "-: 4 faces, 4 regions, 1 segment\n") << size;
  }
  folder.write("a.off",
               sample::with(sample::off(), "0 0 1\n", "0 0 1\n#" + std::string(block, 'x') + "\n"));
  EXPECT_EQ(without_times(run("- --input-format off -k 1 < a.off").out),
            "-: 4 faces, 4 regions, 1 segment\n");
  const Outcome folder_outcome = run("- --input-format off < .");
  EXPECT_EQ(folder_outcome.status, 1);
  EXPECT_EQ(folder_outcome.err, "-: cannot be read: Is a directory\n");
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
