// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/Progress_bar.h"

#include <algorithm>
#include <iostream>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace segment_mesh {

bool is_terminal()
{
#if defined(__unix__) || defined(__APPLE__)
  return isatty(STDERR_FILENO) != 0;
#else
  return false;
#endif
}

Progress_bar::Progress_bar()
  : Progress_bar(std::cerr, std::chrono::seconds(1))
{}

Progress_bar::Progress_bar(std::ostream& out, std::chrono::milliseconds delay)
  : m_out(out)
  , m_thread([this, delay] { run(delay); })
{}

Progress_bar::~Progress_bar()
{
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_at_end = true;
  }
  m_end.notify_one();
  m_thread.join();
  erase();
}

void Progress_bar::show(std::string words, double fraction)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_words = std::move(words);
  m_fraction = fraction;
}

void Progress_bar::run(std::chrono::milliseconds delay)
{
  std::unique_lock<std::mutex> lock(m_mutex);
  const auto is_at_end = [this] { return m_is_at_end; };
  while (!m_end.wait_for(lock, delay, is_at_end)) {
    draw();
    delay = std::chrono::milliseconds(100);
  }
}

void Progress_bar::draw()
{
  if (m_words.empty())
    return;
  constexpr std::size_t width = 40;
  std::string bar(std::size_t((std::min)((std::max)(m_fraction, 0.0), 1.0) * width), '#');
  bar.resize(width, '.');
  const std::string line = "[" + bar + "] " + m_words;
  if (line == m_drawn)
    return;
  erase();
  m_out << line << std::flush;
  m_drawn = line;
}

void Progress_bar::erase()
{
  if (!m_drawn.empty())
    m_out << '\r' << std::string(m_drawn.size(), ' ') << '\r' << std::flush;
  m_drawn.clear();
}

} // namespace segment_mesh
