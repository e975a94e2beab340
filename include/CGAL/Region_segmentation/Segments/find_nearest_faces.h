// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_FIND_NEAREST_FACES_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_FIND_NEAREST_FACES_H

#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the nearest face of a surface. A face that does not agree with the caller counts as
/// farther by a twentieth of the square root of the area of the surface: so the other side of a
/// thin wall is not found, unless no face nearby agrees.
///
/// O(log F) in practice for a point, after O(F log F).
class Nearest_face_finder
{
public:
  using Index = Surface::Index;

  /// \pre there is a face
  explicit Nearest_face_finder(const Surface& surface)
    : m_tree(surface)
    , m_disagreement(0.05 * surface.length_unit())
  {}

  /// The nearest face; of several the one of lowest number. `p` is in the unit of the surface, and
  /// `agrees(face)` returns whether a face agrees.
  template <typename Agrees>
  Index find(const Double_3& p, const Agrees& agrees) const
  {
    std::pair<double, Index> nearest(std::numeric_limits<double>::infinity(), 0);
    double bound = nearest.first; // a little above the square of the least distance
    const Box_tree& boxes = m_tree.boxes();
    boxes.search(
      [&, at = box_of(std::array{p - m_tree.origin()})](Index node) {
        return squared_gap(boxes.box(node), at);
      },
      bound,
      [&](Index leaf) {
        const Index face = m_tree.face(leaf);
        const double distance = std::sqrt(squared_distance(p, m_tree.triangle(leaf)));
        nearest = (std::min)(nearest,
                             std::make_pair(distance + (agrees(face) ? 0 : m_disagreement), face));
        bound = 1.000001 * nearest.first * nearest.first + (std::numeric_limits<double>::min)();
      });
    return nearest.second;
  }

private:
  const Face_tree m_tree;
  const double m_disagreement;
};

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// finds the face nearest to each of several points in space, such as the points of strokes that
/// become seeds of `face_seed_map`.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam PointRange a range whose value type is a model of `Kernel::Point_3`, or has `operator[]`
///         for its coordinates
/// \tparam FaceOutputIterator a model of `OutputIterator` that takes face descriptors
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param points the points, in the coordinates of the mesh
/// \param nearest_faces receives a face for each point: of several nearest faces the first one
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the output iterator
/// \throws Invalid_input if a point, or one of the mesh, is not finite, or the mesh has no faces;
///         nothing is output
///
/// Complexity: O(F log F), and O(log F) in practice for each point. Deterministic. Read-only;
/// concurrent calls are safe.
template <typename FaceGraph, typename PointRange, typename FaceOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
FaceOutputIterator find_nearest_faces(const FaceGraph& mesh, const PointRange& points,
                                      FaceOutputIterator nearest_faces,
                                      const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  using Pack = std::decay_t<decltype(pack)>;
  internal::check_parameters<Pack, internal::Tag_list<>>();
  const Surface surface = internal::surface_as_given(mesh, pack);
  if (surface.number_of_faces() == 0)
    throw Invalid_input("find_nearest_faces: the mesh has no faces");
  std::vector<Double_3> positions;
  for (const auto& p : points) {
    positions.push_back(1 / surface.unit() * internal::to_double_3(p));
    if (!is_finite(positions.back()))
      throw Invalid_input("find_nearest_faces: a point is not finite");
  }
  const internal::Nearest_face_finder finder(surface);
  const auto range = faces(mesh);
  const std::vector<typename boost::graph_traits<FaceGraph>::face_descriptor> ordered_faces(
    range.begin(), range.end());
  for (const Double_3& p : positions)
    *nearest_faces++ = ordered_faces[finder.find(p, [](auto) { return true; })];
  return nearest_faces;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_FIND_NEAREST_FACES_H
