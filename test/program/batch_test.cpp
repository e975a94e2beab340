// SPDX-License-Identifier: GPL-3.0-or-later

// The program on many inputs, and what is left when it is killed.

#include "Program.h"
#include "sample_files.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <random>

namespace batch_test {

std::vector<std::string> contents(const Temporary_folder& folder)
{
  std::vector<std::string> result;
  for (const std::string& name : folder.names())
    result.push_back(name + "\n" + folder.read(name));
  return result;
}

/// Twelve inputs, of which the first takes longest, one has a remark, one is bad and one is not
/// there.
std::string write_inputs(const Temporary_folder& folder)
{
  std::string names = "figure.off none.off";
  for (int i = 0; i < 10; ++i) {
    const std::string name = "m" + std::to_string(i) + (i == 5 ? ".obj" : ".off");
    folder.write(name, i == 3   ? sample::with(sample::off(), "3 1 2 3", "3 1 2 9")
                       : i == 5 ? "hello\n" + sample::obj()
                                : sample::off());
    names += " " + name;
  }
  return names;
}

TEST_F(Program, gives_the_same_by_any_number_of_threads)
{
  ASSERT_EQ(run("--demo -o figure.off").status, 0);
  const std::string inputs = write_inputs(folder) + " -k 3 -o '{stem}.seg' --threads ";
  const Outcome one = run(inputs + "1");
  const std::vector<std::string> files = contents(folder);
  EXPECT_EQ(one.status, 1);
  EXPECT_EQ(std::count(one.out.begin(), one.out.end(), '\n'), 10);
  EXPECT_EQ(std::count(one.err.begin(), one.err.end(), '\n'), 3) << one.err;
  EXPECT_EQ(one.out.rfind("figure.off", 0), 0u);
  for (const char* number : {"4", "0"}) {
    for (const std::string& name : folder.names())
      if (std::filesystem::path(name).extension() == ".seg")
        std::filesystem::remove(folder.path(name));
    const Outcome many = run(inputs + number);
    EXPECT_EQ(many.status, 1);
    EXPECT_EQ(without_times(many.out), without_times(one.out));
    EXPECT_EQ(many.err, one.err);
    EXPECT_EQ(contents(folder), files);
  }
}

class Killed_program : public Program
{
protected:
  /// Until six of the runs were killed.
  void kill_runs(const std::string& signal) const
  {
    const unsigned seed = std::random_device()();
    std::mt19937 random(seed);
    ASSERT_EQ(run("--demo -o figure.off").status, 0);
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(run(arguments).status, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
    std::uniform_real_distribution<double> moment(0.001, whole.count());
    int number_of_killed = 0;
    for (int i = 0; i < 200 && number_of_killed < 6; ++i) {
      const std::string seconds = std::to_string(moment(random));
      number_of_killed += run(arguments, "timeout -s " + signal + " " + seconds).status != 0;
      check(seed);
    }
    EXPECT_EQ(number_of_killed, 6) << "seed " << seed;
  }

  /// Outputs are whole or not there.
  void check(unsigned seed) const
  {
    for (const std::string& name : outputs) {
      if (!folder.has(name))
        continue;
      const std::string text = folder.read(name);
      EXPECT_TRUE(nlohmann::json::accept(text)) << "seed " << seed;
      std::filesystem::remove(folder.path(name));
    }
  }

  const Names outputs = {"a.json", "b.json", "c.json"};
  const std::string arguments = "figure.off -k 10 --method two-step -o a.json -o b.json -o c.json";
};

TEST_F(Killed_program, leaves_outputs_that_are_whole)
{
  for (const char* signal : {"TERM", "KILL"})
    kill_runs(signal);
}

} // namespace batch_test
