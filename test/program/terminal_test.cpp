// SPDX-License-Identifier: GPL-3.0-or-later

// What the program shows at a terminal.

#include "Program.h"
#include "sample_files.h"

#include <chrono>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace terminal_test {

/// A terminal that this process is behind.
class Terminal
{
public:
  Terminal()
    : m_descriptor(posix_openpt(O_RDWR | O_NOCTTY))
  {
    if (m_descriptor < 0 || grantpt(m_descriptor) != 0 || unlockpt(m_descriptor) != 0)
      return;
    m_name = ptsname(m_descriptor);
    m_screen = open(m_name.c_str(), O_RDWR | O_NOCTTY); // else it is gone with the program, and
                                                        // what it shows with it
    fcntl(m_descriptor, F_SETFL, O_NONBLOCK);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal()
  {
    close(m_screen);
    close(m_descriptor);
  }

  bool is_there() const { return m_screen >= 0; }
  const std::string& name() const { return m_name; }

  /// All bytes that it was given.
  const std::string& bytes()
  {
    char block[4096];
    for (ssize_t size = read(m_descriptor, block, sizeof block); size > 0;
         size = read(m_descriptor, block, sizeof block))
      m_bytes.append(block, std::size_t(size));
    return m_bytes;
  }

private:
  int m_descriptor, m_screen = -1;
  std::string m_name, m_bytes;
};

class At_a_terminal : public Program
{
protected:
  void SetUp() override
  {
    folder.write("a.off", sample::off());
    if (!m_terminal.is_there() || mkfifo(folder.path("pipe").c_str(), 0600) != 0)
      GTEST_SKIP() << "no terminal can be made here";
  }

  /// What is shown by a run whose standard input comes after more than a second.
  std::string shown(const std::string& arguments)
  {
    std::thread input([&] {
      std::ofstream pipe(folder.path("pipe")); // when it is opened to be read
      std::this_thread::sleep_for(std::chrono::milliseconds(1200));
      pipe << sample::off();
    });
    const Outcome outcome = run(arguments + " --input-format off -k 1 < pipe > lines 2> '" +
                                m_terminal.name() + "'; exit $?; true");
    input.join();
    EXPECT_EQ(outcome.status, 0);
    return m_terminal.bytes();
  }

  Terminal m_terminal;
};

TEST_F(At_a_terminal, shows_the_stage_of_a_mesh)
{
  const std::string bytes = shown("- -o a.seg");
  const std::size_t size = bytes.find('\r');
  ASSERT_NE(size, std::string::npos) << bytes;
  EXPECT_TRUE(std::regex_match(bytes.substr(0, size), std::regex("\\[[#.]{40}\\] [a-z ]+")))
    << bytes;
  const std::string erased = "\r" + std::string(size, ' ') + "\r";
  EXPECT_EQ(bytes.substr(bytes.size() - erased.size()), erased) << "nothing is left";
  EXPECT_EQ(without_times(folder.read("lines")), "-: 4 faces, 4 regions, 1 segment\n");
}

TEST_F(At_a_terminal, shows_how_many_of_several_meshes_are_done)
{
  const std::string line = "[####################....................] 1/2 files";
  const std::string bytes = shown("a.off - --threads 1 -o '{stem}.seg'");
  EXPECT_NE(bytes.find(line), std::string::npos) << bytes;
  EXPECT_EQ(bytes.back(), '\r') << "nothing is left";
}

TEST_F(At_a_terminal, shows_nothing_of_short_work_and_where_it_is_to_be_quiet)
{
  EXPECT_EQ(shown("- -q"), "");
  EXPECT_EQ(run("a.off -o a.seg 2> '" + m_terminal.name() + "'; exit $?; true").status, 0);
  EXPECT_EQ(m_terminal.bytes(), "");
}

} // namespace terminal_test
