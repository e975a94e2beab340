// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_CASE_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_CASE_H

#include "Subject.h"

#include <cstddef>
#include <functional>
#include <string>

namespace speed_benchmark {

/// `SMOOTH`: real meshes, subdivided; `NOISY`: the same with every vertex moved; `SHUFFLED`:
/// smooth ones, faces and vertices in random order; `LOOP`: real meshes, subdivided by Loop's
/// scheme; `TORUS`: made here.
enum class Shape { SMOOTH, NOISY, SHUFFLED, LOOP, TORUS };
enum class Mesh_type { SURFACE_MESH, POLYHEDRON, OPENMESH };

/// A shape of about so many faces.
struct Mesh_wanted
{
  Shape shape;
  std::size_t faces;
  Mesh_type type;

  bool has_same_triangles(const Mesh_wanted& other) const
  {
    return shape == other.shape && faces == other.faces;
  }
};

/// The mesh as the type that is wanted, and as a `Surface_mesh`: the same object if that is it.
struct Subjects
{
  Subject& subject;
  Surface_mesh_subject& surface_mesh;
};

/// A line of the table: what is run on which mesh, and against what.
struct Case
{
  Mesh_wanted mesh;
  std::string what;
  std::size_t threads;
  /// Has no stages: their times are all in the last one.
  bool is_call;
  std::function<Stage_seconds(const Subjects&)> run;
  /// What it is compared with in seconds, and its name; both empty where there is nothing.
  std::function<double(const Subjects&)> run_reference;
  std::string reference;
  /// The part of the run that is compared.
  Stage compared_until = Stage::BORDERS;
};

std::string name(Shape shape);
std::string name(Mesh_type type);
/// As the filter of Google Benchmark knows it.
std::string name(const Case& c);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_CASE_H
