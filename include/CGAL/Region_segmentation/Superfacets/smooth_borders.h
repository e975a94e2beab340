// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_SMOOTH_BORDERS_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_SMOOTH_BORDERS_H

#include <CGAL/Region_segmentation/Graph/internal/Dual_graph.h>
#include <CGAL/Region_segmentation/Superfacets/Border_cost.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Border_cut.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/Face_graph_input.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The costs of the borders between faces, across edges that are not constrained.
inline Dual_graph costs_of_face_borders(const Surface& surface, const Border_cost& cost)
{
  constexpr double longest = 1e30; // so that the edges of extreme needles are in the range of float
  return Dual_graph(
    surface, [&](std::size_t a) { return !surface.has_flag(a, Surface::CONSTRAINED); },
    [&](std::size_t a) {
      return (std::min)(
        cost(surface.length(a) / surface.length_unit(), surface.concave_deviation(a)), longest);
    });
}

/// The faces of different labels at constrained edges.
inline std::vector<bool> faces_at_constrained_borders(const Surface& surface,
                                                      const std::vector<Surface::Index>& label_of)
{
  std::vector<bool> result(surface.number_of_faces());
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Surface::Index f = surface.lower_face(a), g = surface.higher_face(a);
    if (surface.has_flag(a, Surface::CONSTRAINED) && label_of[f] != label_of[g])
      result[f] = result[g] = true;
  }
  return result;
}

/// The pieces of the faces after the border between each two adjacent pieces of different labels
/// was moved.
inline std::vector<Surface::Index>
move_borders_of_pieces(const Surface& surface, const Minimum_cut_borders& borders,
                       const std::vector<Surface::Index>& label_of, const Partition& pieces,
                       const Execution& execution)
{
  using Index = Surface::Index;
  using Pair = std::pair<Index, Index>;
  const Dual_graph costs = costs_of_face_borders(surface, borders.cost);
  std::map<Pair, std::vector<Pair>> sides; // by two pieces a < b: pairs of adjacent faces
  for (Index f = 0; f < pieces.size(); ++f)
    for (const auto& step : costs.steps(f))
      if (pieces[f] < pieces[step.face] && label_of[f] != label_of[step.face])
        sides[{pieces[f], pieces[step.face]}].push_back({f, step.face});

  const std::vector<double> areas = part_areas(surface, pieces);
  const std::vector<bool> is_fixed = faces_at_constrained_borders(surface, label_of);
  std::vector<Index> piece_of(pieces.begin(), pieces.end());
  Border_cut cut(
    costs,
    [&](Index f, Index g) {
      return norm(surface.centroid(f) - surface.centroid(g)) / surface.length_unit();
    },
    piece_of);
  Step_counter counter(execution, sides.size());
  for (const auto& [ab, faces] : sides) {
    std::vector<Index> border; // the faces that are still at this border
    for (const auto& [f, g] : faces)
      if (Pair(piece_of[f], piece_of[g]) == ab)
        border.insert(border.end(), {f, g});
    const double area = (std::min)(areas[ab.first], areas[ab.second]) / surface.area();
    cut.move_border(ab.first, ab.second, border, borders.band_width(area),
                    [&](Index f) { return is_fixed[f]; });
    counter.advance();
  }
  return piece_of;
}

/// Moves the borders of segments as documented at `smooth_borders()`; returns the number of faces
/// whose label changed. A piece is a set of faces of one label that is connected across edges that
/// are not constrained.
/// \pre there is a label for every face
inline std::size_t smooth_face_labels(const Surface& surface, const Minimum_cut_borders& borders,
                                      std::vector<Surface::Index>& label_of,
                                      const Execution& execution)
{
  borders.check_constants();
  if (surface.area() == 0)
    return 0;
  const Partition pieces = label_components(
    surface,
    [&](std::size_t a) {
      return label_of[surface.lower_face(a)] == label_of[surface.higher_face(a)] &&
             !surface.has_flag(a, Surface::CONSTRAINED);
    },
    Execution());
  std::vector<Surface::Index> label_of_piece(pieces.number_of_parts());
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    label_of_piece[pieces[f]] = label_of[f];
  const std::vector<Surface::Index> piece_of = move_borders_of_pieces(surface, borders, label_of,
                                                                      pieces, execution);
  std::size_t changed = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    const Surface::Index label = label_of_piece[piece_of[f]];
    changed += label != std::exchange(label_of[f], label);
  }
  return changed;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// moves the borders of segments to where a cut is short and lies in valleys: an optional step
