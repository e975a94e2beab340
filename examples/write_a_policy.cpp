// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user-defined section cost and merging policy.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iostream>
#include <optional>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

/// A model of `SectionCost`: high for a deep and short section, and for one between large regions.
struct Notch_cost
{
  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const double smaller_area = (std::min)(graph[graph.source(s)].area, graph[graph.target(s)].area);
    return (CGAL_PI - graph[s].mean_angle()) * smaller_area / graph[s].length;
  }
};

/// A model of `RegionMergingPolicy`: the flattest section of all goes next. Its order does not depend on the wanted
/// number of segments, so `initialize()` does not take it.
struct Flattest_first
{
  template <typename Graph>
  void initialize(const Graph&) {}

  template <typename Graph>
  std::optional<RS::Merge_candidate> next(const Graph& graph) const
  {
    std::optional<RS::Merge_candidate> flattest;
    for (auto s : CGAL::make_range(edges(graph))) {
      const double bend = CGAL_PI - graph[s].mean_angle();
      // A section that holds a constrained edge is not mergeable, and must not be proposed.
      if (graph.is_mergeable(s) && (!flattest || bend < flattest->cost))
        flattest = RS::Merge_candidate{s, bend};
    }
    return flattest;
  }

  template <typename Graph>
  void on_merge(const Graph&, const typename Graph::Merge&) {}
};

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;

  RS::Region_growing growing;
  growing.maximum_angle = 5; // degrees
  const auto by_cost = RS::make_segmentation_method(growing, RS::Geometry_annotator<>(),
                                                    RS::Lowest_cost_first<Notch_cost>());
  std::cout << RS::segment(mesh, segment_id, RS::parameters::number_of_segments(3).method(by_cost))
            << " segments by a cost\n";
  const auto by_policy = by_cost.with_policy(Flattest_first());
  std::cout << RS::segment(mesh, segment_id, RS::parameters::number_of_segments(3).method(by_policy))
            << " segments by a policy\n";
}
