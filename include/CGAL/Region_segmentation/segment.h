// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_H

#include <CGAL/Region_segmentation/Merge_tree.h>
#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/best.h>
#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>
#include <CGAL/Region_segmentation/internal/build_graph.h>
#include <CGAL/Region_segmentation/internal/companions.h>
#include <CGAL/Region_segmentation/internal/cut.h>
#include <CGAL/Region_segmentation/internal/mark_feature_edges.h>
#include <CGAL/Region_segmentation/internal/options.h>
#include <CGAL/Region_segmentation/internal/progress.h>
#include <CGAL/Region_segmentation/internal/write_maps.h>
#include <CGAL/Region_segmentation/merge_regions.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMain
/// segments a surface mesh into parts: first regions are made and merged until the wanted number of
/// segments is left.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with \ref thirdpartyTBB, `Parallel_tag`: what touches every
///         face or edge runs in parallel, to the same bits. Maps that are read must allow several readers then;
///         maps that are written are written by one thread
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FaceSegmentMap a model of `WritablePropertyMap` with the face descriptor as key and an
///         integral value type that holds the number of segments
/// \param mesh an oriented 2-manifold with or without borders, its faces polygons of any size
/// \param segment_map every key is written: ids 0 .. n-1, numbered by the first face
/// \param np optional named parameters:
///   - `number_of_segments` (at least 1): the wanted number k; left out, it is chosen by the policy's
///     `NumberChooser`, if there is one
///   - `maximum_angle` (degrees, default 180 - 3.12 * 180 / pi = 1.2376...): the deviation above which
///     an edge is a feature edge. `Two_step` grows its regions between feature edges; `Best` does not
///     look at them
///   - `feature_convexity` (`Feature_convexity`, default `CONCAVE`): which edges can be feature edges
///   - `merging_policy`: a model of `RegionMergingPolicy` (default: `Best()`; `Two_step()` is the
///     method of the paper)
///   - `region_initializer`: a model of `RegionInitializer` (default: that of the policy)
///   - `edge_is_constrained_map`: edges that always are borders and are never merged across (none)
///   - `visitor`: a model of `SegmentationVisitor`; by `std::ref()` if it changes
///   - `vertex_point_map`, `face_index_map`, `vertex_index_map`: as everywhere in \cgal
///   - `edge_is_feature_map`: receives the feature edges that separate regions, and the borders
///   - `region_map`: receives the first regions: ids 0 .. r-1, numbered by the first face
///   - `merge_tree`: a `std::reference_wrapper<Merge_tree>`: receives the merges of the first regions
///     down to k; ask for 1 segment to get them all. (Beyond the number of first regions `segment()`
///     itself splits those of `Superfacets`.)
///
/// \returns the number n of segments. It is more than k when the mesh has more connected pieces (or
///          pieces between constrained edges) than k, and less when there are fewer first regions
///
/// \pre `number_of_segments` is at least 1, `maximum_angle` in [0, 180]
/// \post every segment is connected where every first region is
/// \throws Invalid_input if a point is not finite, `Segmentation_cancelled` if the visitor says so; all
///         maps are as before then
///
/// Complexity: that of its parts; O(F log F) in practice for `Best`, O(F + R log R + k^2) expected for
/// `Two_step`.
/// Deterministic: the same bits from every mesh type. Calls on different maps may run at the same time.
///
/// Source: Yang, Zhou, Wang, Liu, Luo, "A fast and efficient mesh segmentation method based on improved
/// region growing", Appl. Math. J. Chinese Univ. 29(4):468-480, 2014.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph, typename FaceSegmentMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t segment(const FaceGraph& mesh, FaceSegmentMap segment_map,
                    const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto& pack = internal::pack(np);
  const std::size_t wanted = internal::number_of_segments(pack, 1);
  auto policy = choose_parameter(get_parameter(pack, internal_np::merging_policy), Best());
  using Companions = internal::Companions_of_policy<decltype(policy)>;
  const auto initializer = choose_parameter(get_parameter(pack, internal_np::region_initializer),
                                            typename Companions::RegionInitializer());
  const typename Companions::GraphAnnotator annotator{};

  internal::Progress reading(pack, "reading", 1);
  const auto walk = internal::make_mesh_walk(mesh, pack);
  const Flat_mesh flat = internal::read_flat_mesh<ConcurrencyTag>(
    walk, pack, (std::max)(internal::content_for(initializer), internal::content_for(annotator)));

  internal::Progress detecting(pack, "features", 1);
  Edge_marks is_feature = internal::mark_feature_edges<ConcurrencyTag>(
    flat, internal::maximum_angle(pack), internal::feature_convexity(pack));

  internal::Progress growing(pack, "regions", 1);
  const Region_labels regions = internal::make_regions<ConcurrencyTag>(initializer, flat, is_feature);

  auto graph = internal::build_graph<typename Companions::Graph, ConcurrencyTag>(flat, regions);
  internal::annotate<ConcurrencyTag>(annotator, graph, flat, regions);
  const Merge_tree tree = merge_regions(graph, policy, wanted, Stop_at_count{wanted}, pack);
  const internal::Segment_labels segments(
    regions, tree, internal::choose_number<Companions>(tree, wanted, pack));

  internal::write_face_map(walk, segment_map, segments);
  internal::write_segmentation_outputs<ConcurrencyTag>(walk, flat, regions, is_feature, tree, pack);
  return segments.number_of_segments();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_H
