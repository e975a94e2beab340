// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Whole_file.h"

#include "Temporary_folder.h"
#include "io/errors.h"

#include <gtest/gtest.h>

#include <csignal>

#include <sys/stat.h>
#include <unistd.h>

namespace Whole_file_test {

using namespace segment_mesh;

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
  ASSERT_EQ(mkfifo(folder.path("b.seg").c_str(), 0600), 0);
  EXPECT_EQ(message(folder.path("b.seg")), folder.path("b.seg") + ": is not a regular file");
  std::filesystem::create_symlink("loop.seg", folder.path("loop.seg"));
  EXPECT_EQ(message(folder.path("loop.seg")), folder.path("loop.seg") + ": is a symbolic link that leads to itself");
}

TEST(Whole_file, takes_single_characters)
{
  const Temporary_folder folder;
  Whole_file whole(folder.path("a.seg"));
  whole.stream().put('a').put('\xff').put('\0') << 'b' << std::flush;
  whole.commit();
  EXPECT_EQ(folder.read("a.seg"), std::string("a\xff\0b", 4));
}

TEST(Whole_file, tells_why_it_cannot_take_its_place)
{
  const Temporary_folder folder;
  Whole_file whole(folder.path("a.seg"));
  std::filesystem::create_directory(folder.path("a.seg"));
  try {
    whole.commit();
    FAIL() << "a folder was replaced";
  } catch (const Output_error& error) {
    EXPECT_EQ(error.what(), folder.path("a.seg") + ": cannot be written: Is a directory");
  }
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

TEST(Whole_file, writes_to_where_a_symbolic_link_leads_though_nothing_is_there)
{
  const Temporary_folder folder;
  std::filesystem::create_directory(folder.path("other"));
  std::filesystem::create_symlink("second.seg", folder.path("first.seg"));
  std::filesystem::create_symlink("other/target.seg", folder.path("second.seg"));
  const mode_t before = umask(022);
  Whole_file whole(folder.path("first.seg"));
  whole.stream() << "new";
  whole.commit();
  umask(before);
  EXPECT_EQ(folder.read("other/target.seg"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("first.seg")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("second.seg")));
  EXPECT_EQ(std::filesystem::status(folder.path("other/target.seg")).permissions(), std::filesystem::perms(0644));

  std::filesystem::create_symlink("loop.seg", folder.path("loop.seg"));
  EXPECT_THROW(Whole_file(folder.path("loop.seg")), Output_error);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("loop.seg")));
}

TEST(Whole_file, writes_names_of_any_legal_length)
{
  const Temporary_folder folder;
  const std::string name(255, 'a');
  Whole_file whole(folder.path(name));
  whole.stream() << "new";
  whole.commit();
  EXPECT_EQ(folder.read(name), "new");
}

TEST(Whole_file, of_two_writers_leaves_the_last)
{
  const Temporary_folder folder;
  Whole_file first(folder.path("a.seg")), second(folder.path("a.seg"));
  first.stream() << "first, and longer";
  second.stream() << "second";
  first.commit();
  EXPECT_EQ(folder.read("a.seg"), "first, and longer");
  second.commit();
  EXPECT_EQ(folder.read("a.seg"), "second");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.seg"});
}

std::filesystem::perms permissions(const std::string& file)
{
  return std::filesystem::status(file).permissions();
}

TEST(Whole_file, keeps_the_permissions_of_what_it_replaces)
{
  using std::filesystem::perms;
  const Temporary_folder folder;
  for (const perms mode : {perms(0600), perms(0640), perms(0444), perms(0755)}) {
    const std::string file = folder.write("a.seg", "old");
    std::filesystem::permissions(file, mode);
    Whole_file whole(file);
    whole.stream() << "new";
    const std::vector<std::string> temporary = folder.temporary_names("a.seg");
    ASSERT_EQ(temporary.size(), 1u);
    EXPECT_EQ(permissions(folder.path(temporary[0])), perms(0600));
    whole.commit();
    EXPECT_EQ(folder.read("a.seg"), "new");
    EXPECT_EQ(permissions(file), mode);
    std::filesystem::remove(file);
  }
}

