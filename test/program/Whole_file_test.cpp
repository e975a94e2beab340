// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Whole_file.h"

#include "Temporary_folder.h"
#include "read/errors.h"

#include <gtest/gtest.h>

#include <fcntl.h>
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
            folder.path("none/a.seg") + ": cannot be written: No such file or directory");
  std::filesystem::create_directory(folder.path("a.seg"));
  EXPECT_EQ(message(folder.path("a.seg")), folder.path("a.seg") + ": is a directory");
  EXPECT_EQ(message("/dev/fd/999"), "/dev/fd/999: cannot be written: No such file or directory");
}

TEST(Whole_file, writes_directly_what_is_no_regular_file)
{
  const Temporary_folder folder;
  const std::string pipe = folder.path("pipe"), file = folder.write("a.seg", "old, ");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK),
            descriptor = open(file.c_str(), O_WRONLY | O_APPEND);
  for (const std::string& name : {pipe, "/dev/fd/" + std::to_string(descriptor)}) {
    EXPECT_TRUE(is_written_directly(name)) << name;
    Whole_file whole(name);
    whole.stream() << "new";
    whole.commit();
  }
  char bytes[10];
  EXPECT_EQ(read(reader, bytes, sizeof bytes), 3);
  EXPECT_EQ(folder.read("a.seg"), "old, new");
  close(reader);
  close(descriptor);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_TRUE(is_written_directly("-"));
  EXPECT_TRUE(is_written_directly("/dev/null"));
  EXPECT_FALSE(is_written_directly(file));
  EXPECT_FALSE(is_written_directly(folder.path("")));
  EXPECT_FALSE(is_written_directly("/dev/shm/none"));
}

TEST(Whole_file, tells_that_a_device_is_full)
{
  if (!std::filesystem::exists("/dev/full"))
    GTEST_SKIP() << "no /dev/full here";
  Whole_file whole("/dev/full");
  whole.stream() << "new";
  EXPECT_THROW(whole.commit(), Output_error);
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
    for (const std::string& name : folder.names()) // also before it takes its place
      EXPECT_EQ(permissions(folder.path(name)), mode);
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

} // namespace Whole_file_test
