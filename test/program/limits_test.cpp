// SPDX-License-Identifier: GPL-3.0-or-later

// The program where address space or a reader of its lines is missing.

#include "Program.h"
#include "can_limit_memory.h"
#include "sample_files.h"

namespace limits_test {

class Limited_program : public Program
{
protected:
  void SetUp() override
  {
    for (const char* name : {"a.off", "b.off", "c.off"})
      folder.write(name, sample::off());
  }
};

TEST_F(Limited_program, tells_in_a_line_that_memory_is_short)
{
  if (!can_limit_memory)
    GTEST_SKIP() << "no limit on the address space with the address sanitizer";
  ASSERT_EQ(run("--demo -o figure.off").status, 0);
  int number_of_failed = 0;
  for (int megabytes = 8; megabytes < 60; ++megabytes) {
    const std::string limit = "ulimit -v " + std::to_string(1000 * megabytes) + " &&";
    // What the loader and the initializers of shared libraries do is not in the program's hands.
    if (run("--version", limit).status != 0)
      continue;
    const Outcome outcome = run("figure.off -k 3 --threads 4", limit);
    if (outcome.status == 0)
      continue;
    ++number_of_failed;
    EXPECT_EQ(outcome.status, 1) << megabytes << " MB: " << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1)
      << megabytes << " MB: " << outcome.err;
  }
  EXPECT_GT(number_of_failed, 0);
}

TEST_F(Limited_program, writes_outputs_when_its_reader_is_gone)
{
  const Outcome outcome = run(
    "a.off b.off c.off -k 1 -o '{stem}.seg' 2>messages; echo $? >status; } | true; true",
    "{ sleep 0.2;");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(folder.read("status"), "0\n");
  EXPECT_EQ(folder.read("messages"), "");
  for (const char* name : {"a.seg", "b.seg", "c.seg"})
    EXPECT_EQ(folder.read(name), "0\n0\n0\n0\n") << name;
}

} // namespace limits_test
