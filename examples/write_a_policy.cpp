// SPDX-License-Identifier: GPL-3.0-or-later
//
// User-defined data of regions, a cost, a policy and a chooser of the number: parts of a method of
// superfacets.

#include "example_mesh.h"

#include <CGAL/region_segmentation.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace RS = CGAL::Region_segmentation;

/// A model of `RegionData`: in addition to area and perimeter, the integral of the normal.
struct Region_with_normal : RS::Region_geometry
{
  RS::Double_3 area_vector{0, 0, 0};

  void add_face(const RS::Surface& surface, std::size_t face)
  {
    RS::Region_geometry::add_face(surface, face);
    area_vector = area_vector + surface.area(face) * surface.normal(face);
  }

  void absorb(const Region_with_normal& other, const RS::Section_geometry& between)
  {
    RS::Region_geometry::absorb(other, between);
    area_vector = area_vector + other.area_vector;
  }
};

/// A model of `GraphAnnotator`: sums over faces and adjacencies are in the graph already, nothing
/// is added.
struct Normal_annotator
{
  using RegionData = Region_with_normal;
  using SectionData = RS::Section_geometry;

  template <typename Graph>
  void operator()(Graph&, const RS::Surface&, const RS::Partition&, const RS::Region_rays&) const
  {}
};

/// A model of `SectionCost`: low between regions of similar normals, small ones, and across long
/// sections.
struct Normal_cost
{
  using RegionData = Region_with_normal; // what it reads: a method without these data does not
                                         // compile
  using SectionData = RS::Section_geometry;

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Region_with_normal &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    const double lengths = RS::norm(a.area_vector) * RS::norm(b.area_vector);
    const double cosine = lengths > 0 ? RS::dot(a.area_vector, b.area_vector) / lengths : 1;
    return (1.5 - cosine) * (std::min)(a.area, b.area) / graph[s].length;
  }
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

  const RS::Superfacet_merging by_cost{Normal_annotator(), RS::Lowest_cost_first(Normal_cost()),
                                       Largest_jump()};
  std::cout << RS::segment(mesh, segment_id, RS::parameters::method(by_cost))
            << " segments chosen by the costs\n";
  RS::Superfacet_merging by_policy{Normal_annotator(), Flattest_first(), Largest_jump()};
  by_policy.superfacets = RS::Superfacets(200);
  std::cout << RS::segment(mesh, segment_id,
                           RS::parameters::number_of_segments(10).method(by_policy))
            << " segments by a policy\n";
  write_colored(mesh, segment_id, "write_a_policy.ply");
}
