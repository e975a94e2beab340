// SPDX-License-Identifier: GPL-3.0-or-later

// Segments meshes that are made here, for callgrind, which counts and dumps each call by its name.

#include "make_mesh.h"
#include "make_triangles.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/segment.h>

#include <valgrind/callgrind.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>

namespace {

namespace RS = CGAL::Region_segmentation;
using speed_benchmark::make_mesh;
using speed_benchmark::Mesh;

/// \returns whether there are 8 segments
template <typename SegmentationMethod>
bool count(const char* name, const Mesh& mesh, const SegmentationMethod& method)
{
  std::vector<std::uint32_t> segments(num_faces(mesh));
  const auto map = boost::make_iterator_property_map(segments.begin(), get(CGAL::face_index, mesh));
  const auto np = RS::parameters::number_of_segments(8).method(method);
  CALLGRIND_START_INSTRUMENTATION;
  const std::size_t number = RS::segment(mesh, map, np);
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT(name);
  std::cout << name << ": " << number << " segments\n";
  return number == 8;
}

} // namespace

int main()
{
  // 20,000 faces with the creases of 1,250; and with a crease at every edge.
  const auto torus = subdivided(subdivided(speed_benchmark::wavy_torus(1250)));
  const Mesh smooth = make_mesh(torus), noisy = make_mesh(roughened(torus, 0.2));
  const bool is_right = count("two-step smooth", smooth, RS::Two_step()) &
                        count("two-step noisy", noisy, RS::Two_step()) &
                        count("visibility smooth", smooth, RS::Visibility_merging()) &
                        count("learned smooth", smooth, RS::Learned_merging());
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
