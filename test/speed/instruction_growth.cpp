// SPDX-License-Identifier: GPL-3.0-or-later

// Segments difficult shapes at two sizes, for callgrind, which counts and dumps each call by its
// name.

#include "shapes.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
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
void count_at_two_sizes(const std::string& name, Make_shape make, std::size_t faces,
                        const SegmentationMethod& method)
{
  count(name + " small", make(faces), method);
  count(name + " large", make(4 * faces), method);
}

constexpr std::size_t number_of_faces = 1600;

/// With the methods whose time is linear where thousands of components overlap; there `learned`
/// casts 12 rays of each up to 6,400 of them.
void count_without_rays(const std::string& name, Make_shape make)
{
  count_at_two_sizes(name + ", two-step", make, number_of_faces, RS::Two_step());
#ifdef TEST_EIGEN
  count_at_two_sizes(name + ", smooth-faces", make, number_of_faces, RS::Smooth_faces());
#endif
}

void count_with_each_method(const std::string& name, Make_shape make)
{
  count_without_rays(name, make);
  count_at_two_sizes(name + ", learned", make, number_of_faces, RS::Learned_merging());
}

} // namespace

int main()
{
  count_with_each_method("cone", shapes::cone);
  count_with_each_method("folded cone", shapes::folded_cone);
  count_with_each_method("star", shapes::star);
  count_without_rays("triangles at one edge", shapes::triangles_at_one_edge);
  // Fewer have too few sections at each region.
  count_without_rays("polygons on ten points",
                     [](std::size_t n) { return shapes::polygons_on_ten_points(4 * n); });
  count_with_each_method("tetrahedra", shapes::tetrahedra);
  count_with_each_method("folded strip", shapes::folded_strip);
  count_with_each_method("torus and far triangle", shapes::torus_and_far_triangle);
}
