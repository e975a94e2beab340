// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user-defined method, made of parts: here a scalar of the faces (as it might be curvature or color) goes
// into the cost of merging.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

/// A model of `RegionData`: the area and perimeter of a region, and the integral of the scalar.
struct Scalar_region : RS::Region_geometry
{
  double scalar = 0;

  double mean_scalar() const { return area > 0 ? scalar / area : 0; }

  void absorb(const Scalar_region& other, const RS::Section_geometry& between)
  {
    RS::Region_geometry::absorb(other, between);
    scalar += other.scalar;
  }
};

/// A model of `GraphAnnotator` that holds the values of the faces, by face in iteration order.
struct Scalar_annotator
{
  using RegionData = Scalar_region;
  using SectionData = RS::Section_geometry;

  std::shared_ptr<const std::vector<double>> values;

  template <typename Graph>
  void operator()(Graph& graph, const RS::Flat_mesh& mesh, const RS::Partition& regions) const
  {
    for (std::uint32_t r = 0; r < regions.number_of_parts(); ++r)
      graph[r].scalar = 0;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      graph[regions[f]].scalar += mesh.area(f) * (*values)[f];
  }
};

/// A model of `SectionCost`: regions of different scalars are merged last.
struct Scalar_cost
{
  using RegionData = Scalar_region; // what it reads: a method without these data does not compile
  using SectionData = RS::Section_geometry;

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    return std::abs(graph[graph.source(s)].mean_scalar() - graph[graph.target(s)].mean_scalar());
  }
};

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto scalar = mesh.add_property_map<Mesh::Face_index, double>("f:scalar").first;
  for (auto f : faces(mesh)) // which side of the plane x = 1 a face is on
    scalar[f] = mesh.point(target(halfedge(f, mesh), mesh)).x() > 1 ? 1 : 0;

  const auto method = RS::make_segmentation_method(
    RS::Superfacets(200), Scalar_annotator{std::make_shared<std::vector<double>>(RS::face_values(mesh, scalar))},
    RS::Lowest_cost_first<Scalar_cost>());
  std::cout << RS::segment(mesh, segment_id, RS::parameters::number_of_segments(2).method(method)) << " segments\n";

  // The parts of another method with one of them exchanged.
  const auto other = RS::Two_step().with_initializer(RS::Superfacets(50));
  std::cout << RS::segment(mesh, segment_id, RS::parameters::number_of_segments(3).method(other)) << " segments\n";
}
