// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_MESH_STORE_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_MESH_STORE_H

#include "Case.h"
#include "sums.h"

#include <memory>
#include <optional>
#include <string>

namespace speed_benchmark {

/// Makes the meshes that are wanted, and keeps the last: as a `Surface_mesh`, and in one other
/// type.
class Mesh_store
{
public:
  /// `folder`: where the `.off` files of CGAL's demos are, in whatever depth.
  explicit Mesh_store(std::string folder)
    : m_folder(std::move(folder))
  {}

  /// The references are valid until the next call. Nothing where the type is missing.
  /// \throws std::runtime_error if a file is missing
  std::optional<Subjects> get(const Mesh_wanted& mesh);

  /// For the mesh that was asked for last; made when first needed.
  const Sums& sums();

private:
  Triangles make_triangles(const Mesh_wanted& mesh) const;
  void make_surface_mesh(const Mesh_wanted& mesh);

  std::string m_folder;
  Mesh_wanted m_mesh = {};
  Triangles m_triangles;
  std::unique_ptr<Surface_mesh_subject> m_surface_mesh;
  std::unique_ptr<Subject> m_other;
  Mesh_type m_type_of_other = {};
  std::unique_ptr<Sums> m_sums;
};

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_MESH_STORE_H
