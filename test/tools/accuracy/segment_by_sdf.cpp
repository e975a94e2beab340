// SPDX-License-Identifier: GPL-3.0-or-later

#include "segment_with.h"
#include "thread_seconds.h"

#include <CGAL/mesh_segmentation.h>

#include <CGAL/boost/graph/helpers.h>

#include <stdexcept>

namespace princeton_benchmark {

Timed_segmentation segment_by_sdf(const Benchmark_mesh& mesh, Wanted_number)
{
  if (!CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("CGAL's SDF segmentation takes triangles alone");
  Timed_segmentation result;
  result.labels.resize(num_faces(mesh));
  std::vector<double> diameters(num_faces(mesh));
  const auto diameter_map = face_map(mesh, diameters);
  const double start = thread_seconds();
  CGAL::sdf_values(mesh, diameter_map);
  const double middle = thread_seconds();
  result.number_of_segments = CGAL::segmentation_from_sdf_values(mesh, diameter_map,
                                                                 face_map(mesh, result.labels));
  result.seconds.regions = middle - start;
  result.seconds.merging = thread_seconds() - middle;
  return result;
}

} // namespace princeton_benchmark
