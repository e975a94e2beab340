// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_NORMALS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_NORMALS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/reading/Corner_reader.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/Signed_volumes.h>
#include <CGAL/Region_segmentation/internal/reading/for_each_edge.h>
#include <CGAL/Region_segmentation/internal/reading/normals.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The normals of the faces of a mesh, and the angles and signs of its edges, with the same bits as in a `Flat_mesh`: for
/// stages that need neither the order of the dual edges nor lengths and areas.
///
/// Bytes: 24 per face; up to 24 more while components that are inside out are found.
template <typename FaceGraph, typename Pack>
class Face_normals
{
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using Edge = Mesh_edge<FaceGraph>;

public:
  /// \throws Invalid_input if a point is not finite
  template <typename ConcurrencyTag>
  Face_normals(const Traversal& traversal, const Pack& np, const Execution<ConcurrencyTag>& execution)
    : m_mesh(traversal.mesh())
    , m_corners(traversal, np, execution)
    , m_normals(traversal.number_of_faces())
  {
    Volume_sum volume(m_normals.size());
    const double certain_area = m_corners.certain_area();
    Double_3* const normals = m_normals.data();
    m_corners.for_each_face(execution, [certain_area, normals, &volume](std::size_t face, std::size_t n, const auto& point) {
      const Double_3 area_vector = area_vector_of(n, point);
      const double area = norm(area_vector);
      volume.add(face, dot(point(0), area_vector));
      normals[face] = area > certain_area
                        ? (1 / area) * area_vector
                        : unit_normal(area_vector, area, squared_longest_edge(n, point), not_a_number);
    });
    if (volume.sum() < 0)
      find_turned_faces(traversal);
  }

  /// The computed cosine of the deviation of an edge between two faces; not a number beside a degenerate face.
  double cosine(const Edge& e) const { return dot(m_normals[e.face], m_normals[e.other_face]); }

  /// `Flat_mesh::CONVEX`, `Flat_mesh::CONCAVE` or 0. From the higher face, as in a `Flat_mesh`: where products and sums are contracted
  /// the cross product from the other one is not exactly the opposite.
  std::uint8_t sign(const Edge& e) const
  {
    const bool is_first_higher = e.face > e.other_face;
    const auto h = is_first_higher != is_turned(e.face) ? e.halfedge : opposite(e.halfedge, m_mesh);
    const std::size_t higher = (std::max)(e.face, e.other_face), lower = (std::min)(e.face, e.other_face);
    return sign_of_edge(m_normals[higher], m_normals[lower], m_corners.direction(h));
  }

private:
  /// Whether the face belongs to a component that is inside out.
  bool is_turned(std::size_t face) const { return !m_is_turned.empty() && m_is_turned[face]; }

  /// If the sum of volumes is below 0; components are turned if the surface as a whole is closed. The volumes are computed anew,
  /// since few meshes need them.
  void find_turned_faces(const Traversal& traversal)
  {
    bool is_closed = true;
    Lowest_root_forest components(m_normals.size());
    for_each_edge(traversal, Execution<>(), [&](const Edge& e) {
      if (e.has_two_faces())
        components.unite(Flat_mesh::Index(e.face), Flat_mesh::Index(e.other_face));
      else if (e.face != Edge::no_face || e.other_face != Edge::no_face)
        is_closed = false;
    });
    if (!is_closed)
      return;
    Signed_volumes volumes(m_normals.size());
    m_corners.for_each_face(Execution<>(), [&](std::size_t face, std::size_t n, const auto& point) {
      volumes.set(face, dot(point(0), area_vector_of(n, point)));
    });
    m_is_turned.resize(m_normals.size());
    for (const auto face : volumes.faces_inside_out(components.take_partition()))
      m_is_turned[face] = true;
  }

  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  /// The normal of a degenerate face, so that none of its edges is sharp.
  static constexpr Double_3 not_a_number = {nan, nan, nan};

  const FaceGraph& m_mesh;
  const Corner_reader<FaceGraph, Pack> m_corners;
  Large_array<Double_3> m_normals; // by face
  std::vector<bool> m_is_turned;   // by face; empty if none is
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FACE_NORMALS_H