/// after `segment()`, or after any other segmentation.
///
/// For each two adjacent segments \f$a, b\f$, in the order of their first faces, the faces of both
/// within \f$D = \min(D_0, q \sqrt{\min(s_a, s_b)})\f$ of their border (see `Minimum_cut_borders`)
/// are reassigned by a minimum cut of the dual graph. An edge of length \f$l\f$ costs \f$l / (1 + g
/// \, \delta^+)\f$, \f$\delta^+\f$ the deviation of a concave edge and 0 for another edge.
/// Distances are those of centroids, on paths inside the own segment; \f$s\f$ is the area that a
/// segment has at first. If that width is below \f$10^{-6}\f$, the border stays. Of several
/// cheapest cuts, the one that moves the fewest faces is taken, so two segments keep their border
/// if no cut is cheaper.
///
/// A face at the inner end of the band keeps its segment, and so does a face that a constrained
/// edge separates from another segment. A segment that is not connected across unconstrained edges
/// counts as several, between which no face moves. The change of a border is discarded if it would
/// disconnect a segment.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`: the mesh is read in
///         parallel; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; also of
///         `EdgeListGraph` where there is an `edge_is_constrained_map`
/// \tparam FaceSegmentMap a model of `ReadWritePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; only faces whose label changes are written
/// \param borders how borders are moved
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that keep the border that runs along them, and that no border
///       moves across}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a
///       value type convertible to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{component_links}
///     \cgalParamDescription{whether border edges with equal end points are one edge; other links
///       have no effect here}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel: stages "reading", "borders"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the number of faces whose label changed
/// \post the labels in use are the same; a segment that was connected across edges that are not
///       constrained still is, and one that was not has no more pieces; the two sides of a
///       constrained edge that had different labels still have; a face farther from the borders of
///       its segment than the band of `borders` keeps its label
/// \throws Invalid_input if a point is not finite, Invalid_method if a constant of `borders` is not
///         in its range, Segmentation_cancelled if the visitor cancels; the map is unchanged
///
/// Constraints of the segmentation are not known here: `edge_is_constrained_map` is to be given
/// again.
///
/// Labels may no longer be numbered by their first face. A second call may move borders further:
/// the bands lie around the new ones.
///
/// Complexity: O(F + B log B), B the number of edges between segments, and for each pair of
/// segments a maximum flow on its band, of a few hundred faces in practice; whether the two are
/// still connected is decided by a local search, at worst by a traversal of them. Deterministic:
/// identical results from every mesh type. Concurrent calls on different maps are safe.
///
/// Source: minimum cuts in a fuzzy band \cgalCite{KT03}; the flow \cgalCite{BK04}.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename FaceSegmentMap, typename NamedParameters = parameters::Default_named_parameters>
std::size_t smooth_borders(const FaceGraph& mesh, FaceSegmentMap segment_map,
                           const Minimum_cut_borders& borders = Minimum_cut_borders(),
                           const NamedParameters& np = parameters::default_values())
{
  using Label = typename boost::property_traits<FaceSegmentMap>::value_type;
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Reading_parameters>();
  const Execution execution = internal::make_execution<ConcurrencyTag>(pack);
  const Surface surface = internal::constrained(
    internal::Face_graph_input<FaceGraph>(mesh),
    internal::make_surface(mesh, pack, internal::without_links(pack), execution.stage("reading")),
    pack);
  const Partition before = internal::read_face_labels(mesh, segment_map);
  std::vector<Label> labels(before.number_of_parts());
  std::size_t i = 0;
  for (auto f : faces(mesh))
    labels[before[i++]] = get(segment_map, f);

  std::vector<Surface::Index> after(before.begin(), before.end());
  const std::size_t changed = internal::smooth_face_labels(surface, borders, after,
                                                           execution.stage("borders"));
  i = 0;
  for (auto f : faces(mesh)) {
    if (after[i] != before[i])
      put(segment_map, f, Label(labels[after[i]]));
    ++i;
  }
  return changed;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_SMOOTH_BORDERS_H
