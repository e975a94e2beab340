// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SMOOTH_BORDERS_H
#define CGAL_REGION_SEGMENTATION_SMOOTH_BORDERS_H

#include <CGAL/Region_segmentation/Border_cost.h>
#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/segmenting/Face_graph_input.h>
#include <CGAL/Region_segmentation/internal/superfacets/Border_cut.h>
#include <CGAL/Region_segmentation/internal/superfacets/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/components.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Moves the borders between the pieces of segments, one pair of pieces after another. A piece is
/// connected across edges that are not constrained, at any time.
///
/// `costs`: of the borders between adjacent faces, `constrained`: which faces are adjacent across
/// constrained edges; `width(a, b)`: of the band between two pieces on each side. `piece_of` is
/// changed; `label_of_piece`: two pieces of one segment have no border to be moved.
inline void smooth_piece_borders(const Dual_graph& costs, const Dual_graph& constrained,
                                 std::function<double(Surface::Index, Surface::Index)> distance,
                                 std::function<double(Surface::Index, Surface::Index)> width,
                                 const std::vector<Surface::Index>& label_of_piece,
                                 std::vector<Surface::Index>& piece_of, const Execution& execution)
{
  using Index = Surface::Index;
  using Pair = std::pair<Index, Index>;
  std::vector<std::pair<Pair, Pair>> sides; // two pieces a < b, and a face of each
  for (Index f = 0; f < piece_of.size(); ++f)
    for (const auto& step : costs.steps(f)) {
      const Index a = piece_of[f], b = piece_of[step.face];
      if (a < b && label_of_piece[a] != label_of_piece[b])
        sides.push_back({{a, b}, {f, step.face}});
    }
  std::sort(sides.begin(), sides.end());

  Border_cut cut(costs, distance, piece_of);
  Step_counter counter(execution, sides.size());
  for (auto side = sides.begin(); side != sides.end();) {
    const Pair pieces = side->first;
    std::vector<Index> border;
    for (; side != sides.end() && side->first == pieces; ++side) {
      // An earlier pair may have moved parts of the border; the remaining border is sufficient as a
      // start.
      const auto [face, neighbor] = side->second;
      if (Pair(piece_of[face], piece_of[neighbor]) == pieces)
        border.insert(border.end(), {face, neighbor});
      counter.advance();
    }
    const auto is_separated = [&](Index face) { // by a constrained edge from the other segment
      const bool is_in_first = piece_of[face] == pieces.first;
      const Index other_label = label_of_piece[is_in_first ? pieces.second : pieces.first];
      const auto steps = constrained.steps(face);
      return std::any_of(steps.begin(), steps.end(), [&](const auto& step) {
        return label_of_piece[piece_of[step.face]] == other_label;
      });
    };
    cut.move_border(pieces.first, pieces.second, border, width(pieces.first, pieces.second),
                    is_separated);
  }
}

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// moves the borders of segments to where a cut is short and lies in valleys.
///
/// For each two adjacent segments \f$a, b\f$, in the order of their first faces, the faces of both
/// within \f$D = \min(D_0, q \sqrt{\min(s_a, s_b)})\f$ of their border are reassigned by a minimum
/// cut of the dual graph. An edge of length \f$l\f$ costs \f$l / (1 + g \, \delta^+)\f$,
/// \f$\delta^+\f$ the deviation of a concave edge (0 of another one). Distances are those of
/// centroids, on paths inside the own segment; \f$s\f$ is the area a segment has at first. Lengths
/// are in units of \f$\sqrt{A}\f$ and areas of \f$A\f$, the area of the surface. Of several
/// cheapest cuts, the one is taken that moves the fewest faces, so a pair keeps its border if no
/// cut is cheaper.
///
/// A face at the inner end of the band keeps its segment, and so does one that a constrained edge
/// separates from the other segment. A segment that is not connected across unconstrained edges
/// counts as several, between which no face moves. The change of a pair is discarded if it would
/// disconnect one of the two.
///
/// Complexity: O(F + B log B), B the number of edges between segments, and for each pair a maximum
/// flow on its band, of a few hundred faces in practice; the connectivity of the two is decided
/// locally, or by a traversal of them at worst. Deterministic: capacities are integers, so the
/// result for a pair does not depend on the order of faces.
///
/// Source: minimum cuts in a fuzzy band \cgalCite{KT03}; the flow \cgalCite{BK04}.
struct Minimum_cut_borders
{
  double width = 0.03; ///< D_0, at least 0, in units of the square root of the area of the surface
  double width_of_segment = 0.2; ///< q, at least 0: at most this part of the square root of the
                                 ///< area of the smaller segment
  Border_cost cost = {Border_cost().concave_gain, CGAL_PI}; ///< of each edge

