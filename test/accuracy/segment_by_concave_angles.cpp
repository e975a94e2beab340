// SPDX-License-Identifier: GPL-3.0-or-later

#include "segment_with.h"
#include "thread_seconds.h"

#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/Methods/Geometry_annotator.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Segmentation_method.h>
#include <CGAL/Region_segmentation/segment.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace princeton_benchmark {

namespace RS = CGAL::Region_segmentation;

namespace {

/// Each face is a region.
struct Single_faces
{
  RS::Partition operator()(const RS::Flat_mesh& mesh) const
  {
    std::vector<RS::Partition::Index> part_of(mesh.number_of_faces());
    std::iota(part_of.begin(), part_of.end(), RS::Partition::Index(0));
    return RS::Partition(std::move(part_of), mesh.number_of_faces());
  }
};

/// A model of `SectionData`.
struct Concave_section : RS::Section_geometry
{
  double concave = 0; ///< integral of the concave deviation along the section

  void add_edge(const RS::Flat_mesh& mesh, std::size_t lower_face, std::size_t edge)
  {
    RS::Section_geometry::add_edge(mesh, lower_face, edge);
    if (mesh.has_flag(edge, RS::Flat_mesh::CONCAVE))
      concave += mesh.length(edge) * mesh.deviation(lower_face, edge);
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

} // namespace

Timed_segmentation segment_by_concave_angles(const Benchmark_mesh& mesh, Wanted_number number)
{
  const auto method =
    RS::make_segmentation_method(Single_faces(), RS::Geometry_annotator<RS::Region_geometry, Concave_section>(),
                                 RS::Lowest_cost_first<Concave_angle_cost>());
  Timed_segmentation result;
  result.labels.resize(num_faces(mesh));
  const double start = thread_seconds();
  result.number_of_segments = RS::segment(mesh, face_map(mesh, result.labels),
                                          RS::parameters::method(method).number_of_segments(number.value()));
  result.seconds.merging = thread_seconds() - start;
  result.number_of_regions = num_faces(mesh);
  return result;
}

} // namespace princeton_benchmark
