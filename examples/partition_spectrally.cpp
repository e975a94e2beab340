// SPDX-License-Identifier: GPL-3.0-or-later
//
// A method of one's own that needs the number of segments, with data of one's own for regions and
// sections: the eigenvectors of a normalized Laplacian make points of the regions (Shi, Malik:
// Normalized Cuts and Image Segmentation, 2000; Qiu, Hancock: Clustering and Embedding Using
// Commute Times, 2007), and adjacent regions whose points are near each other are merged (Ward:
// Hierarchical Grouping to Optimize an Objective Function, 1963). Requires Eigen.

#include "example_mesh.h"

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/segment.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace RS = CGAL::Region_segmentation;

/// A model of `SectionData`: two regions attract each other along their border, least in a valley.
struct Attraction
{
  double value = 0;

  void add_adjacency(const RS::Surface& surface, std::size_t a)
  {
    const bool is_concave = surface.has_flag(a, RS::Surface::CONCAVE);
    const double depth = is_concave ? surface.deviation(a) : 0;
    value += surface.length(a) / std::pow(depth + 0.05, 2);
  }
  void absorb(const Attraction& other) { value += other.value; }
};

/// A model of `RegionData`: the regions of a set as points, weighted by their areas.
struct Weighted_points
{
  double weight = (std::numeric_limits<double>::min)();
  Eigen::VectorXd sum;

  void add_face(const RS::Surface& surface, std::size_t f) { weight += surface.weight(f); }
  void add_border(const RS::Surface&, std::size_t) {}
  void absorb(const Weighted_points& other, const Attraction&)
  {
    weight += other.weight;
    sum += other.sum;
  }
};

/// A model of `SegmentationMethod`.
struct Spectral_partitioning
{
  struct Prepared
  {
    RS::Partition regions;
  };

  /// The superfacets of another method.
  Prepared prepare(const RS::Surface& surface, std::size_t number_of_segments,
                   const RS::Execution& execution) const
  {
    const RS::Visibility_merging other;
    return {other
              .merge(surface, other.prepare(surface, number_of_segments, execution), RS::Request(),
                     execution)
              .regions()};
  }

  RS::Segmentation merge(const RS::Surface& surface, const Prepared& prepared,
                         const RS::Request& request, const RS::Execution& execution) const
  {
    RS::Requested_regions requested = RS::requested_regions(surface, prepared.regions,
                                                            request.seeds);
    auto graph = RS::build_region_adjacency_graph<Weighted_points, Attraction>(surface,
                                                                               requested.regions);
    const Eigen::MatrixXd points = embedding(graph, request.number_of_segments + 3);
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      graph[*range.first].sum = graph[*range.first].weight * points.row(*range.first).transpose();
    const auto growth_of_variance = [](const auto& g, auto s) {
      const Weighted_points &a = g[g.source(s)], &b = g[g.target(s)];
      return a.weight * b.weight / (a.weight + b.weight) *
             (a.sum / a.weight - b.sum / b.weight).squaredNorm();
    };
    RS::Merge_tree tree = RS::merge_requested_regions(
      surface, requested, graph, RS::Lowest_cost_first(growth_of_variance),
      request.number_of_segments, execution.stage("merging"));
    return {std::move(requested.regions), std::move(tree), request.number_of_segments};
  }

private:
  /// The rows are the regions: the `number` lowest solutions of L y = lambda D y, each divided by
  /// the root of lambda. So the squared distance of two is their commute time in a random walk. D
  /// are the sums of the attractions of the regions, L is the Laplacian.
  template <typename Graph>
  static Eigen::MatrixXd embedding(const Graph& graph, std::size_t number)
  {
    const auto n = Eigen::Index(graph.number_of_regions());
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n);
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      const auto a = graph.source(*range.first), b = graph.target(*range.first);
      const double attraction = graph.is_mergeable(*range.first) ? graph[*range.first].value : 0;
      laplacian(a, a) += attraction;
      laplacian(b, b) += attraction;
      laplacian(a, b) = laplacian(b, a) = -attraction;
    }
    const Eigen::VectorXd
      roots = laplacian.diagonal().cwiseMax((std::numeric_limits<double>::min)()).cwiseSqrt();
    const Eigen::VectorXd inverse_roots = roots.cwiseInverse();
    const auto scale = inverse_roots.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale * laplacian * scale);
    const Eigen::Index size = (std::min)(Eigen::Index(number), n);
    const Eigen::VectorXd values = solver.eigenvalues().head(size).cwiseMax(1e-7);
    return scale * solver.eigenvectors().leftCols(size) *
           values.cwiseSqrt().cwiseInverse().asDiagonal();
  }
};

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  std::cout << RS::segment(mesh, segment_id,
                           RS::parameters::number_of_segments(10).method(Spectral_partitioning()))
            << " segments\n";
  write_colored(mesh, segment_id, "partition_spectrally.ply");
}
