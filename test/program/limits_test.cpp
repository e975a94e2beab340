// SPDX-License-Identifier: GPL-3.0-or-later

// The program where threads, address space or a reader of its lines are missing.

#include "Program.h"
#include "can_limit_memory.h"
#include "sample_files.h"

#include <unistd.h>

namespace limits_test {

class Limited_program : public Program
{
protected:
  void SetUp() override
  {
    for (const char* name : {"a.off", "b.off", "c.off"})
      folder.write(name, sample::off());
  }

  /// What to put before a call for at most `number` threads and processes of its user. The limit is
  /// not for root, so that its calls are made as a user who has no other processes.
  std::string limit_on_threads(int number) const
  {
    const std::string n = std::to_string(number);
    const std::string without_leaks = "export ASAN_OPTIONS=detect_leaks=0 && "; // to look for them takes a thread
    return without_counts() + without_leaks +
           (geteuid() != 0 ? "ulimit -u " + n + " && exec"
                           : "setpriv --reuid 2147480000 --clear-groups prlimit --nproc=" + n);
  }
};

const std::string rest = ".off: 4 faces, 4 regions, 1 segment\n";

TEST_F(Limited_program, does_with_the_threads_there_are)
{
  if (run("", limit_on_threads(1) + " test -x").status != 0)
    GTEST_SKIP() << "no limit on threads can be set here";
  for (int number = 1; number <= 5; ++number) {
    const Outcome outcome = run("a.off b.off c.off -k 1 --threads 4 --quiet", limit_on_threads(number));
    EXPECT_EQ(outcome.status, 0) << number << " threads: " << outcome.err;
    EXPECT_EQ(outcome.err, "") << number << " threads";
    EXPECT_EQ(without_times(outcome.out), "a" + rest + "b" + rest + "c" + rest);
  }
}

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
  const Outcome outcome =
    run("a.off b.off c.off -k 1 -o '{stem}.seg' 2>messages; echo $? >status; } | true; true",
        "{ sleep 0.2;");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(folder.read("status"), "0\n");
  EXPECT_EQ(folder.read("messages"), "");
  for (const char* name : {"a.seg", "b.seg", "c.seg"})
    EXPECT_EQ(folder.read(name), "0\n0\n0\n0\n") << name;
}

} // namespace limits_test
