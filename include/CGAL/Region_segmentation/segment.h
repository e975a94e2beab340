// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_H

#include <CGAL/Region_segmentation/Graph/internal/run_method.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Face_graph_input.h>
#include <CGAL/Region_segmentation/Surface/internal/Polygon_input.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMain
/// segments a surface mesh into parts: first regions are created and merged until the wanted number
/// of segments is reached.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`: loops over all faces or
///         edges run in parallel, with bitwise equal results. Maps that are read must then support
///         concurrent reads; maps are written by one thread
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; also of
///         `EdgeListGraph` where there is an `edge_is_constrained_map`
/// \tparam FaceSegmentMap a model of `WritablePropertyMap` with the face descriptor as key and an
///         integral value type that holds the ids and -1 beside them
/// \param mesh its faces are polygons of any size. Coordinates are rounded to `double`, once, when
///        they are read. Border edges that coincide are joined, and components are linked, unless
///        `component_links` is `false`
/// \param segment_map every key is written: ids 0 .. n-1, numbered by the first face
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_segments}
///     \cgalParamDescription{the wanted number k of segments}
///     \cgalParamType{an integral type; at least 1}
///     \cgalParamDefault{chosen by the method, unless its order of merges depends on it}
///   \cgalParamNEnd
///   \cgalParamNBegin{method}
///     \cgalParamDescription{how the mesh is segmented; constants are members of its parts}
///     \cgalParamType{a model of `SegmentationMethod`}
///     \cgalParamDefault{`Learned_merging()`}
///     \cgalParamExtra{`Visibility_merging()` has a hand-crafted cost, `Smooth_faces()` finds the
///       faces of machine parts, `Two_step()` is the method of \cgalCite{YZWLL14}}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that always are borders and are never merged across, also where
///       they end inside a surface and separate nothing}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a
///       value type convertible to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_seed_map}
///     \cgalParamDescription{faces with equal seeds belong to one segment, faces with different
///       seeds to different ones; -1 of the value type is no seed; see `Segmenter::set_seeds()`.
///       The seed of a face that bounds a void is that of the nearest face around it}
///     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptor as key type and an
///       integral value type}
///     \cgalParamDefault{no seeds}
///   \cgalParamNEnd
///   \cgalParamNBegin{component_links}
///     \cgalParamDescription{whether components that touch or are near each other are adjacent, see
///       `Surface`: k counts parts then, otherwise every component is a segment at least}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamNBegin{region_map}
///     \cgalParamDescription{an output: the first regions, with ids 0 .. r-1, numbered by the first
///       face}
///     \cgalParamType{a model of `WritablePropertyMap` with the face descriptor as key type and an
///       integral value type}
///     \cgalParamDefault{not written}
///   \cgalParamNEnd
///   \cgalParamNBegin{merge_tree}
///     \cgalParamDescription{an output: the merges of the first regions, all of them, or, with a
///       method whose order depends on the wanted number, those down to k}
///     \cgalParamType{`Merge_tree`, passed by `std::ref()` or as an lvalue}
///     \cgalParamDefault{not written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the number n of segments. It is more than k if constraints or seeds keep more apart
///          (also constrained edges that separate nothing, see the manual), or components without
///          links, or if a user-defined policy ends before or its cost bars sections; and less if
///          the method finds fewer first regions. `Learned_merging` and `Visibility_merging` give k
///          segments up to the number of faces that are neither degenerate nor given twice,
///          and bound no void
///
/// \pre `number_of_segments` is at least 1; with the checks of \cgal disabled, another number gives
///      an unspecified number of segments
/// \post every segment is connected by edges, seams and links where every first region is
/// \throws Invalid_input if a point is not finite, equal seeds cannot be joined, different ones are
///         at one place of the wall of a void, or the type of a map does not hold the labels and -1
///         beside them; Invalid_method if a constant of the method is not in its range;
///         `Segmentation_cancelled` if the visitor cancels; all maps are unchanged. What `put()` of
///         a map throws: `segment_map` is written first, in the order of the faces, then
///         `region_map`, then `merge_tree`; what precedes keeps its final value, the rest is
///         unchanged
///
/// Complexity: that of its parts; O(F log F) in practice for `Learned_merging`, O(F + R log R +
/// k^2) expected for `Two_step`. Deterministic: identical results from every mesh type. Concurrent
/// calls on different maps are safe. For several numbers of segments, or when constraints and seeds
/// change, use a `Segmenter`.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename FaceSegmentMap, typename NamedParameters = parameters::Default_named_parameters>
std::size_t segment(const FaceGraph& mesh, FaceSegmentMap segment_map,
                    const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::check_face_map<FaceSegmentMap, FaceGraph>());
  const auto& pack = internal::pack(np);
  const Execution execution = internal::make_execution<ConcurrencyTag>(pack);
  return internal::run_method(internal::Face_graph_input<FaceGraph>(mesh),
                              internal::make_surface(mesh, pack, execution), segment_map, pack,
                              execution);
}

/// \ingroup PkgRegionSegmentationMain
/// segments points and polygons: a *polygon soup*. Nothing needs to be manifold, oriented,
/// connected or free of duplicates; see `make_surface()` for what is adjacent.
///
/// As for a mesh, but
/// \param points a range of points, see `make_surface()`
/// \param polygons a range of ranges of indices of points
/// \param segment_map a random access range of as many elements as there are polygons, or a model
///        of `WritablePropertyMap` with the index of a polygon as key; every polygon gets a
///        segment, a degenerate one that of a neighbor
/// \param np `constrained_edges` is a range of pairs of indices of points, in place of
///        `edge_is_constrained_map`; `face_seed_map` and `region_map` are random access ranges or
///        property maps with the index of a polygon as key, a range of `region_map` by `std::ref()`
///
/// \throws Invalid_input if a polygon has no corner or one that is not a point, a point of a
///         polygon is not finite, or a range has not as many elements as there are polygons
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange,
          typename PolygonRange, typename PolygonSegmentMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t segment_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                                 PolygonSegmentMap&& segment_map,
                                 const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  const Execution execution = internal::make_execution<ConcurrencyTag>(pack);
  Surface surface = internal::make_surface_of_polygon_soup(points, polygons, pack, execution);
  const internal::Polygon_input input(surface.number_of_faces());
  return internal::run_method(input, std::move(surface), segment_map, pack, execution);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_H
