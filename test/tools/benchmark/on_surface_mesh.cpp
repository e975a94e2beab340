// SPDX-License-Identifier: GPL-3.0-or-later

#include "build_meshlets.h"
#include "cgal_methods.h"
#include "run_on_mesh.h"

#include <CGAL/Region_segmentation/Surface/edge_values.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/extract_feature_lines.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/iterator.h>

#include <algorithm>

namespace speed_benchmark {

namespace {

namespace RS = CGAL::Region_segmentation;

Surface_mesh::Vertex_index add_point(Surface_mesh& mesh, const Triangles::Point& p)
{
  return mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
}

class On_surface_mesh : public Mesh_subject<Surface_mesh, Surface_mesh_subject>
{
  auto edge_marks()
  {
    return boost::make_iterator_property_map(m_edge_marks.begin(), get(CGAL::edge_index, m_mesh));
  }

public:
  explicit On_surface_mesh(const Triangles& triangles)
    : Mesh_subject(triangles, add_point)
  {}

  void prepare_calls() override
  {
    m_edge_marks.resize(num_edges(m_mesh));
    m_face_numbers.resize(num_faces(m_mesh));
    m_curvatures.resize(num_vertices(m_mesh));
  }

  void detect_sharp_edges() override
  {
    clear_edge_marks();
    speed_benchmark::detect_sharp_edges(m_mesh, m_edge_marks);
  }
  void connected_components() override
  {
    speed_benchmark::connected_components(m_mesh, m_edge_marks, m_face_numbers);
  }
  void sharp_edges_segmentation() override
  {
    clear_edge_marks();
    speed_benchmark::sharp_edges_segmentation(m_mesh, m_edge_marks, m_face_numbers);
  }
  void shape_diameter_segmentation(std::size_t number_of_segments) override
  {
    speed_benchmark::shape_diameter_segmentation(m_mesh, number_of_segments, m_face_numbers);
  }
  void shape_approximation(std::size_t number_of_segments) override
  {
    speed_benchmark::shape_approximation(m_mesh, number_of_segments, m_face_numbers);
  }
  void partition_dual_graph(std::size_t number_of_parts) override
  {
    speed_benchmark::partition_dual_graph(m_mesh, number_of_parts, m_face_numbers);
  }
  void build_meshlets() override { speed_benchmark::build_meshlets(m_mesh); }
  void principal_curvatures() override
  {
    speed_benchmark::principal_curvatures(m_mesh, m_curvatures);
  }
  void feature_lines() override
  {
    const RS::Surface surface = RS::make_surface(m_mesh);
    auto marks = RS::detect_feature_edges(surface);
    RS::extract_feature_lines(surface, marks, CGAL::Emptyset_iterator());
    RS::write_edge_values(m_mesh, surface, marks, edge_marks());
  }
  void detect_feature_edges() override { detect(RS::Feature_convexity::CONCAVE); }
  void detect_all_feature_edges() override { detect(RS::Feature_convexity::ALL); }
  void grow_regions() override
  {
    const RS::Surface surface = RS::make_surface(m_mesh);
    RS::write_face_values(m_mesh,
                          RS::grow_regions(surface, RS::edge_values(m_mesh, surface, edge_marks())),
                          face_map(m_face_numbers));
  }

private:
  void detect(RS::Feature_convexity convexity)
  {
    const RS::Surface surface = RS::make_surface(m_mesh);
    const auto marks = RS::detect_feature_edges(surface, RS::default_maximum_angle, convexity);
    RS::write_edge_values(m_mesh, surface, marks, edge_marks());
  }
  /// CGAL does not.
  void clear_edge_marks() { std::fill(m_edge_marks.begin(), m_edge_marks.end(), std::uint8_t(0)); }

  std::vector<std::uint8_t> m_edge_marks;
  std::vector<std::size_t> m_face_numbers;
  std::vector<double> m_curvatures;
};

} // namespace

std::unique_ptr<Surface_mesh_subject> make_surface_mesh_subject(const Triangles& triangles)
{
  return std::make_unique<On_surface_mesh>(triangles);
}

} // namespace speed_benchmark
