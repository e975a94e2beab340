// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_RUN_ON_MESH_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_RUN_ON_MESH_H

#include "Subject.h"
#include "seconds.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace speed_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Adds the triangles to an empty mesh. `add_point(mesh, p)` adds a vertex and returns it.
template <typename Mesh, typename AddPoint>
void fill_mesh(const Triangles& triangles, Mesh& mesh, AddPoint add_point)
{
  reserve(mesh, triangles.points.size(), triangles.corners.size() * 3 / 2,
          triangles.corners.size());
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertex_of, triangle(3);
  vertex_of.reserve(triangles.points.size());
  for (const Triangles::Point& p : triangles.points)
    vertex_of.push_back(add_point(mesh, p));
  for (const Triangles::Corners& t : triangles.corners) {
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = vertex_of[t[i]];
    if (CGAL::Euler::add_face(triangle, mesh) == boost::graph_traits<Mesh>::null_face())
      throw std::runtime_error("the triangles are no manifold");
  }
}

/// A method that tells the clock its number of regions.
template <typename Method>
struct Counting : Method
{
  Stage_clock* clock;

  Counting(const Method& method, Stage_clock& c)
    : Method(method)
    , clock(&c)
  {}

  auto prepare(const CGAL::Region_segmentation::Surface& surface, std::size_t number_of_segments,
               const CGAL::Region_segmentation::Execution& execution) const
  {
    auto prepared = Method::prepare(surface, number_of_segments, execution);
    clock->set_number_of_regions(prepared.regions.number_of_parts());
    return prepared;
  }
};

/// Implements `Base`, `Subject` or what derives from it, as far as it is the same for all mesh
/// types. Memory that the labels take is there before anything is timed or counted.
template <typename Mesh, typename Base = Subject>
class Mesh_subject : public Base
{
public:
  template <typename AddPoint>
  Mesh_subject(const Triangles& triangles, AddPoint add_point)
  {
    fill_mesh(triangles, m_mesh, add_point);
    m_segments.resize(num_faces(m_mesh));
  }

  std::size_t number_of_faces() const override { return num_faces(m_mesh); }

  /// The memory of the normals is there before, and free after: at a hundred million faces it would
  /// be a tenth of all.
  double seconds_of_face_normals() override
  {
    std::vector<Kernel::Vector_3> normals(num_faces(m_mesh));
    return seconds_of(Clock::PROCESSOR, [&] {
      CGAL::Polygon_mesh_processing::compute_face_normals(m_mesh, face_map(normals),
                                                          CGAL::parameters::geom_traits(Kernel()));
    });
  }

  Stage_seconds segment(const Pipeline& pipeline) override
  {
    using namespace CGAL::Region_segmentation;
    if (pipeline.method == Method::LEARNED)
      return segment_by(Learned_merging(), pipeline);
    Two_step method;
    if (pipeline.method == Method::REGIONS)
      method.feature_convexity = Feature_convexity::ALL;
    return segment_by(method, pipeline);
  }

protected:
  Mesh m_mesh;

  template <typename Value>
  auto face_map(std::vector<Value>& values) const
  {
    return boost::make_iterator_property_map(values.begin(), get(CGAL::face_index, m_mesh));
  }

private:
  template <typename SegmentationMethod>
  Stage_seconds segment_by(const SegmentationMethod& method, const Pipeline& pipeline)
  {
    using namespace CGAL::Region_segmentation;
    Stage_clock clock(pipeline.clock,
                      pipeline.method == Method::REGIONS ? Stage::GRAPH : Stage::BORDERS);
    const auto np = CGAL::Region_segmentation::parameters::number_of_segments(
                      pipeline.number_of_segments)
                      .method(Counting<SegmentationMethod>(method, clock))
                      .visitor(std::ref(clock));
    try {
#ifdef REGION_SEGMENTATION_BENCHMARK_PARALLEL
      if (pipeline.is_parallel)
        CGAL::Region_segmentation::segment<CGAL::Parallel_tag>(m_mesh, face_map(m_segments), np);
      else
#endif
        CGAL::Region_segmentation::segment(m_mesh, face_map(m_segments), np);
    } catch (const Segmentation_cancelled&) {
      // by the clock, after the last stage that is wanted
    }
    return clock.stop();
  }

  std::vector<std::uint32_t> m_segments;
};

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_RUN_ON_MESH_H
