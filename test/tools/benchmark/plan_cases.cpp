// SPDX-License-Identifier: GPL-3.0-or-later

#include "plan_cases.h"

#include <utility>

namespace speed_benchmark {

std::string name(Shape shape)
{
  constexpr const char* names[] = {"smooth", "noisy", "shuffled", "loop", "torus"};
  return names[std::size_t(shape)];
}

std::string name(Mesh_type type)
{
  return type == Mesh_type::SURFACE_MESH ? "Surface_mesh"
         : type == Mesh_type::POLYHEDRON ? "Polyhedron_3"
                                         : "OpenMesh";
}

std::string name(const Case& c)
{
  return name(c.mesh.shape) + "/" + std::to_string(c.mesh.faces) + "/" + name(c.mesh.type) + "/" +
         std::to_string(c.threads) + "/" + c.what;
}

namespace {

/// Beyond these, the methods take minutes.
constexpr std::size_t most_faces_for_shape_diameters = 200000;
constexpr std::size_t most_faces_for_approximation = 1500000;
constexpr std::size_t most_faces_for_curvatures = 1500000;

constexpr std::pair<Method, const char*> methods[] = {{Method::TWO_STEP, "two-step"},
                                                      {Method::LEARNED, "learned"}};

Case pipeline(const Mesh_wanted& mesh, const std::string& what, const Pipeline& settings)
{
  Case c{mesh, what, 1, false, {}, {}, {}};
  c.run = [settings](const Subjects& s) { return s.subject.segment(settings); };
  return c;
}

/// Against the same on a `Surface_mesh`.
Case compared_with_surface_mesh(Case c, const Pipeline& settings)
{
  c.reference = name(Mesh_type::SURFACE_MESH);
  c.run_reference = [settings](const Subjects& s) {
    return s.surface_mesh.segment(settings).whole();
  };
  return c;
}

/// Against the same on one thread, as far as the parallel stages go.
Case in_parallel(Case c, Pipeline settings, std::size_t threads)
{
  c.threads = threads;
  c.reference = "1 thread, to regions";
  c.compared_until = Stage::REGIONS;
  settings.is_parallel = false;
  c.run_reference = [settings](const Subjects& s) {
    return s.surface_mesh.segment(settings).until(Stage::REGIONS);
  };
  return c;
}

/// The floor in another mesh type: how much slower than a `Surface_mesh` the type itself is.
Case floor_in_type(const Mesh_wanted& mesh)
{
  Case c{mesh, "compute_face_normals", 1, true, {}, {}, name(Mesh_type::SURFACE_MESH)};
  const auto time = [](Subject& s) { return s.seconds_of_face_normals(); };
  c.run = [time](const Subjects& s) {
    Stage_seconds result;
    result.of_stage.back() = time(s.subject);
    return result;
  };
  c.run_reference = [time](const Subjects& s) { return time(s.surface_mesh); };
  return c;
}

/// A call, against another: of CGAL and of ours.
template <typename Call, typename Reference>
Case call(const Mesh_wanted& mesh, const std::string& what, const Call& run,
          const std::string& reference, const Reference& run_reference)
{
  Case c{mesh, what, 1, true, {}, {}, reference};
  c.run = [run](const Subjects& s) {
    Stage_seconds result;
    result.of_stage.back() = seconds_of(Clock::PROCESSOR, [&] { run(s.surface_mesh); });
    return result;
  };
  c.run_reference = [run_reference](const Subjects& s) { return run_reference(s.surface_mesh); };
  return c;
}

void add_pipelines(std::vector<Case>& cases, const Mesh_wanted& mesh, std::size_t threads)
{
  for (const auto& [method, what] : methods) {
    Pipeline settings{method};
    const Case c = pipeline(mesh, what, settings);
    cases.push_back(mesh.type == Mesh_type::SURFACE_MESH ? c
                                                         : compared_with_surface_mesh(c, settings));
    if (threads > 1 && mesh.type == Mesh_type::SURFACE_MESH) {
      settings.clock = Clock::WALL;
      settings.is_parallel = true;
      cases.push_back(in_parallel(pipeline(mesh, what, settings), settings, threads));
    }
  }
}

void add_edge_methods(std::vector<Case>& cases, const Mesh_wanted& mesh)
{
  const auto regions = [](Subject& s) { return s.segment({Method::REGIONS}).until(Stage::GRAPH); };
  const std::string reference = "regions, all edges";
  cases.push_back(pipeline(mesh, reference, {Method::REGIONS}));
  cases.push_back(call(
    mesh, "detect_sharp_edges", [](auto& s) { s.detect_sharp_edges(); }, reference, regions));
  cases.push_back(call(
    mesh, "connected_components", [](auto& s) { s.connected_components(); }, reference, regions));
  cases.push_back(call(
    mesh, "sharp_edges_segmentation", [](auto& s) { s.sharp_edges_segmentation(); }, reference,
    regions));
}

/// Each stage alone, against what CGAL has.
void add_stages(std::vector<Case>& cases, const Mesh_wanted& mesh)
{
  const auto add = [&](const std::string& what, auto run, const std::string& reference,
                       auto run_reference) {
    cases.push_back(call(mesh, what, run, reference, [run_reference](Surface_mesh_subject& s) {
      return seconds_of(Clock::PROCESSOR, [&] { run_reference(s); });
    }));
  };
  const auto sharp_edges = [](auto& s) { s.detect_sharp_edges(); };
  add(
    "detect_feature_edges", [](auto& s) { s.detect_feature_edges(); }, "detect_sharp_edges",
    sharp_edges);
  add(
    "detect_feature_edges, all edges", [](auto& s) { s.detect_all_feature_edges(); },
    "detect_sharp_edges", sharp_edges);
  add(
    "grow_regions", [](auto& s) { s.grow_regions(); }, "sharp_edges_segmentation",
    [](auto& s) { s.sharp_edges_segmentation(); });
}

const auto learned = [](Subject& s) { return s.segment({Method::LEARNED}).whole(); };

/// Partitions of equal size, which do not follow the shape.
void add_partitions(std::vector<Case>& cases, const Mesh_wanted& mesh)
{
  cases.push_back(call(
    mesh, "METIS::partition_dual_graph", [](auto& s) { s.partition_dual_graph(8); }, "learned",
    learned));
  cases.push_back(call(
    mesh, "meshopt_buildMeshlets", [](auto& s) { s.build_meshlets(); }, "learned", learned));
}

void add_shape_diameters(std::vector<Case>& cases, const Mesh_wanted& mesh)
{
  cases.push_back(call(
    mesh, "sdf_values + segmentation", [](auto& s) { s.shape_diameter_segmentation(8); }, "learned",
    learned));
}

void add_approximation(std::vector<Case>& cases, const Mesh_wanted& mesh)
{
  cases.push_back(call(
    mesh, "Surface_mesh_approximation", [](auto& s) { s.shape_approximation(8); }, "learned",
    learned));
}

void add_curvatures(std::vector<Case>& cases, const Mesh_wanted& mesh)
{
  const std::string reference = "feature lines";
  const auto lines = [](Surface_mesh_subject& s) {
    return seconds_of(Clock::PROCESSOR, [&] { s.feature_lines(); });
  };
  cases.push_back(call(
    mesh, "Monge_via_jet_fitting", [](auto& s) { s.principal_curvatures(); }, reference, lines));
}

} // namespace

std::vector<Case> plan_cases(const Plan& plan)
{
  std::vector<Case> cases;
  for (std::size_t faces : plan.sizes) {
    const Mesh_wanted mesh{Shape::SMOOTH, faces, Mesh_type::SURFACE_MESH};
    add_pipelines(cases, mesh, plan.threads);
    add_pipelines(cases, {Shape::SHUFFLED, faces, Mesh_type::SURFACE_MESH}, 1);
    add_pipelines(cases, {Shape::LOOP, faces, Mesh_type::SURFACE_MESH}, 1);
    add_edge_methods(cases, mesh);
    add_stages(cases, mesh);
    add_stages(cases, {Shape::LOOP, faces, Mesh_type::SURFACE_MESH});
    add_partitions(cases, mesh);
    if (faces <= most_faces_for_shape_diameters)
      add_shape_diameters(cases, mesh);
    if (faces <= most_faces_for_approximation)
      add_approximation(cases, mesh);
    if (faces <= most_faces_for_curvatures)
      add_curvatures(cases, mesh);
    for (Mesh_type type : {Mesh_type::POLYHEDRON, Mesh_type::OPENMESH}) {
      cases.push_back(floor_in_type({Shape::SMOOTH, faces, type}));
      add_pipelines(cases, {Shape::SMOOTH, faces, type}, 1);
    }
  }
  for (std::size_t faces : plan.noisy_sizes) {
    const Mesh_wanted mesh{Shape::NOISY, faces, Mesh_type::SURFACE_MESH};
    add_pipelines(cases, mesh, plan.threads);
    if (faces >= 700000 && faces <= 1500000)
      cases.push_back(pipeline(mesh, "two-step, k = " + std::to_string(plan.many_segments),
                               {Method::TWO_STEP, plan.many_segments}));
    add_edge_methods(cases, mesh);
    add_stages(cases, mesh);
  }
  if (plan.huge > 0)
    for (const auto& [method, what] : methods)
      cases.push_back(pipeline({Shape::TORUS, plan.huge, Mesh_type::SURFACE_MESH}, what, {method}));
  return cases;
}

} // namespace speed_benchmark
