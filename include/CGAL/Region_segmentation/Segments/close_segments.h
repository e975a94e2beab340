// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_CLOSE_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_CLOSE_SEGMENTS_H

/// \file close_segments.h
/// Requires Eigen 3; so it is not part of region_segmentation.h.

#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Segments/internal/Segment_caps.h>
#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The planes of the faces around a vertex of a solid, weighted by the angles of their corners:
/// those of caps that move inwards, those of other faces that stay.
class Planes_of_vertex
{
public:
  void add(const Double_3& normal, double angle, bool moves)
  {
    m_matrix.add_square(angle, normal);
    if (moves)
      m_right_side = m_right_side - angle * normal;
  }

  /// The shortest move that takes the vertex to all planes, in the sense of least squares, those of
  /// caps being moved inwards by a distance of 1: the right side of the normal equations times the
  /// pseudoinverse of their matrix. Eigenvalues of a small share count as 0: the vertex does not
  /// move in a direction to which all planes are nearly parallel, so that no vertex of a wedge
  /// moves far.
  Double_3 move() const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(to_eigen(m_matrix));
    Double_3 result{0, 0, 0};
    for (int i = 0; i < 3; ++i)
      if (const double value = solver.eigenvalues()[i]; value > least_share * m_matrix.trace()) {
        const auto v = solver.eigenvectors().col(i);
        const Double_3 direction{v[0], v[1], v[2]};
        result = result + dot(direction, m_right_side) / value * direction;
      }
    return result;
  }

private:
  /// The share of an eigenvalue in the sum of all three; that of a wedge of 16 degrees is this one.
  static constexpr double least_share = 0.02;

  Symmetric_3 m_matrix; // the sums of the normal equations
  Double_3 m_right_side{0, 0, 0};
};