  /// Changes labels of faces; returns the number of changed faces.
  /// \pre there is a label for every face
  std::size_t operator()(const Surface& surface, std::vector<Surface::Index>& label_of_face,
                         const Execution& execution = Execution()) const
  {
    CGAL_precondition_msg(width >= 0 && width_of_segment >= 0,
                          "Minimum_cut_borders: constants are at least 0");
    CGAL_precondition(label_of_face.size() == surface.number_of_faces());
    const double area = surface.area();
    if (area == 0)
      return 0;
    const Partition pieces = internal::label_components(
      surface,
      [&](std::size_t a) {
        return label_of_face[surface.lower_face(a)] == label_of_face[surface.higher_face(a)] &&
               !surface.has_flag(a, Surface::CONSTRAINED);
      },
      Execution());
    std::vector<Surface::Index> label_of_piece(pieces.number_of_parts());
    std::vector<double> sizes(pieces.number_of_parts()); // square roots of the relative areas
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      label_of_piece[pieces[f]] = label_of_face[f];
      sizes[pieces[f]] += surface.area(f) / area;
    }
    for (double& size : sizes)
      size = std::sqrt(size);

    std::vector<Surface::Index> piece_of_face(pieces.begin(), pieces.end());
    move_borders(surface, sizes, label_of_piece, piece_of_face, execution);

    std::size_t changed = 0;
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      const Surface::Index label = label_of_piece[piece_of_face[f]];
      changed += label != label_of_face[f];
      label_of_face[f] = label;
    }
    return changed;
  }

private:
  void move_borders(const Surface& surface, const std::vector<double>& sizes,
                    const std::vector<Surface::Index>& label_of_piece,
                    std::vector<Surface::Index>& piece_of_face, const Execution& execution) const
  {
    const double unit = surface.length_unit();
    const internal::Dual_graph costs(
      surface, [&](std::size_t a) { return !surface.has_flag(a, Surface::CONSTRAINED); },
      [&](std::size_t a) {
        const double concavity = surface.has_flag(a, Surface::CONCAVE) ? surface.deviation(a) : 0;
        return (std::min)(cost(surface.length(a) / unit, concavity), longest);
      });
    const internal::Dual_graph constrained(
      surface, [&](std::size_t a) { return surface.has_flag(a, Surface::CONSTRAINED); },
      [](std::size_t) { return 0; });
    internal::smooth_piece_borders(
      costs, constrained,
      [&](Surface::Index f, Surface::Index g) {
        return norm(surface.centroid(f) - surface.centroid(g)) / unit;
      },
      [&](Surface::Index a, Surface::Index b) {
        return (std::min)(width, width_of_segment * (std::min)(sizes[a], sizes[b]));
      },
      label_of_piece, piece_of_face, execution);
  }

  static constexpr double longest = 1e30; // relative; limits the lengths of extreme needles to the
                                          // range of float
};

/// \ingroup PkgRegionSegmentationStages
/// moves the borders of segments to where a cut is short and lies in valleys: an optional step
/// after `segment()`, or after any other segmentation.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`: the mesh is read in
///         parallel; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; also of
///         `EdgeListGraph` where there is an `edge_is_constrained_map`
/// \tparam FaceSegmentMap a model of `ReadWritePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; only faces whose label changes are written
/// \param smoother how borders are moved
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
///       its segment than the band of `smoother` keeps its label
/// \throws Invalid_input if a point is not finite, Segmentation_cancelled if the visitor cancels;
///         the map is unchanged
///
/// Constraints of the segmentation are not known here: `edge_is_constrained_map` is to be given
/// again.
///
/// Labels may no longer be numbered by their first face. A second call may move borders further:
/// the bands lie around the new ones.
///
/// Complexity: see `Minimum_cut_borders`. Deterministic: identical results from every mesh type.
/// Concurrent calls on different maps are safe.
///
/// Source: \cgalCite{KT03}.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename FaceSegmentMap, typename NamedParameters = parameters::Default_named_parameters>
std::size_t smooth_borders(const FaceGraph& mesh, FaceSegmentMap segment_map,
                           const Minimum_cut_borders& smoother,
                           const NamedParameters& np = parameters::default_values())
{
  using Label = typename boost::property_traits<FaceSegmentMap>::value_type;
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Reading_parameters>();
  const Execution execution = internal::make_execution<ConcurrencyTag>(pack);
  const internal::Stage_input input(mesh, pack, execution);
  const Partition before = internal::read_face_labels(mesh, segment_map);
  std::vector<Label> labels(before.number_of_parts());
  std::size_t i = 0;
  for (auto f : faces(mesh))
    labels[before[i++]] = get(segment_map, f);

  std::vector<Surface::Index> after(before.begin(), before.end());
  const std::size_t changed = smoother(input.surface(), after, execution.stage("borders"));
  i = 0;
  for (auto f : faces(mesh)) {
    if (after[i] != before[i])
      put(segment_map, f, Label(labels[after[i]]));
    ++i;
  }
  return changed;
}

/// \ingroup PkgRegionSegmentationStages
/// As above, with the constants of `Minimum_cut_borders()`.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename FaceSegmentMap, typename NamedParameters = parameters::Default_named_parameters>
std::size_t smooth_borders(const FaceGraph& mesh, FaceSegmentMap segment_map,
                           const NamedParameters& np = parameters::default_values())
{
  return smooth_borders<ConcurrencyTag>(mesh, segment_map, Minimum_cut_borders(), np);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SMOOTH_BORDERS_H
