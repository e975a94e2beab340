// SPDX-License-Identifier: GPL-3.0-or-later

// Segments difficult shapes at two sizes, for callgrind, which counts and dumps each call by its
// name.

#include "shapes.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#endif

#include <valgrind/callgrind.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
using shapes::Mesh;

template <typename SegmentationMethod>
void count(const std::string& name, const Mesh& mesh, const SegmentationMethod& method)
{
  std::vector<std::uint32_t> segments(num_faces(mesh));
  const auto map = boost::make_iterator_property_map(segments.begin(), get(CGAL::face_index, mesh));
  const auto np = RS::parameters::number_of_segments(8).method(method);
  CALLGRIND_START_INSTRUMENTATION;
  RS::segment(mesh, map, np);
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

using Make_shape = Mesh (*)(std::size_t);

template <typename SegmentationMethod>
void count_at_two_sizes(const std::string& name, Make_shape make, const SegmentationMethod& method)
{
  constexpr std::size_t faces = 2500;
  count(name + " small", make(faces), method);
  count(name + " large", make(4 * faces), method);
}

void count_with_each_method(const std::string& name, Make_shape make)
{
  count_at_two_sizes(name + ", two-step", make, RS::Two_step());
#ifdef TEST_EIGEN
  count_at_two_sizes(name + ", smooth-faces", make, RS::Smooth_faces());
#endif
  // Of thousands of overlapping components each casts 12 rays up to 6,400 of them: the time is
  // bounded, not linear.
  if (make != shapes::triangles_at_one_edge && make != shapes::slivers)
    count_at_two_sizes(name + ", learned", make, RS::Learned_merging());
}

} // namespace

int main()
{
  count_with_each_method("cone", shapes::cone);
  count_with_each_method("folded cone", shapes::folded_cone);
  count_with_each_method("star", shapes::star);
  count_with_each_method("triangles at one edge", shapes::triangles_at_one_edge);
  count_with_each_method("slivers", shapes::slivers);
  count_with_each_method("tetrahedra", shapes::tetrahedra);
  count_with_each_method("folded strip", shapes::folded_strip);
  count_with_each_method("torus and far triangle", shapes::torus_and_far_triangle);
}
