// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBJECT_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBJECT_H

#include "Stage_clock.h"
#include "Triangles.h"

#include <cstddef>
#include <memory>

namespace speed_benchmark {

/// `REGIONS`: what `PMP::sharp_edges_segmentation` makes, and the region graph: `two-step` up to
/// its merging, all edges above the bound being feature edges.
enum class Method { TWO_STEP, LEARNED, REGIONS };

struct Pipeline
{
  Method method = Method::TWO_STEP;
  std::size_t number_of_segments = 8;
  /// With `CGAL::Parallel_tag`, where the library has it.
  bool is_parallel = false;
  Clock clock = Clock::PROCESSOR;
};

/// A mesh of some type, and what is timed on it.
class Subject
{
public:
  virtual ~Subject() = default;
  virtual std::size_t number_of_faces() const = 0;
  /// The processor time of one pass of `PMP::compute_face_normals`, the floor of runs on one
  /// thread.
  virtual double seconds_of_face_normals() = 0;
  virtual Stage_seconds segment(const Pipeline& pipeline) = 0;
};

/// What CGAL and others have, on a `Surface_mesh`, and what compares with it of ours.
class Surface_mesh_subject : public Subject
{
public:
  /// Makes room for the results of the calls below, so that it is not counted with them.
  virtual void prepare_calls() = 0;

  virtual void detect_sharp_edges() = 0;
  /// The components between the edges that `detect_sharp_edges()` found last.
  virtual void connected_components() = 0;
  virtual void sharp_edges_segmentation() = 0;
  virtual void shape_diameter_segmentation(std::size_t number_of_segments) = 0;
  virtual void shape_approximation(std::size_t number_of_segments) = 0;
  virtual void partition_dual_graph(std::size_t number_of_parts) = 0;
  virtual void build_meshlets() = 0;
  virtual void principal_curvatures() = 0;
  virtual void feature_lines() = 0;
  /// The stages alone: concave feature edges, those of every sign, and regions between the edges
  /// that were found last.
  virtual void detect_feature_edges() = 0;
  virtual void detect_all_feature_edges() = 0;
  virtual void grow_regions() = 0;
};

std::unique_ptr<Surface_mesh_subject> make_surface_mesh_subject(const Triangles& triangles);
std::unique_ptr<Subject> make_polyhedron_subject(const Triangles& triangles);
/// Null where OpenMesh is missing.
std::unique_ptr<Subject> make_openmesh_subject(const Triangles& triangles);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBJECT_H
