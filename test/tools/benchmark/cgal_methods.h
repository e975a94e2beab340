// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_CGAL_METHODS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_CGAL_METHODS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace speed_benchmark {

using Surface_mesh = CGAL::Surface_mesh<
  CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

/// The bound of the paper, 180 - 3.12 * 180 / pi, in degrees.
constexpr double maximum_angle = 180 - 3.12 * 57.29577951308232;

// What CGAL offers to the same end. The vectors have an element for every edge or face.

void detect_sharp_edges(const Surface_mesh& mesh, std::vector<std::uint8_t>& is_sharp);
void connected_components(const Surface_mesh& mesh, const std::vector<std::uint8_t>& is_sharp,
                          std::vector<std::size_t>& components);
void sharp_edges_segmentation(const Surface_mesh& mesh, std::vector<std::uint8_t>& is_sharp,
                              std::vector<std::size_t>& components);

/// `sdf_values` and `segmentation_from_sdf_values`, both with their defaults.
void shape_diameter_segmentation(const Surface_mesh& mesh, std::size_t number_of_clusters,
                                 std::vector<std::size_t>& segments);

/// The proxies of `Variational_shape_approximation` (hierarchical seeds, 30 iterations), no new
/// mesh.
void shape_approximation(const Surface_mesh& mesh, std::size_t number_of_proxies,
                         std::vector<std::size_t>& segments);

/// METIS on the dual graph: parts of equal numbers of faces between which there are few edges.
void partition_dual_graph(const Surface_mesh& mesh, std::size_t number_of_parts,
                          std::vector<std::size_t>& parts);

/// The larger principal curvature of every vertex by `Monge_via_jet_fitting` of degree 2 to the
/// vertices at most two edges away; 0 on borders and where there are fewer than six.
void principal_curvatures(const Surface_mesh& mesh, std::vector<double>& curvatures);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_CGAL_METHODS_H
