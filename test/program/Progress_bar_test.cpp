// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/Progress_bar.h"

#include <gtest/gtest.h>

#include <mutex>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <thread>

namespace Progress_bar_test {

using namespace segment_mesh;

constexpr std::chrono::milliseconds at_once(0);

/// What a terminal shows of one line with returns in it, without blanks at its end.
std::string shown(const std::string& bytes)
{
  std::string line;
  std::size_t column = 0;
  for (char c : bytes) {
    if (c == '\r') {
      column = 0;
      continue;
    }
    line.resize((std::max)(line.size(), column + 1), ' ');
    line[column++] = c;
  }
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// Bytes that one thread writes and another one looks at.
class Shared_bytes : public std::streambuf
{
public:
  std::string bytes() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_bytes;
  }

private:
  int_type overflow(int_type c) override
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_bytes += char(c);
    return c;
  }

  mutable std::mutex m_mutex;
  std::string m_bytes;
};

/// What is shown when `line` is, or after ten seconds.
std::string wait_for(const std::string& line, const Shared_bytes& bytes)
{
  for (int i = 0; i < 1000 && shown(bytes.bytes()) != line; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return shown(bytes.bytes());
}

TEST(Progress_bar, shows_the_last_words_and_goes)
{
  Shared_bytes bytes;
  std::ostream out(&bytes);
  {
    Progress_bar bar(out, at_once);
    const std::string first = "[##########..............................] a long name of a stage",
                      second = "[##############################..........] 3/4 files";
    bar.show("a long name of a stage", 0.25);
    EXPECT_EQ(wait_for(first, bytes), first);
    bar.show("3/4 files", 0.75);
    EXPECT_EQ(wait_for(second, bytes), second);
  }
  EXPECT_EQ(shown(bytes.bytes()), "");
}

TEST(Progress_bar, makes_room)
{
  Shared_bytes bytes;
  std::ostream out(&bytes);
  Progress_bar bar(out, at_once);
  const std::string line = "[########################################] words";
  bar.show("words", 1);
  ASSERT_EQ(wait_for(line, bytes), line);
  bar.make_room([&] { EXPECT_EQ(shown(bytes.bytes()), ""); });
  EXPECT_EQ(wait_for(line, bytes), line);
}

TEST(Progress_bar, is_not_there_for_short_work)
{
  std::ostringstream out;
  {
    Progress_bar bar(out, std::chrono::minutes(1));
    bar.show("words", 0.5);
  }
  EXPECT_EQ(out.str(), "");
}

} // namespace Progress_bar_test
