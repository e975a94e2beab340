// SPDX-License-Identifier: GPL-3.0-or-later

#include "Progress_bar.h"

#include <iostream>
#include <string>

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

Progress_bar::~Progress_bar()
{
  if (m_is_visible)
    std::cerr << '\r' << std::string(60, ' ') << '\r' << std::flush;
}

void Progress_bar::show(const char* stage, double fraction)
{
  const Clock::time_point now = Clock::now();
  if (now < m_next)
    return;
  m_next = now + std::chrono::milliseconds(100);
  m_is_visible = true;
  constexpr std::size_t width = 40;
  std::string bar(std::size_t(fraction * width), '#');
  bar.resize(width, '.');
  std::cerr << "\r[" << bar << "] " << stage << "   " << std::flush;
}

} // namespace segment_mesh
