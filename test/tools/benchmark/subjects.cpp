// SPDX-License-Identifier: GPL-3.0-or-later

#include "subjects.h"

#include "seconds.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Surface/edge_values.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Surface_mesh_approximation/L21_metric_plane_proxy.h>
#include <CGAL/Variational_shape_approximation.h>
#include <CGAL/boost/graph/METIS/partition_dual_graph.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>

namespace speed_benchmark {

namespace RS = CGAL::Region_segmentation;
namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

constexpr std::size_t number_of_parts = 8;

/// The bound of the paper, 180 - 3.12 * 180 / pi, in degrees.
constexpr double maximum_angle = 180 - 3.12 * 57.29577951308232;

template <typename Value>
auto face_map(const Surface_mesh& mesh, std::vector<Value>& values)
{
  return boost::make_iterator_property_map(values.begin(), get(CGAL::face_index, mesh));
}

auto id_map(Input& input)
{
  return face_map(input.mesh, input.ids);
}

auto sharp_map(Input& input)
{
  return boost::make_iterator_property_map(input.is_sharp.begin(),
                                           get(CGAL::edge_index, input.mesh));
}

/// A `SegmentationVisitor` that times the stages of a call. A stage lasts until the next begins.
class Stage_clock
{
public:
  explicit Stage_clock(Clock clock)
    : m_clock(clock)
    , m_start(seconds(clock))
    , m_last(m_start)
  {}

  bool on_progress(const std::string& name, double)
  {
    if (m_stages.empty() || m_stages.back().first != name) {
      finish_stage();
      m_stages.push_back({name, 0});
    }
    return true;
  }

  Timing stop()
  {
    finish_stage();
    return {m_last - m_start, m_stages};
  }

private:
  /// What comes before the first stage belongs to it.
  void finish_stage()
  {
    if (m_stages.empty())
      return;
    const double now = seconds(m_clock);
    m_stages.back().second += now - m_last;
    m_last = now;
  }

