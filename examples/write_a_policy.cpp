// SPDX-License-Identifier: GPL-3.0-or-later
//
// A policy and a chooser of the number of one's own: parts of a method of superfacets. (The example
// scalar.cpp has data and a cost of one's own.)

#include "example_mesh.h"

#include <CGAL/region_segmentation.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace RS = CGAL::Region_segmentation;

/// A model of `GraphAnnotator` that adds nothing: sums over faces and adjacencies are in the graph
/// already.
struct No_annotation
{
  using RegionData = RS::Region_geometry;
  using SectionData = RS::Section_geometry;

  template <typename Graph>
  void operator()(Graph&, const RS::Surface&, const RS::Partition&, const RS::Region_rays&) const
  {}
};

/// A model of `MergingPolicy`: the flattest section of all goes next, whatever the wanted number of
/// segments is.
struct Flattest_first
{
  template <typename Graph>
  void initialize(const Graph&)
  {}

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
  void on_merge(const Graph&, const typename Graph::Merge&)
  {}
};

/// A model of `NumberChooser`: the number before the merge, among the last ones, whose cost exceeds
/// all before it by the largest factor.
struct Largest_jump
{
  std::size_t largest_number = 20;

  std::size_t operator()(const RS::Merge_tree& tree, const RS::Surface&) const
  {
    std::size_t left = tree.number_of_regions(), number = left - tree.merges().size();
    double highest = 0, largest_factor = 1;
    for (const auto& merge : tree.merges()) {
      if (left <= largest_number && merge.cost > largest_factor * highest) {
        largest_factor = merge.cost / highest;
        number = left;
      }
      highest = (std::max)(highest, merge.cost);
      --left;
    }
    return number;
  }
};

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;

  RS::Superfacet_merging method{No_annotation(), Flattest_first(), Largest_jump()};
  method.superfacets = RS::Superfacets(200);
  std::cout << RS::segment(mesh, segment_id, RS::parameters::method(method))
            << " segments chosen by the costs\n";
  std::cout << RS::segment(mesh, segment_id, RS::parameters::number_of_segments(10).method(method))
            << " segments asked for\n";
  write_colored(mesh, segment_id, "write_a_policy.ply");
}
