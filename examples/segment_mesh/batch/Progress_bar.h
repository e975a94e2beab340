// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_BAR_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_BAR_H

#include <chrono>
#include <condition_variable>
#include <iosfwd>
#include <mutex>
#include <string>
#include <thread>

namespace segment_mesh {

/// Whether stderr is a terminal.
bool is_terminal();

/// A line on a terminal that comes after a while of work, and goes at the end. A thread of its own
/// draws it, ten times a second: whoever works only says how far it is. For any number of threads.
class Progress_bar
{
public:
  /// On stderr, after a second.
  Progress_bar();
  Progress_bar(std::ostream& out, std::chrono::milliseconds delay);
  ~Progress_bar();

  /// `fraction` of what `words` say is done.
  void show(std::string words, double fraction);

  /// Calls `print()` while the line is not there.
  template <typename Print>
  void make_room(Print print)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    erase();
    print();
  }

private:
  void run(std::chrono::milliseconds delay);
  void draw();
  void erase();

  std::ostream& m_out;
  std::mutex m_mutex;
  std::condition_variable m_end;
  bool m_is_at_end = false;
  std::string m_words;
  double m_fraction = 0;
  std::string m_drawn; ///< what the line holds now
  std::thread m_thread;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROGRESS_BAR_H
