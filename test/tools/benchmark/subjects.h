// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBJECTS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBJECTS_H

#include "shapes.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace speed_benchmark {

/// A mesh, and room for what the subjects find: it is neither timed nor counted.
struct Input
{
  Triangles triangles;
  Surface_mesh mesh;                  ///< of the triangles; empty where polygons alone are wanted
  std::vector<std::size_t> ids;       ///< of faces
  std::vector<std::uint8_t> is_sharp; ///< of edges
};

/// How long a run took, and of it the stages that it tells of.
struct Timing
{
  double seconds;
  std::vector<std::pair<std::string, double>> stages;
};

/// What is measured.
struct Subject
{
  std::string name;
  std::size_t threads;
  std::size_t most_faces; ///< beyond them it takes minutes
  bool takes_polygons;    ///< the triangles, in place of the mesh
  std::function<Timing(Input& input)> run;
};

/// The processor time of one pass of `PMP::compute_face_normals`.
double seconds_of_face_normals(const Surface_mesh& mesh);

/// The methods of the library, the last time with `CGAL::Parallel_tag` and so many threads, stages
/// of `Two_step`, what a `Segmenter` is asked for, and what CGAL and others have.
std::vector<Subject> subjects(std::size_t threads);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUBJECTS_H