/// By fan of the solids, the planes of its faces. `surface`: of the mesh
inline std::vector<Planes_of_vertex> planes_of_vertices(const Segmented_halfedges& solids,
                                                        const Segment_caps& caps,
                                                        const Surface& surface)
{
  using Index = Segmented_halfedges::Index;
  const Partition fans = solids.fans();
  std::vector<Planes_of_vertex> planes(fans.number_of_parts());
  for (Index h = 0; h < solids.size(); ++h) {
    const Index f = solids.face[h], next = solids.next(h);
    const Double_3 corner = caps.points()[solids.target(h)],
                   back = caps.points()[solids.source[h]] - corner,
                   ahead = caps.points()[solids.target(next)] - corner;
    const Double_3 across = cross(ahead, back);
    const double angle = std::atan2(norm(across), dot(ahead, back));
    if (f < surface.number_of_faces())
      planes[fans[next]].add(surface.normal(f), angle, false);
    else if (norm(across) > 0)
      planes[fans[next]].add(1 / norm(across) * across, angle,
                             caps.triangles()[(f - surface.number_of_faces()) / 2].higher <=
                               solids.number_of_segments);
  }
  return planes;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// copies every segment to a closed mesh of its own, a solid: its faces and caps, for printing or
/// for simulation.
///
/// `#include <CGAL/Region_segmentation/Segments/close_segments.h>`, which requires Eigen.
///
/// Every triangle of a cap belongs to exactly two solids, oppositely oriented and with equal
/// coordinates. So the solids of a closed mesh fit together without gaps or overlaps, and their
/// volumes add up to that of the mesh. Faces of the label `no_segment` are one more segment that is
/// not output; the border of an open mesh is closed by caps, too.
///
/// A *network* consists of border edges that share vertices. Where two segments share one closed
/// polyline, the cap is a fan from its center of mass, nearly flat if the polyline is. At a vertex
/// where three or more segments meet, an inner edge goes from there to the center of mass of the
/// network, and the caps of all these segments meet in it: two segments that share a polyline from
/// junction to junction have a cap between this polyline and the two inner edges, a fan from the
/// center of mass of this polygon.
///
/// With a *clearance*, the caps of each solid are moved inwards by half of it, and their vertices
/// on the surface of the mesh along it, in the sense of least squares where more than three planes
/// meet in a vertex. Vertices of wedges of less than 16 degrees are not moved along them. Caps that
/// close the border of an open mesh stay. Solids overlap themselves where this is more than they
/// are thick, or than the edges beside their borders are long.
///
/// A segment that is the wall of a hole becomes a solid that is inside out, of negative volume, and
/// those of its neighbors fill the hole: as every sum of volumes needs. So this is for parts as
/// people see them, less for the faces of a machine part.
///
/// The caps of different networks may cross each other, and a fan crosses itself or the mesh where
/// its border is not seen from its center, as around thin curved sheets:
/// `CGAL::Polygon_mesh_processing::does_self_intersect()` tells. (Least-area triangulations of the
/// borders cross the mesh more often.) Segments of smooth borders, see `smooth_borders()`, are
/// closed best.
///
/// \tparam SegmentMesh the type of the solids, a model of `MutableFaceGraph` whose elements are
///         iterated in the order of their creation, with a point map of vertices. Default:
///         `FaceGraph`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam SolidOutputIterator a model of `OutputIterator` that takes `Segment_piece<SegmentMesh,
///         FaceGraph, Label>`, `Label` the value type of `FaceSegmentMap`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels
/// \param solids receives the solids, in the order of the first faces of the segments. The faces of
///        the segment come first, in their order; a face of a cap is the null face of the input,
///        and a vertex inside a cap the null vertex
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
///   \cgalParamNBegin{clearance}
///     \cgalParamDescription{how far the caps between two solids are apart, for parts that are
///                           printed and put together; in units of the mesh}
///     \cgalParamType{a number type that is converted to `double`}
///     \cgalParamDefault{0: they coincide}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the output iterator
/// \throws Invalid_input if a point is not finite
///
/// \pre `clearance` is at least 0 and finite
///
/// Complexity: O(F + V + B log B), B the number of edges between segments. Deterministic: the same
/// solids from every mesh type. Read-only; concurrent calls are safe.
template <typename SegmentMesh = void, typename FaceGraph, typename FaceSegmentMap,
          typename SolidOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
SolidOutputIterator close_segments(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                                   SolidOutputIterator solids,
                                   const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Piece = internal::Piece_of<SegmentMesh, FaceGraph, FaceSegmentMap>;
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>,
                             internal::Tag_list<internal_np::clearance_t>>();
  const double clearance = choose_parameter(get_parameter(pack, internal_np::clearance), 0.0);
  CGAL_precondition_msg(clearance >= 0 && std::isfinite(clearance),
                        "close_segments(): the clearance is a finite length, at least 0");
  const auto segmented = internal::read_segmented_mesh(mesh, segment_map, pack);
  const auto points = choose_parameter(get_parameter(pack, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  const Surface surface = internal::surface_as_given(mesh, pack);
  const internal::Segment_caps caps(segmented, surface, [](auto) { return false; });
  const auto closed = internal::with_caps(segmented, caps);
  std::vector<internal::Planes_of_vertex> planes; // by fan
  if (clearance > 0)
    planes = internal::planes_of_vertices(closed, caps, surface);
  return internal::Piece_builder<Piece, decltype(segmented)>(segmented, closed)
    .build(solids, [&](std::uint32_t h, std::uint32_t fan, const auto& f) {
      const Double_3 move = planes.empty() ? Double_3{0, 0, 0} : clearance / 2 * planes[fan].move();
      const std::uint32_t v = closed.source[h];
      if (squared_norm(move) == 0 && v < segmented.vertices.size())
        return f(get(points, segmented.vertices[v]));
      const Double_3 p = surface.unit() * caps.points()[v] + move;
      f(std::array<double, 3>{p.x, p.y, p.z});
    });
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_CLOSE_SEGMENTS_H
