// SPDX-License-Identifier: GPL-3.0-or-later

#include "methods.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/mesh_segmentation.h>

#include <algorithm>
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

/// A method that cannot choose the number.
template <typename Segmentation_method>
Method merging_method(const Segmentation_method& method)
{
  return {[method](const Mesh& mesh, std::optional<std::size_t> wanted, std::vector<int>& labels) {
            return RS::segment(mesh, face_map(mesh, labels),
                               RS::parameters::method(method).number_of_segments(wanted.value()));
          },
          true, false};
}

template <typename Segmentation_method>
Method superfacet_method(std::size_t number_of_draws)
{
  Segmentation_method method;
  if (number_of_draws > 0)
    method.number_of_draws = number_of_draws;
  return {[method](const Mesh& mesh, std::optional<std::size_t> wanted, std::vector<int>& labels) {
            const auto map = face_map(mesh, labels);
            const auto parameters = RS::parameters::method(method);
            return wanted ? RS::segment(mesh, map, parameters.number_of_segments(*wanted))
                          : RS::segment(mesh, map, parameters);
          },
          true, true};
}

std::size_t segment_by_sdf(const Mesh& mesh, std::optional<std::size_t>, std::vector<int>& labels)
{
  std::vector<double> diameters(num_faces(mesh));
  const auto diameter_map = face_map(mesh, diameters);
  CGAL::sdf_values(mesh, diameter_map);
  return CGAL::segmentation_from_sdf_values(mesh, diameter_map, face_map(mesh, labels));
}

} // namespace

std::map<std::string, Method> methods(std::size_t number_of_draws)
{
  return {{"learned", superfacet_method<RS::Learned_merging>(number_of_draws)},
          {"visibility", superfacet_method<RS::Visibility_merging>(number_of_draws)},
          {"two-step", merging_method(RS::Two_step())},
          {"concave-angles", merging_method(Concave_angle_merging())},
          {"sdf", {segment_by_sdf, false, true}}};
}

} // namespace princeton_benchmark
