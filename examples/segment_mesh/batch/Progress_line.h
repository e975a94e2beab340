// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_LINE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_LINE_H

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace segment_mesh {

/// A line on stderr, if it is a terminal, that comes after a second of work and goes at the end.
class Progress_line
{
public:
  explicit Progress_line(bool is_wanted)
    : m_is_wanted(is_wanted && is_terminal())
  {}
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;
  ~Progress_line() { erase(); }

  /// Draws the line, ten times a second at most. `fraction` of what `words` say is done.
  void show(const std::string& words, double fraction)
  {
    const Clock::time_point now = Clock::now();
    if (!m_is_wanted || now < m_next)
      return;
    m_next = now + std::chrono::milliseconds(100);
    constexpr std::size_t width = 40;
    std::string bar(std::size_t((std::min)((std::max)(fraction, 0.0), 1.0) * width), '#');
    bar.resize(width, '.');
    erase();
    m_drawn = "[" + bar + "] " + words;
    std::cerr << m_drawn << std::flush;
  }

  void erase()
  {
    if (!m_drawn.empty())
      std::cerr << '\r' << std::string(m_drawn.size(), ' ') << '\r' << std::flush;
    m_drawn.clear();
  }

private:
  static bool is_terminal() // stderr
  {
#if defined(__unix__) || defined(__APPLE__)
    return isatty(STDERR_FILENO) != 0;
#else
    return false;
#endif
  }

  using Clock = std::chrono::steady_clock;

  bool m_is_wanted;
  Clock::time_point m_next = Clock::now() + std::chrono::seconds(1);
  std::string m_drawn; ///< what the line holds now
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_LINE_H
