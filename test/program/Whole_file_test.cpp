// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Whole_file.h"

#include "Temporary_folder.h"
#include "io/errors.h"

#include <gtest/gtest.h>

#include <csignal>

#include <unistd.h>

using namespace segment_mesh;

namespace {

TEST(Whole_file, leaves_the_old_file_until_it_is_complete)
{
  const Temporary_folder folder;
  const std::string file = folder.write("a.seg", "old");
  {
    Whole_file whole(file);
    whole.stream() << "new";
    EXPECT_EQ(folder.read("a.seg"), "old");
  }
  EXPECT_EQ(folder.read("a.seg"), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.seg"});
  Whole_file whole(file);
  whole.stream() << "new";
  whole.commit();
  EXPECT_EQ(folder.read("a.seg"), "new");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.seg"});
}

TEST(Whole_file, tells_file_and_cause)
{
  const Temporary_folder folder;
  const auto message = [](const std::string& file) -> std::string {
    try {
      Whole_file whole(file);
    } catch (const Output_error& error) {
      return error.what();
    }
    return "was opened";
  };
  EXPECT_EQ(message(folder.path("none/a.seg")),
            folder.path("none/a.seg") + ": cannot be opened: No such file or directory");
  std::filesystem::create_directory(folder.path("a.seg"));
  EXPECT_EQ(message(folder.path("a.seg")), folder.path("a.seg") + ": is a directory");
}

TEST(Whole_file, writes_through_a_symbolic_link)
{
  const Temporary_folder folder;
  folder.write("target.seg", "old");
  std::filesystem::create_symlink("target.seg", folder.path("link.seg"));
  Whole_file whole(folder.path("link.seg"));
  whole.stream() << "new";
  whole.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.seg")));
  EXPECT_EQ(folder.read("target.seg"), "new");
}

TEST(Whole_file, takes_over_what_a_killed_run_left)
{
  const Temporary_folder folder;
  folder.write(".a.seg.part", "much more than the new file has");
  Whole_file whole(folder.path("a.seg"));
  whole.stream() << "new";
  whole.commit();
  EXPECT_EQ(folder.read("a.seg"), "new");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.seg"});
}

TEST(Whole_file, is_for_one_writer_at_a_time)
{
  const Temporary_folder folder;
  const std::string file = folder.path("a.seg");
  {
    Whole_file first(file);
    try {
      Whole_file second(file);
      ADD_FAILURE() << "two write one file";
    } catch (const Output_error& error) {
      EXPECT_EQ(error.what(), file + ": is being written by another run");
    }
    first.stream() << "first";
    first.commit();
  }
  Whole_file second(file);
  second.stream() << "second";
  second.commit();
  EXPECT_EQ(folder.read("a.seg"), "second");
}

class Whole_file_on_signal : public testing::TestWithParam<int>
{
};

TEST_P(Whole_file_on_signal, leaves_nothing)
{
  const Temporary_folder folder;
  const std::string old = folder.write("a.seg", "old");
  const auto be_killed = [&] {
    Temporary_file::remove_all_on_signals();
    Whole_file first(old), second(folder.path("b.seg"));
    first.stream() << "half" << std::flush;
    if (!folder.has(".a.seg.part") || !folder.has(".b.seg.part"))
      std::_Exit(1);
    kill(getpid(), GetParam());
    for (;;)
      pause();
  };
  EXPECT_EXIT(be_killed(), testing::KilledBySignal(GetParam()), "");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.seg"});
  EXPECT_EQ(folder.read("a.seg"), "old");
}

INSTANTIATE_TEST_SUITE_P(Signals, Whole_file_on_signal, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(Whole_file, lives_on_where_a_signal_is_ignored)
{
  const Temporary_folder folder;
  const auto be_hung_up = [&] {
    std::signal(SIGHUP, SIG_IGN);
    Temporary_file::remove_all_on_signals();
    Whole_file whole(folder.path("a.seg"));
    kill(getpid(), SIGHUP);
    usleep(50000);
    whole.stream() << "new";
    whole.commit();
    std::_Exit(0);
  };
  EXPECT_EXIT(be_hung_up(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(folder.read("a.seg"), "new");
}

} // namespace
