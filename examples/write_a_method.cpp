// SPDX-License-Identifier: GPL-3.0-or-later
//
// A method of one's own: what does not depend on wishes in prepare(), the rest in merge(). It has a
// number that it chooses, constraints, seeds, links and a Segmenter like those of the package.

#include "example_mesh.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/Number_below_cost.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>
#include <CGAL/Region_segmentation/segment.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace RS = CGAL::Region_segmentation;

/// A model of `SegmentationMethod`: facets between all edges of more than 2 degrees, those across
/// long and flat borders merged first, small ones before large ones.
struct Facet_merging
{
  double maximum_angle = 2;   // of the edges inside a facet, in degrees
  double maximum_cost = 0.15; // of what is merged where no number is given, in lengths of the unit

  struct Prepared
  {
    RS::Partition regions;
  };

  Prepared prepare(const RS::Surface& surface, std::size_t /* number_of_segments */,
                   const RS::Execution& execution) const
  {
    return {RS::grow_regions(
      surface, RS::detect_feature_edges(surface, maximum_angle, RS::Feature_convexity::ALL),
      execution.stage("regions"))};
  }

  RS::Hierarchy merge(const RS::Surface& surface, const Prepared& prepared,
                      const RS::Request& request, const RS::Execution& execution) const
  {
    RS::Requested_regions requested = RS::requested_regions(surface, prepared.regions,
                                                            request.seeds);
    auto graph = RS::build_region_adjacency_graph(surface, requested.regions);
    const auto bend_times_width = [](const auto& g, auto s) {
      if (g[s].length == 0) // components that do not touch: last
        return (std::numeric_limits<double>::max)();
      return (CGAL_PI - g[s].mean_angle()) * (std::min)(g[g.source(s)].area, g[g.target(s)].area) /
             g[s].length;
    };
    RS::Merge_tree tree = RS::merge_requested_regions(surface, requested, graph,
                                                      RS::Lowest_cost_first(bend_times_width), 1,
                                                      execution.stage("merging"));
    std::size_t number = request.number_of_segments;
    if (number == 0)
      number = RS::Number_below_cost{maximum_cost * surface.length_unit()}(tree, surface);
    return RS::Hierarchy(std::move(requested.regions), std::move(tree), number);
  }
};

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv, "flange.off");
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto seed = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:seed", std::size_t(-1)).first;

  RS::Segmenter segmenter(mesh, RS::parameters::method(Facet_merging()));
  std::cout << segmenter.regions().number_of_parts() << " facets, " << segmenter.segment(segment_id)
            << " segments chosen, " << segmenter.segment(segment_id, 5) << " asked for\n";
  write_colored(mesh, segment_id, "write_a_method.ply");

  seed[*faces(mesh).begin()] = 0;
  seed[*std::prev(faces(mesh).end())] = 1;
  segmenter.set_seeds(seed);
  std::cout << segmenter.segment(segment_id, 1) << " segments with two seeds\n";
}
