// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_PROGRAM_H
#define CGAL_REGION_SEGMENTATION_TEST_PROGRAM_H

#include "Temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include <sys/wait.h>

/// One call of the program in a folder of its own.
class Program : public testing::Test
{
protected:
  struct Outcome
  {
    int status;
    std::string out, err;
  };

  Outcome run(const std::string& arguments, const std::string& before = "") const
  {
    const std::string command = "cd '" + folder.path("") + "' && " + before +
                                " '" SEGMENT_MESH "' " + arguments + " > out 2> err";
    const int status = std::system(command.c_str());
    const Outcome outcome = {WEXITSTATUS(status), folder.read("out"), folder.read("err")};
    std::filesystem::remove(folder.path("out"));
    std::filesystem::remove(folder.path("err"));
    return outcome;
  }

  void expect_wrong_usage(const std::string& arguments, const std::string& message) const
  {
    const std::vector<std::string> before = folder.names();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(outcome.err, "segment_mesh: " + message + " (see segment_mesh --help)\n")
      << arguments;
    EXPECT_EQ(folder.names(), before) << arguments;
  }

  /// Before a call that cannot write, or not all: where coverage is measured, its counts go to a
  /// folder of their own, since they would be reported, or damage those of the other calls.
  std::string without_counts() const
  {
    std::filesystem::permissions(m_counts.path(""), std::filesystem::perms::all); // the call may be
                                                                                  // that of another
                                                                                  // user
    return "export GCOV_PREFIX='" + m_counts.path("") + "' && ";
  }

  using Names = std::vector<std::string>;
  Temporary_folder folder;

private:
  const Temporary_folder m_counts;
};

/// Lines of the program without the times at their ends.
inline std::string without_times(const std::string& lines)
{
  return std::regex_replace(lines, std::regex(", [0-9]+\\.[0-9]{3} s\n"), "\n");
}

#endif // CGAL_REGION_SEGMENTATION_TEST_PROGRAM_H