TEST(Whole_file, leaves_the_permissions_of_a_new_file_to_the_umask)
{
  const Temporary_folder folder;
  const mode_t before = umask(027);
  Whole_file whole(folder.path("a.seg"));
  whole.commit();
  umask(before);
  EXPECT_EQ(permissions(folder.path("a.seg")), std::filesystem::perms(0640));
}

TEST(Temporary_file, of_a_killed_run_is_removed)
{
  const Temporary_folder folder;
  folder.write(".a.seg.0123456789abcdef.part", "left");
  const std::vector<std::string> others = {".a.seg.part", ".b.seg.0123456789abcdef.part",
                                           ".a.seg.0123456789abcdeX.part", "a.seg"};
  for (const std::string& name : others)
    folder.write(name, "not left by this target");
  std::filesystem::create_symlink("a.seg", folder.path(".a.seg.aaaaaaaaaaaaaaaa.part"));
  mkfifo(folder.path(".a.seg.bbbbbbbbbbbbbbbb.part").c_str(), 0600);
  const std::size_t before = folder.names().size();
  {
    const Temporary_file in_work(folder.path("a.seg"));
    Temporary_file::remove_leftovers(folder.path(""), {"a.seg"});
    EXPECT_EQ(folder.names().size(), before); // one more, one less
    EXPECT_FALSE(folder.has(".a.seg.0123456789abcdef.part"));
  }
  EXPECT_EQ(folder.names().size(), before - 1);
}

TEST(Temporary_file, of_another_user_stays)
{
  const Temporary_folder folder;
  const std::string name = ".a.seg.0123456789abcdef.part", file = folder.write(name, "left");
  if (chown(file.c_str(), geteuid() + 1, gid_t(-1)) != 0)
    GTEST_SKIP() << "this user cannot give files away";
  Temporary_file::remove_leftovers(folder.path(""), {"a.seg"});
  EXPECT_TRUE(folder.has(name));
  ASSERT_EQ(chown(file.c_str(), geteuid(), gid_t(-1)), 0);
  Temporary_file::remove_leftovers(folder.path(""), {"a.seg"});
  EXPECT_FALSE(folder.has(name));
}

TEST(Temporary_file, of_a_segment_is_removed_whatever_its_number)
{
  const Temporary_folder folder;
  const std::string digits = ".0123456789abcdef.part";
  for (const char* name : {".part_0.ply", ".part_31.ply", ".part_31_of_31.ply", ".x31.ply"})
    folder.write(name + digits, "left");
  const std::vector<std::string> others = {".part_.ply" + digits, ".part_x.ply" + digits, ".part_3.plyx" + digits,
                                           ".part_31_of_30.ply" + digits, ".other_3.ply" + digits, ".x1.ply" + digits};
  for (const std::string& name : others)
    folder.write(name, "of another target");
  Temporary_file::remove_leftovers(folder.path(""), {"part_{segment}.ply", "part_{segment}_of_{segment}.ply", "x{segment}1.ply"});
  EXPECT_EQ(folder.names().size(), others.size());
  for (const std::string& name : others)
    EXPECT_TRUE(folder.has(name)) << name;
}

class Whole_file_on_signal : public testing::TestWithParam<int>
{
};

TEST_P(Whole_file_on_signal, leaves_nothing)
{
  const Temporary_folder folder;
  const std::string old = folder.write("a.seg", "old");
  const auto be_killed = [&] {
    std::signal(GetParam(), SIG_DFL); // a shell lets what it runs in the background ignore some
    Temporary_file::remove_all_on_signals();
    Whole_file first(old), second(folder.path("b.seg"));
    first.stream() << "half" << std::flush;
    if (folder.temporary_names("a.seg").empty() || folder.temporary_names("b.seg").empty())
      std::_Exit(1);
    kill(getpid(), GetParam());
    for (;;)
      pause();
  };
  EXPECT_EXIT(be_killed(), testing::KilledBySignal(GetParam()), "");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a.seg"});
  EXPECT_EQ(folder.read("a.seg"), "old");
}

INSTANTIATE_TEST_SUITE_P(Signals, Whole_file_on_signal,
                         testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM,
                                         SIGUSR1, SIGUSR2));

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

} // namespace Whole_file_test
