// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_TRIANGLES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_TRIANGLES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/grid.h>
#include <CGAL/Region_segmentation/internal/support/prefetch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Which patches of a mesh, see `Mesh_patches`.
enum class Patch_level { FINE, COARSE };

/// The triangles of the patches of a mesh (polygons as fans), relative to an origin, in float. They are computed from the
/// mesh whenever they are wanted; only the faces of each patch are kept: 4 bytes a face.
class Patch_triangles
{
public:
  using Index = Flat_mesh::Index;

  /// `scale`: of the relative coordinates
  /// \pre the mesh was read with its points and patches
  Patch_triangles(const Flat_mesh& mesh, Patch_level level, const Double_3& origin, double scale)
    : m_level(level), m_frame(mesh.patches().frame()), m_origin(origin), m_scale(scale), m_faces(patches(mesh).size())
  {
    const Partition &fine = mesh.patches().of_faces(), &coarse = mesh.patches().coarse().of_elements();
    const auto patch_of = [&](Index patch) { return level == Patch_level::FINE ? patch : coarse[patch]; };
    for (const Index patch : fine)
      m_faces.count(patch_of(patch));
    m_faces.end_counting();
    for (std::size_t f = 0; f < fine.size(); ++f)
      m_faces.add(patch_of(fine[f]), Index(f));
  }

  const Patches& patches(const Flat_mesh& mesh) const
  {
    return m_level == Patch_level::FINE ? mesh.patches() : mesh.patches().coarse();
  }

  Float_3 relative(const Double_3& point) const
  {
    const Double_3 v = m_scale * m_frame(point - m_origin);
    return {float(v.x), float(v.y), float(v.z)};
  }

  /// A direction in the frame of relative coordinates.
  Float_3 direction(const Double_3& d) const
  {
    const Double_3 v = m_frame(d);
    return {float(v.x), float(v.y), float(v.z)};
  }

  /// A length, relative.
  double relative(double length) const { return m_scale * length; }

  std::size_t number_of_triangles(const Flat_mesh& mesh, std::size_t patch) const
  {
    std::size_t result = 0;
    for (const Index face : m_faces[patch])
      result += (std::max)(mesh.points().number_of_corners(face), std::size_t(2)) - 2;
    return result;
  }

  /// Calls `f(corners, face)` for the triangles of a patch: the first corner of a fan, and two others.
  template <typename F>
  void for_each(const Flat_mesh& mesh, std::size_t patch, const F& f) const
  {
    const Mesh_points& points = mesh.points();
    for (const Index face : m_faces[patch]) {
      const std::size_t n = points.number_of_corners(face), first = first_of_fan(mesh, face);
      const auto corner = [&](std::size_t i) { return relative(points[points.corner(face, i < n ? i : i - n)]); };
      for (std::size_t i = 1; i + 1 < n; ++i)
        f(std::array<Float_3, 3>{corner(first), corner(first + i), corner(first + i + 1)}, face);
    }
  }

  /// Prefetches what `for_each()` reads for each patch `patch_of(visit)`: first where all their faces are, and so on, since
  /// each address depends on the read before.
  template <typename Visits, typename PatchOf>
  void prefetch(const Flat_mesh& mesh, const Visits& visits, const PatchOf& patch_of) const
  {
    const Mesh_points& points = mesh.points();
    for (const auto& visit : visits)
      m_faces.prefetch(patch_of(visit));
    for (const auto& visit : visits)
      internal::prefetch(m_faces[patch_of(visit)].begin());
    for (const auto& visit : visits)
      for (const Index face : m_faces[patch_of(visit)])
        for (std::size_t i = 0; i < points.number_of_corners(face); ++i)
          internal::prefetch(&points[points.corner(face, i)]);
  }

private:
  /// The corner of a polygon farthest from its centroid, of several that of the highest position: so that
  /// what is hit does not depend on the numbering of vertices.
  std::size_t first_of_fan(const Flat_mesh& mesh, Index face) const
  {
    const Mesh_points& points = mesh.points();
    std::size_t first = 0;
    std::pair<std::uint32_t, double> farthest{0, -1};
    for (std::size_t i = 0; points.number_of_corners(face) > 3 && i < points.number_of_corners(face); ++i) {
      const Double_3& corner = points[points.corner(face, i)];
      const std::pair<std::uint32_t, double> rank{coarse_bits(m_scale * norm(corner - mesh.centroid(face))),
                                                  m_frame.position(corner)};
      if (rank > farthest) {
        farthest = rank;
        first = i;
      }
    }
    return first;
  }

  Patch_level m_level;
  Intrinsic_frame m_frame; // so that what rays hit does not depend on motion, even at borders of faces
  Double_3 m_origin;
  double m_scale;
  Grouped_items<Index> m_faces; // by patch
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_TRIANGLES_H
