// SPDX-License-Identifier: GPL-3.0-or-later

#include "segment_with.h"
#include "thread_seconds.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/segment.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace princeton_benchmark {

namespace RS = CGAL::Region_segmentation;

namespace {

/// A model of `SectionData`.
struct Concave_section : RS::Section_geometry
{
  double concave = 0; ///< integral of the concave deviation along the section

  void add_adjacency(const RS::Surface& surface, std::size_t a)
  {
    RS::Section_geometry::add_adjacency(surface, a);
    if (surface.has_flag(a, RS::Surface::CONCAVE))
      concave += surface.length(a) * surface.deviation(a);
  }

  void absorb(const Concave_section& other)
  {
    RS::Section_geometry::absorb(other);
    concave += other.concave;
  }
};

/// min(area) * (integral of the angle) / length^2.
struct Concave_angle_cost
{
  using RegionData = RS::Region_geometry;
  using SectionData = Concave_section;

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const double area = std::min(graph[graph.source(s)].area, graph[graph.target(s)].area);
    const double length = graph[s].length;
    return length > 0 ? area * graph[s].concave / (length * length) : 0;
  }
};

/// Each face is a region.
struct Concave_angle_merging
{
  struct Prepared
  {};

  Prepared prepare(const RS::Surface&, std::size_t, const RS::Execution&) const { return {}; }

  RS::Hierarchy merge(const RS::Surface& surface, const Prepared&, const RS::Request& request,
                      const RS::Execution& execution) const
  {
    RS::Requested_regions requested = RS::requested_regions(
      surface, RS::Partition::into_single_elements(surface.number_of_faces()), request.seeds);
    auto graph = RS::build_region_adjacency_graph<RS::Region_geometry, Concave_section>(
      surface, requested.regions);
    RS::Merge_tree tree = RS::merge_requested_regions(surface, requested, graph,
                                                      RS::Lowest_cost_first<Concave_angle_cost>(),
                                                      1, execution.stage("merging"));
    return RS::Hierarchy(std::move(requested.regions), std::move(tree), request.number_of_segments);
  }
};

} // namespace

Timed_segmentation segment_by_concave_angles(const Benchmark_mesh& mesh, Wanted_number number)
{
  Timed_segmentation result;
  result.labels.resize(num_faces(mesh));
  const double start = thread_seconds();
  result.number_of_segments = RS::segment(
    mesh, face_map(mesh, result.labels),
    RS::parameters::method(Concave_angle_merging()).number_of_segments(number.value()));
  result.seconds.merging = thread_seconds() - start;
  result.number_of_regions = num_faces(mesh);
  return result;
}

} // namespace princeton_benchmark