  Clock m_clock;
  double m_start, m_last;
  std::vector<std::pair<std::string, double>> m_stages;
};

template <typename ConcurrencyTag, typename NamedParameters>
Timing run_method(Input& input, const NamedParameters& np, Clock clock)
{
  Stage_clock stages(clock);
  RS::segment<ConcurrencyTag>(input.mesh, id_map(input), np.visitor(std::ref(stages)));
  return stages.stop();
}

Timing segment_polygons(Input& input)
{
  Stage_clock stages(Clock::PROCESSOR);
  RS::segment_polygon_soup(input.triangles.points, input.triangles.corners, input.ids,
                           RS::parameters::visitor(std::ref(stages)));
  return stages.stop();
}

/// A call on one thread, without stages.
template <typename Call>
Subject call(const std::string& name, const Call& run,
             std::size_t most_faces = std::numeric_limits<std::size_t>::max())
{
  return {name, 1, most_faces, false, [run](Input& input) {
            return Timing{seconds_of(Clock::PROCESSOR, [&] { run(input); }), {}};
          }};
}

template <typename Parameters>
void add_method(std::vector<Subject>& all, const std::string& name, std::size_t threads,
                const Parameters& np)
{
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  all.push_back({name, 1, any, false, [np](Input& input) {
                   return run_method<CGAL::Sequential_tag>(input, np, Clock::PROCESSOR);
                 }});
  if (threads > 1)
    all.push_back({name, threads, any, false, [np](Input& input) {
                     return run_method<CGAL::Parallel_tag>(input, np, Clock::WALL);
                   }});
}

/// From the mesh to values of its edges and faces.
void add_stages(std::vector<Subject>& all)
{
  all.push_back(call("detect_feature_edges", [](Input& input) {
    const RS::Surface surface = RS::make_surface(input.mesh);
    RS::write_edge_values(input.mesh, surface, RS::detect_feature_edges(surface), sharp_map(input));
  }));
  all.push_back({"grow_regions", 1, std::numeric_limits<std::size_t>::max(), false, [](Input& i) {
                   const RS::Surface marked = RS::make_surface(i.mesh);
                   const auto marks = RS::detect_feature_edges(marked);
                   return Timing{seconds_of(Clock::PROCESSOR,
                                            [&] {
                                              const RS::Surface surface = RS::make_surface(i.mesh);
                                              RS::write_face_values(
                                                i.mesh, RS::grow_regions(surface, marks),
                                                id_map(i));
                                            }),
                                 {}};
                 }});
}

/// The edges between the faces near the first one, and the others.
std::vector<bool> draw_loop(const Surface_mesh& mesh)
{
  const auto squared_distance_of = [&](Surface_mesh::Face_index f) {
    return squared_distance(mesh.point(mesh.target(mesh.halfedge(f))),
                            mesh.point(mesh.target(mesh.halfedge(*mesh.faces().begin()))));
  };
  double farthest = 0;
  for (const auto f : mesh.faces())
    farthest = std::max(farthest, squared_distance_of(f));
  std::vector<bool> is_near;
  for (const auto f : mesh.faces())
    is_near.push_back(squared_distance_of(f) < 0.04 * farthest);
  std::vector<bool> is_drawn(num_edges(mesh));
  for (const auto e : mesh.edges())
    is_drawn[e] = !mesh.is_border(e) && is_near[mesh.face(mesh.halfedge(e, 0))] !=
                                          is_near[mesh.face(mesh.halfedge(e, 1))];
  return is_drawn;
}

/// Of a `Segmenter` that is prepared.
void add_questions(std::vector<Subject>& all)
{
  const auto add = [&](const std::string& name, auto ask) {
    all.push_back({name, 1, 20000000, false, [ask](Input& input) {
                     RS::Segmenter segmenter(input.mesh);
                     segmenter.segment(id_map(input), number_of_parts);
                     return ask(input, segmenter);
                   }});
  };
  add("Segmenter: another number", [](Input& input, auto& segmenter) {
    return Timing{
      seconds_of(Clock::PROCESSOR, [&] { segmenter.segment(id_map(input), number_of_parts + 1); }),
      {}};
  });
  add("Segmenter: a closed line", [](Input& input, auto& segmenter) {
    const std::vector<bool> is_drawn = draw_loop(input.mesh);
    const auto map = boost::make_function_property_map<Surface_mesh::Edge_index>(
      [&](Surface_mesh::Edge_index e) { return bool(is_drawn[e]); });
    return Timing{seconds_of(Clock::PROCESSOR, [&] { segmenter.add_constraints(map); }), {}};
  });
}

void find_components(Input& input)
{
  PMP::detect_sharp_edges(input.mesh, maximum_angle, sharp_map(input));
  PMP::connected_components(input.mesh, id_map(input),
                            CGAL::parameters::edge_is_constrained_map(sharp_map(input)));
}

void find_diameters(Input& input)
{
  std::vector<double> values(num_faces(input.mesh));
  CGAL::sdf_values(input.mesh, face_map(input.mesh, values));
  CGAL::segmentation_from_sdf_values(input.mesh, face_map(input.mesh, values), id_map(input),
                                     number_of_parts);
}

/// The proxies (hierarchical seeds, 30 iterations), no new mesh.
void approximate(Input& input)
{
  namespace VSA = CGAL::Surface_mesh_approximation;
  using Point_map = boost::property_map<Surface_mesh, CGAL::vertex_point_t>::const_type;
  using Metric = VSA::L21_metric_plane_proxy<Surface_mesh>;
  const Surface_mesh& mesh = input.mesh;
  const Point_map points = get(CGAL::vertex_point, mesh);
  const Metric metric(mesh, points);
  CGAL::Variational_shape_approximation<Surface_mesh, Point_map, Metric> approximation(mesh, points,
                                                                                       metric);
  approximation.initialize_seeds(
    CGAL::parameters::seeding_method(VSA::HIERARCHICAL).max_number_of_proxies(number_of_parts));
  approximation.run(30);
  approximation.proxy_map(id_map(input));
}

/// Meshlets of the usual size.
void build_meshlets(Input& input)
{
  constexpr std::size_t most_vertices = 64, most_triangles = 124;
  std::vector<float> points;
  for (const auto v : input.mesh.vertices())
    for (int i = 0; i < 3; ++i)
      points.push_back(float(input.mesh.point(v)[i]));
  std::vector<unsigned> corners;
  for (const auto f : input.mesh.faces())
    for (const auto v : input.mesh.vertices_around_face(input.mesh.halfedge(f)))
      corners.push_back(v);
  const std::size_t bound = meshopt_buildMeshletsBound(corners.size(), most_vertices,
                                                       most_triangles);
  std::vector<meshopt_Meshlet> meshlets(bound);
  std::vector<unsigned> vertices(bound * most_vertices);
  std::vector<unsigned char> triangles(bound * most_triangles * 3);
  meshopt_buildMeshlets(meshlets.data(), vertices.data(), triangles.data(), corners.data(),
                        corners.size(), points.data(), points.size() / 3, 3 * sizeof(float),
                        most_vertices, most_triangles, 0.0f);
}

void add_others(std::vector<Subject>& all)
{
  all.push_back(call("detect_sharp_edges", [](Input& input) {
    PMP::detect_sharp_edges(input.mesh, maximum_angle, sharp_map(input));
  }));
  all.push_back(call("detect_sharp_edges + connected_components", find_components));
  all.push_back(call("sharp_edges_segmentation", [](Input& input) {
    PMP::sharp_edges_segmentation(input.mesh, maximum_angle, sharp_map(input), id_map(input));
  }));
  all.push_back(call("METIS partition_dual_graph", [](Input& input) {
    CGAL::METIS::partition_dual_graph(input.mesh, int(number_of_parts),
                                      CGAL::parameters::face_partition_id_map(id_map(input)));
  }));
  all.push_back(call("meshoptimizer buildMeshlets", build_meshlets));
  all.push_back(call("Variational_shape_approximation", approximate, 1500000));
  all.push_back(call("sdf_values + segmentation_from_sdf_values", find_diameters, 200000));
}

} // namespace

double seconds_of_face_normals(const Surface_mesh& mesh)
{
  std::vector<Kernel::Vector_3> normals(num_faces(mesh));
  return seconds_of(Clock::PROCESSOR, [&] {
    PMP::compute_face_normals(mesh, face_map(mesh, normals),
                              CGAL::parameters::geom_traits(Kernel()));
  });
}

std::vector<Subject> subjects(std::size_t threads)
{
  std::vector<Subject> all;
  add_method(all, "learned", threads, RS::parameters::method(RS::Learned_merging()));
  add_method(all, "two-step", threads,
             RS::parameters::method(RS::Two_step()).number_of_segments(number_of_parts));
  all.push_back(
    {"learned of polygons", 1, std::numeric_limits<std::size_t>::max(), true, segment_polygons});
  add_stages(all);
  add_questions(all);
  add_others(all);
  return all;
}

} // namespace speed_benchmark
