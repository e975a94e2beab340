// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor sees the progress, and cancels what takes too long; then no label is written.

#include "example_mesh.h"

#include <CGAL/region_segmentation.h>

#include <chrono>
#include <functional>

namespace RS = CGAL::Region_segmentation;
using Clock = std::chrono::steady_clock;

/// A model of `SegmentationVisitor`.
struct Time_limit
{
  Clock::time_point end;

  bool on_progress(const char* stage, double fraction)
  {
    std::cout << stage << ": " << 100 * fraction << " %\n";
    return Clock::now() < end;
  }
};

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  for (int seconds : {0, 60})
    try {
      Time_limit limit{Clock::now() + std::chrono::seconds(seconds)};
      RS::segment(mesh, segment_id, RS::parameters::visitor(std::ref(limit)));
      write_colored(mesh, segment_id, "watch_and_cancel.ply");
    } catch (const RS::Segmentation_cancelled& e) {
      std::cout << "after " << seconds << " s: " << e.what() << '\n';
    }
}
