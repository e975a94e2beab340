// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_BAR_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_BAR_H

#include <chrono>

namespace segment_mesh {

/// Whether stderr is a terminal.
bool is_terminal();

/// A line on stderr that comes after a second of work, and goes at the end.
class Progress_bar
{
public:
  ~Progress_bar();

  /// `fraction` of a stage is done.
  void show(const char* stage, double fraction);

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point m_next = Clock::now() + std::chrono::seconds(1);
  bool m_is_visible = false;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_BAR_H
