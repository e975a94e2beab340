// SPDX-License-Identifier: GPL-3.0-or-later

#include "build_meshlets.h"

#include <meshoptimizer.h>

#include <vector>

namespace speed_benchmark {

std::size_t build_meshlets(const Surface_mesh& mesh)
{
  constexpr std::size_t most_vertices = 64, most_triangles = 124;
  std::vector<float> points;
  points.reserve(3 * num_vertices(mesh));
  for (const auto v : vertices(mesh))
    for (int i = 0; i < 3; ++i)
      points.push_back(float(mesh.point(v)[i]));
  std::vector<unsigned> corners;
  corners.reserve(3 * num_faces(mesh));
  for (const auto f : faces(mesh))
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(v);
  const std::size_t bound = meshopt_buildMeshletsBound(corners.size(), most_vertices,
                                                       most_triangles);
  std::vector<meshopt_Meshlet> meshlets(bound);
  std::vector<unsigned> meshlet_vertices(bound * most_vertices);
  std::vector<unsigned char> meshlet_triangles(bound * most_triangles * 3);
  return meshopt_buildMeshlets(meshlets.data(), meshlet_vertices.data(), meshlet_triangles.data(),
                               corners.data(), corners.size(), points.data(), points.size() / 3,
                               3 * sizeof(float), most_vertices, most_triangles, 0.0f);
}

} // namespace speed_benchmark
