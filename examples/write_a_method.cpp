// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user-defined method, made of parts: here a scalar of the faces (as it might be curvature or color) goes
// into the cost of merging.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <memory>
#include <utility>
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

  /// Optional: what is known of regions when some of them change, so that only the new ones are measured.
  struct Cache
  {
    std::vector<double> scalars; // by region; not a number if unknown

    void renumber(const std::vector<std::uint32_t>& previous_of)
    {
      std::vector<double> renumbered;
      for (std::uint32_t previous : previous_of)
        renumbered.push_back(previous < scalars.size() ? scalars[previous] : NAN);
      scalars = std::move(renumbered);
    }
  };

  template <typename Graph, typename ConcurrencyTag>
  void operator()(Graph& graph, const RS::Flat_mesh& mesh, const RS::Partition& regions,
                  const RS::Execution<ConcurrencyTag>&, Cache& cache) const
  {
    cache.scalars.resize(regions.number_of_parts(), NAN);
    for (std::uint32_t r = 0; r < regions.number_of_parts(); ++r)
      graph[r].scalar = std::isnan(cache.scalars[r]) ? 0 : cache.scalars[r];
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      if (std::isnan(cache.scalars[regions[f]]))
        graph[regions[f]].scalar += mesh.area(f) * (*values)[f];
    for (std::uint32_t r = 0; r < regions.number_of_parts(); ++r)
      cache.scalars[r] = graph[r].scalar;
  }

  template <typename Graph>
  void operator()(Graph& graph, const RS::Flat_mesh& mesh, const RS::Partition& regions) const
  {
    Cache unused;
    (*this)(graph, mesh, regions, RS::Execution<>(), unused);
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

  // Edges drawn lengthwise: the regions that they split are new, all others come from the cache.
  auto is_drawn = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_drawn", false).first;
  const auto is_above = [&mesh](auto f) { return mesh.point(target(halfedge(f, mesh), mesh)).y() > 0; };
  for (auto e : edges(mesh))
    is_drawn[e] = is_above(face(halfedge(e, mesh), mesh)) != is_above(face(opposite(halfedge(e, mesh), mesh), mesh));
  RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  const std::size_t number_before = segmenter.regions().number_of_parts();
  segmenter.add_constraints(is_drawn);
  std::cout << segmenter.segment(segment_id, 2) << " segments of " << segmenter.regions().number_of_parts() << " regions, "
            << number_before << " before\n";

  // The parts of another method with one of them exchanged.
  const auto other = RS::Two_step().with_initializer(RS::Superfacets(50));
  std::cout << RS::segment(mesh, segment_id, RS::parameters::number_of_segments(3).method(other)) << " segments\n";
}
