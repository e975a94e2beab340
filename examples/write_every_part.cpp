// SPDX-License-Identifier: GPL-3.0-or-later
//
// A method all of whose parts are user-defined: facets of nearly equal normals are merged by the angle between the mean normals
// of regions, until the cost of a merge jumps.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <numeric>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

/// A model of `RegionInitializer`: the connected components of the faces across edges of small deviation.
struct Facets
{
  double maximum_deviation = 0.05; // radians

  RS::Partition operator()(const RS::Flat_mesh& mesh) const
  {
    std::vector<std::size_t> parent(mesh.number_of_faces()); // union-find
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t f) {
      while (parent[f] != f)
        f = parent[f] = parent[parent[f]];
      return f;
    };
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      if (!mesh.has_flag(e, RS::Flat_mesh::CONSTRAINED) && mesh.deviation(mesh.lower_face(e), e) <= maximum_deviation)
        parent[root(mesh.higher_face(e))] = root(mesh.lower_face(e));
    std::vector<std::size_t> labels;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      labels.push_back(root(f));
    return RS::Partition::from_labels(labels);
  }
};

/// A model of `RegionData`: in addition to area and perimeter, the integral of the normal.
struct Region_with_normal : RS::Region_geometry
{
  RS::Double_3 area_vector{0, 0, 0};

  void add_face(const RS::Flat_mesh& mesh, std::size_t face)
  {
    RS::Region_geometry::add_face(mesh, face);
    area_vector = area_vector + mesh.area(face) * mesh.normal(face);
  }

  void absorb(const Region_with_normal& other, const RS::Section_geometry& between)
  {
    RS::Region_geometry::absorb(other, between);
    area_vector = area_vector + other.area_vector;
  }
};

/// A model of `SectionCost`: low between regions of similar normals, small ones, and across long sections.
struct Normal_cost
{
  using RegionData = Region_with_normal;
  using SectionData = RS::Section_geometry;

  double offset = 0.5; // between regions of equal normals

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Region_with_normal &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    const double lengths = RS::norm(a.area_vector) * RS::norm(b.area_vector);
    const double cosine = lengths > 0 ? RS::dot(a.area_vector, b.area_vector) / lengths : 1;
    return (1 - cosine + offset) * (std::min)(a.area, b.area) / graph[s].length;
  }
};

/// A model of `NumberChooser`: the number before the merge whose cost exceeds all before it by the largest factor.
struct Largest_jump
{
  using MergeCost = Normal_cost; // in any positive units, but of one cost

  std::size_t largest_number = 20;

  std::size_t operator()(const RS::Merge_tree& tree) const
  {
    const std::vector<RS::Merge_tree::Merge>& merges = tree.merges();
    std::size_t number = tree.number_of_regions() - merges.size();
    double highest = 0, largest_factor = 1;
    for (std::size_t i = 0; i < merges.size(); ++i) {
      const std::size_t before = tree.number_of_regions() - i;
      if (before <= largest_number && merges[i].cost > largest_factor * highest) {
        largest_factor = merges[i].cost / highest;
        number = before;
      }
      highest = (std::max)(highest, merges[i].cost);
    }
    return number;
  }
};

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;

  const auto method = RS::make_segmentation_method(Facets(), RS::Geometry_annotator<Region_with_normal>(),
                                                   RS::Lowest_cost_first(Normal_cost()), Largest_jump());
  RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  std::cout << segmenter.regions().number_of_parts() << " regions, " << segmenter.segment(segment_id) << " segments chosen, "
            << segmenter.segment(segment_id, 5) << " asked for\n";
}
