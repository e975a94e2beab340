// SPDX-License-Identifier: GPL-3.0-or-later

#include "cgal_methods.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Surface_mesh_approximation/L21_metric_plane_proxy.h>
#include <CGAL/Variational_shape_approximation.h>
#include <CGAL/boost/graph/METIS/partition_dual_graph.h>
#include <CGAL/mesh_segmentation.h>

#include <boost/property_map/property_map.hpp>

namespace speed_benchmark {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

template <typename Vector>
auto edge_map(const Surface_mesh& mesh, Vector& values)
{
  return boost::make_iterator_property_map(values.begin(), get(CGAL::edge_index, mesh));
}

template <typename Value>
auto face_map(const Surface_mesh& mesh, std::vector<Value>& values)
{
  return boost::make_iterator_property_map(values.begin(), get(CGAL::face_index, mesh));
}

} // namespace

void detect_sharp_edges(const Surface_mesh& mesh, std::vector<std::uint8_t>& is_sharp)
{
  PMP::detect_sharp_edges(mesh, maximum_angle, edge_map(mesh, is_sharp));
}

void connected_components(const Surface_mesh& mesh, const std::vector<std::uint8_t>& is_sharp,
                          std::vector<std::size_t>& components)
{
  PMP::connected_components(mesh, face_map(mesh, components),
                            CGAL::parameters::edge_is_constrained_map(edge_map(mesh, is_sharp)));
}

void sharp_edges_segmentation(const Surface_mesh& mesh, std::vector<std::uint8_t>& is_sharp,
                              std::vector<std::size_t>& components)
{
  PMP::sharp_edges_segmentation(mesh, maximum_angle, edge_map(mesh, is_sharp),
                                face_map(mesh, components));
}

void shape_diameter_segmentation(const Surface_mesh& mesh, std::size_t number_of_clusters,
                                 std::vector<std::size_t>& segments)
{
  std::vector<double> values(num_faces(mesh));
  CGAL::sdf_values(mesh, face_map(mesh, values));
  CGAL::segmentation_from_sdf_values(mesh, face_map(mesh, values), face_map(mesh, segments),
                                     number_of_clusters);
}

void shape_approximation(const Surface_mesh& mesh, std::size_t number_of_proxies,
                         std::vector<std::size_t>& segments)
{
  namespace VSA = CGAL::Surface_mesh_approximation;
  using Point_map = boost::property_map<Surface_mesh, CGAL::vertex_point_t>::const_type;
  using Metric = VSA::L21_metric_plane_proxy<Surface_mesh>;
  const Point_map points = get(CGAL::vertex_point, mesh);
  const Metric metric(mesh, points);
  CGAL::Variational_shape_approximation<Surface_mesh, Point_map, Metric> approximation(mesh, points,
                                                                                       metric);
  approximation.initialize_seeds(
    CGAL::parameters::seeding_method(VSA::HIERARCHICAL).max_number_of_proxies(number_of_proxies));
  approximation.run(30);
  approximation.proxy_map(face_map(mesh, segments));
}

void partition_dual_graph(const Surface_mesh& mesh, std::size_t number_of_parts,
                          std::vector<std::size_t>& parts)
{
  CGAL::METIS::partition_dual_graph(mesh, int(number_of_parts),
                                    CGAL::parameters::face_partition_id_map(face_map(mesh, parts)));
}

} // namespace speed_benchmark
