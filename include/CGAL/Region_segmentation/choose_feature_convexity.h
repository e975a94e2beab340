// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_CHOOSE_FEATURE_CONVEXITY_H
#define CGAL_REGION_SEGMENTATION_CHOOSE_FEATURE_CONVEXITY_H

#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/internal/support/options.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// What `choose_feature_convexity()` chose, and why.
struct Feature_convexity_choice
{
  Feature_convexity convexity = Feature_convexity::CONCAVE; ///< `CONCAVE` or `ALL`
  /// The flat fraction of the length of edges next to creases, in [0, 1]; 0 without a crease, 1 if the adjacent faces
  /// have no other edges, as in a cube of squares.
  double flatness_beside_creases = 0;
};

namespace internal {

inline Feature_convexity_choice choose_feature_convexity(const Flat_mesh& flat,
                                                         double maximum_angle)
{
  const double crease_angle = 30; // degrees
  const double crease_bound = std::cos(crease_angle * (CGAL_PI / 180));
  const double flat_bound = std::cos(maximum_angle * (CGAL_PI / 180));
  const auto for_each_edge = [&](auto visit) {
    for (std::size_t e = 0; e < flat.number_of_edges(); ++e)
      if (!flat.has_flag(e, Flat_mesh::JOINING | Flat_mesh::CLOSED))
        visit(flat.lower_face(e), e, flat.cosine(flat.lower_face(e), e));
  };
  std::vector<std::uint8_t> has_crease(flat.number_of_faces());
  bool any_crease = false;
  for_each_edge([&](std::size_t f, std::size_t e, double cosine) {
    if (cosine >= crease_bound)
      return;
    has_crease[f] = has_crease[flat.higher_face(e)] = 1;
    any_crease = true;
  });
  double length = 0, flat_length = 0;
  for_each_edge([&](std::size_t f, std::size_t e, double cosine) {
    if (cosine < crease_bound || !(has_crease[f] || has_crease[flat.higher_face(e)]))
      return;
    length += flat.length(e);
    if (cosine >= flat_bound)
      flat_length += flat.length(e);
  });

  Feature_convexity_choice choice;
  choice.flatness_beside_creases = length > 0 ? flat_length / length : any_crease ? 1 : 0;
  if (choice.flatness_beside_creases > 0.5)
    choice.convexity = Feature_convexity::ALL;
  return choice;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// chooses which edges can be feature edges, by the surface itself: all on a machine part, the concave
/// ones on a scanned or organic model.
///
/// A *crease* is an edge whose deviation is above 30 degrees. A machine part is mostly flat next to its creases; other
/// surfaces are curved or noisy there. So all edges are chosen if, of the other edges of the faces that have a crease,
/// more than half of the length is flat: its deviation is at most `maximum_angle`. Edges of degenerate faces do not
/// count. Without a crease the concave edges are chosen.
///
/// The result describes the surface, not the edges along which people would segment a model: with the
/// concave edges `Two_step` is closer to people on machine parts, too, unless those edges close no
/// region (figures in `doc/accuracy.md`). So no function of the package calls it; pass the result as
/// `feature_convexity`. Choose `ALL` to get the smooth faces of a machine part.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh an oriented 2-manifold with or without borders, its faces polygons of any size
/// \param np optional named parameters:
///   - `maximum_angle` (degrees, default `default_maximum_angle`, 1.2372...): the deviation up to which
///     an edge is flat, the bound of `detect_feature_edges()`
///   - `visitor`: a model of `SegmentationVisitor`, for the stage "reading"
///   - `vertex_point_map`, `face_index_map`, `vertex_index_map`: as everywhere in \cgal
///
/// \pre `maximum_angle` is in [0, 180]
/// \throws Invalid_input if a point is not finite
///
/// Complexity: O(F). Deterministic. Concurrent calls are safe.
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters>
Feature_convexity_choice
choose_feature_convexity(const FaceGraph& mesh,
                         const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<
    std::decay_t<decltype(pack)>,
    internal::Tag_list<CGAL::internal_np::maximum_angle_t, CGAL::internal_np::visitor_t>>();
  const auto traversal = internal::make_mesh_traversal(mesh, pack);
  return internal::choose_feature_convexity(
    internal::read_flat_mesh<CGAL::Sequential_tag>(traversal, pack, Mesh_data::NOTHING_MORE),
    internal::maximum_angle(pack));
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_CHOOSE_FEATURE_CONVEXITY_H
