// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTER_H
#define CGAL_REGION_SEGMENTATION_SEGMENTER_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/internal/support/check_maps.h>
#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/segmenting/check_method.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/segmenting/Prepared_mesh.h>
#include <CGAL/Region_segmentation/internal/segmenting/prepare.h>
#include <CGAL/Region_segmentation/internal/support/options.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMain
/// A mesh that is prepared once and can then be segmented into any number of segments.
///
/// Preparing reads the mesh, makes the first regions and annotates their graph. If the order of merges of the method
/// does not depend on the number of segments, the regions are also merged: each number of segments then takes only the
/// time of writing labels, and the segmentations are nested. With another method (`Two_step`) or a partitioner each
/// call of `segment()` merges a copy of the graph.
///
/// The segmenter refers to the mesh, whose faces must not change afterwards. Coordinates are read once: later changes
/// of points have no effect.
///
/// Segmenting is `const`, and thread-safe with different maps. Adding constraints or seeds requires exclusive access. A
/// segmenter can be moved and copied.
///
/// Bytes, with the default method: about 180 per face.
///
/// Omit the template arguments: `Segmenter segmenter(mesh, parameters::method(m))` deduces the type of the method.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Method a model of `SegmentationMethod`
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`; see `segment()`
template <typename FaceGraph, typename Method = Learned_merging, typename ConcurrencyTag = CGAL::Sequential_tag>
class Segmenter
{
  using Prepared = internal::Prepared_mesh<Method, ConcurrencyTag>;

public:
  /// prepares a mesh.
  ///
  /// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{method}
  ///     \cgalParamDescription{how the mesh is segmented; stored by value}
  ///     \cgalParamType{a model of `SegmentationMethod`}
  ///     \cgalParamDefault{`Method()`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_segments}
  ///     \cgalParamDescription{the number for `segment(segment_map)`}
  ///     \cgalParamType{an integral type; at least 1}
  ///     \cgalParamDefault{chosen by the method}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{edge_is_constrained_map}
  ///     \cgalParamDescription{edges that always are borders and are never merged across}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a value type
  ///       convertible to `bool`}
  ///     \cgalParamDefault{no edge}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{face_seed_map}
  ///     \cgalParamDescription{faces with equal seeds belong to one segment, faces with different seeds to different
  ///       ones; `std::size_t(-1)` is no seed; see `Segmenter::set_seeds()`}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the face descriptor as key type and an integral value type}
  ///     \cgalParamDefault{no seeds}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{follows the progress, and can cancel: stages "reading", "regions", "graph", "merging"}
  ///     \cgalParamType{a model of `SegmentationVisitor`}
  ///     \cgalParamDefault{none}
  ///     \cgalParamExtra{used by the constructor only; pass it by `std::ref()` if it changes}
  ///   \cgalParamNEnd
  ///   \cgalParamVertexPointMap
  ///   \cgalParamIndexMap{face}
  ///   \cgalParamIndexMap{vertex}
  ///   \cgalParamNBegin{region_map}
  ///     \cgalParamDescription{an output: the first regions, with ids 0 .. r-1, numbered by the first face}
  ///     \cgalParamType{a model of `WritablePropertyMap` with the face descriptor as key type and an integral value type}
  ///     \cgalParamDefault{not written}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{merge_tree}
  ///     \cgalParamDescription{an output: the merges, with a method that has one tree for all numbers}
  ///     \cgalParamType{`Merge_tree`}
  ///     \cgalParamDefault{not written}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throws Invalid_input if a point is not finite, or equal seeds cannot be joined; Segmentation_cancelled if the
  ///         visitor cancels; all maps are unchanged
  ///
  /// Complexity: that of the parts of the method.
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Segmenter(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values(),
                     ConcurrencyTag = ConcurrencyTag())
    : m_mesh(&mesh)
    , m_prepared(internal::prepare<Method, ConcurrencyTag>(internal::make_mesh_traversal(mesh, internal::pack(np)),
                                                           internal::Preparation::FOR_CHANGES, internal::pack(np)))
  {
    const auto& pack = internal::pack(np);
    internal::check_parameters<std::decay_t<decltype(pack)>, internal::Segmenting_parameters>();
    internal::write_regions(mesh, m_prepared.regions(), pack);
    if constexpr (internal::has_merge_tree<std::decay_t<decltype(pack)>>)
      internal::merge_tree_of(pack) = merge_tree();
  }

  /// Deleted, since a reference to a temporary mesh would dangle.
  template <typename NamedParameters = parameters::Default_named_parameters>
  explicit Segmenter(const FaceGraph&& mesh, const NamedParameters& np = parameters::default_values(),
                     ConcurrencyTag = ConcurrencyTag()) = delete;

  const FaceGraph& mesh() const { return *m_mesh; }
  const Method& method() const { return m_prepared.method(); }

  /// The mesh as arrays.
  const Flat_mesh& flat_mesh() const { return m_prepared.flat_mesh(); }
  /// What segments consist of: the first regions, by face in iteration order, including changes by later constraints and
  /// seeds, and by moving borders (see `Border_straightening`).
  const Partition& regions() const { return m_prepared.regions(); }

  /// The merges of the first regions, down to one segment for each connected piece, unless the policy ends before or sections
  /// are barred. Only with a method that has one tree for all numbers.
  const Merge_tree& merge_tree() const
  {
    static_assert(Prepared::has_one_tree,
                  "the order of merges of this method depends on the number of segments: it has no tree for all "
                  "numbers, use segment(segment_map, number_of_segments)");
    return m_prepared.merge_tree();
  }

  /// The number of segments that `segment(segment_map)` aims at: the one given to the constructor, or else the one
  /// chosen by the method, once for each change of constraints or seeds.
  std::size_t number_of_segments() const
  {
    static_assert(Prepared::has_one_tree,
                  "this method needs the number of segments: use segment(segment_map, number_of_segments)");
    static_assert(!Prepared::has_one_tree || internal::has_chooser<Method>(),
                  "this method has no NumberChooser: use segment(segment_map, number_of_segments)");
    return m_prepared.number_of_segments();
  }

  /// segments the mesh into the number given to the constructor, or else chosen by the method.
  ///
  /// \tparam FaceSegmentMap a model of `WritablePropertyMap` with the face descriptor as key and an
  ///         integral value type that holds the number of segments
  /// \param segment_map every key is written: ids 0 .. n-1, numbered by the first face
  /// \returns the number n of segments
  ///
  /// Complexity: O(F).
  template <typename FaceSegmentMap>
  std::size_t segment(FaceSegmentMap segment_map) const
  {
    return segment(segment_map, number_of_segments());
  }

  /// segments the mesh into a given number, or the nearest possible one; see `segment()`.
  ///
  /// For more segments than `regions()`, these are split if their initializer supports it, in O(F log F).
  ///
  /// \param segment_map every key is written: ids 0 .. n-1, numbered by the first face
  /// \param number_of_segments at least 1
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{follows the progress, and can cancel: stages that a method repeats for each number}
  ///     \cgalParamType{a model of `SegmentationVisitor`}
  ///     \cgalParamDefault{none}
  ///     \cgalParamExtra{pass it by `std::ref()` if it changes}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \returns the number n of segments; see `segment()`. It is at least the number of connected components, and that of
  ///          different seeds
  /// \pre `number_of_segments` is at least 1; see `segment()`
  /// \throws Segmentation_cancelled if the visitor cancels; the map is unchanged
  ///
  /// Complexity: O(F) with a method that has one tree for all numbers, else that of merging.
  template <typename FaceSegmentMap, typename NamedParameters = parameters::Default_named_parameters>
  std::size_t segment(FaceSegmentMap segment_map, std::size_t number_of_segments,
                      const NamedParameters& np = parameters::default_values()) const
  {
    CGAL_precondition_msg(number_of_segments >= 1, "number_of_segments is at least 1");
    const auto& pack = internal::pack(np);
    internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<CGAL::internal_np::visitor_t>>();
    const internal::Segments segments = m_prepared.segments(number_of_segments, pack);
    segments.visit([&](const auto& labels) { write_face_values(*m_mesh, labels, segment_map); });
    return segments.number();
  }

  /// adds edges that are always borders and are never merged across to those that are constrained already.
  ///
  /// First regions are split only where the edges separate their faces, and only the new regions are annotated; so the
  /// segments may differ from those of a new segmenter. An edge that has the same region on both sides afterwards has
  /// no effect; one between two regions bars their section from being merged across.
  ///
  /// \tparam EdgeIsConstrainedMap a model of `ReadablePropertyMap` with the edge descriptor as key and a value type
  ///         that is convertible to `bool`
  /// \param edge_is_constrained_map whether an edge becomes constrained
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{follows the progress, and can cancel}
  ///     \cgalParamType{a model of `SegmentationVisitor`}
  ///     \cgalParamDefault{none}
  ///     \cgalParamExtra{pass it by `std::ref()` if it changes}
  ///   \cgalParamNEnd
  ///   \cgalParamIndexMap{face}
  ///   \cgalParamIndexMap{vertex}
  /// \cgalNamedParamsEnd
  ///
  /// \throws Invalid_input if the edges separate equal seeds, Segmentation_cancelled if the visitor cancels; nothing
  ///         has changed then
  ///
  /// Complexity: O(F), and that of annotating the new regions and of merging.
  template <typename EdgeIsConstrainedMap, typename NamedParameters = parameters::Default_named_parameters>
  void add_constraints(EdgeIsConstrainedMap edge_is_constrained_map,
                       const NamedParameters& np = parameters::default_values())
  {
    static_assert(internal::check_edge_map<EdgeIsConstrainedMap, FaceGraph>());
    const auto& pack = internal::pack(np);
    internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<CGAL::internal_np::visitor_t>>();
    std::vector<Flat_mesh::Index> dual_edges;
    internal::make_mesh_traversal(*m_mesh, pack)
      .for_each_dual_edge_if(
        flat_mesh(), [&](const auto& e) { return bool(get(edge_is_constrained_map, e)); },
        [&](const auto&, std::size_t dual_edge) { dual_edges.push_back(Flat_mesh::Index(dual_edge)); });
    m_prepared.add_constraints(dual_edges, pack);
  }

  /// replaces the seeds: faces with equal seeds belong to one segment, faces with different seeds to different ones.
  ///
  /// The number of different seeds is the least number of segments, that of the first regions with seeds the largest: the
  /// initializer splits them no further. Equal seeds that are not adjacent are joined along
  /// the cheapest path of regions, or, if there is none, of faces, that avoids all other seeds: a step costs about its
  /// length, and 80 times as much for each radian of the deviation of concave edges that it crosses.
  ///
  /// \tparam FaceSeedMap a model of `ReadablePropertyMap` with the face descriptor as key and an integral value type;
  ///         the value `std::size_t(-1)`, after conversion to `std::size_t`, stands for no seed
  /// \param face_seed_map the seed of a face
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{follows the progress, and can cancel}
  ///     \cgalParamType{a model of `SegmentationVisitor`}
  ///     \cgalParamDefault{none}
  ///     \cgalParamExtra{pass it by `std::ref()` if it changes}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \throws Invalid_input if equal seeds are in different components, or separated by constraints or by other seeds;
  ///         Segmentation_cancelled if the visitor cancels; nothing has changed then
  ///
  /// Complexity: O(F), and that of annotating the new regions and of merging.
  template <typename FaceSeedMap, typename NamedParameters = parameters::Default_named_parameters>
  void set_seeds(FaceSeedMap face_seed_map, const NamedParameters& np = parameters::default_values())
  {
    static_assert(!internal::Method_traits<Method>::is_partitioning,
                  "a method with a GraphPartitioner takes no seeds");
    const auto& pack = internal::pack(np);
    internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<CGAL::internal_np::visitor_t>>();
    m_prepared.set_seeds(internal::read_seeds(*m_mesh, face_seed_map), pack);
  }

private:
  const FaceGraph* m_mesh;
  Prepared m_prepared;
};

template <typename FaceGraph>
Segmenter(const FaceGraph&) -> Segmenter<FaceGraph>;
template <typename FaceGraph, typename NamedParameters>
Segmenter(const FaceGraph&, const NamedParameters&) -> Segmenter<FaceGraph, internal::Method_of_pack<NamedParameters>>;
template <typename FaceGraph, typename NamedParameters, typename ConcurrencyTag>
Segmenter(const FaceGraph&, const NamedParameters&, ConcurrencyTag)
  -> Segmenter<FaceGraph, internal::Method_of_pack<NamedParameters>, ConcurrencyTag>;

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTER_H
