// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTER_H
#define CGAL_REGION_SEGMENTATION_SEGMENTER_H

#include <CGAL/Region_segmentation/Graph/internal/run_method.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Face_graph_input.h>
#include <CGAL/Region_segmentation/Surface/internal/Polygon_input.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMain
/// What `Segmenter` and `Polygon_soup_segmenter` have in common: an input that is prepared once and
/// can then be segmented into any number of segments.
///
/// Preparing reads the input and does what does not depend on seeds. If the order of merges of the
/// method does not depend on the number of segments, the regions are also merged: each number of
/// segments then takes only the time of writing labels, and the segmentations are nested. With
/// another method (`Two_step`) each call of `segment()` merges.
///
/// Coordinates are read once: later changes of points have no effect.
///
/// Segmenting is `const`, and thread-safe with different maps. Adding constraints or seeds requires
/// exclusive access. A segmenter can be moved and copied.
///
/// Bytes, with the default method: about 180 per face.
///
/// Only the constructor runs in parallel; what is asked for later, and constraints and seeds that
/// are added, on one thread.
///
/// \tparam Method a model of `SegmentationMethod`
template <typename Input, typename Method>
class Segmenter_base
{
  static_assert(internal::check_method<Method>());
  using Calls = internal::Method_calls<Method>;

public:
  /// Whether the order of merges of the method depends on the number of segments: then each number
  /// is merged anew, and there is neither a number that is chosen nor one tree for all.
  static constexpr bool needs_number = internal::needs_number<Method>();

  const Method& method() const { return m_prepared->method; }

  /// The mesh as arrays; with a method that has `smooths_noise`, without its noise.
  const Surface& surface() const { return m_prepared->surface; }

  /// What segments consist of: the first regions as seeds change them, with their
  /// borders moved (see `Border_straightening`), by face in iteration order. Only with a method
  /// that has one tree for all numbers.
  const Partition& regions() const { return merged().regions(); }

  /// The merges of `regions()`, down to one segment, unless the policy ends before or sections are
  /// barred. Only with a method that has one tree for all numbers.
  const Merge_tree& merge_tree() const { return merged().merge_tree(); }

  /// The number of segments that `segment(segment_map)` aims at: the one given to the constructor,
  /// or else the one chosen by the method, once for each change of constraints or seeds.
  std::size_t number_of_segments() const
  {
    static_assert(
      !needs_number,
      "this method needs the number of segments: use segment(segment_map, number_of_segments)");
    if constexpr (!needs_number)
      return m_merged.number_of_segments();
  }

  /// segments the mesh into the number given to the constructor, or else chosen by the method.
  ///
  /// \param segment_map see `segment()`: every key is written, ids 0 .. n-1, numbered by the first
  ///        face
  /// \returns the number n of segments
  ///
  /// Complexity: O(F).
  template <typename SegmentMap>
  std::size_t segment(SegmentMap&& segment_map) const
  {
    return write(segments_of(number_of_segments(), Execution()), segment_map);
  }

  /// segments the mesh into a given number, or the nearest possible one; see `segment()`.
  ///
  /// A method with one tree for all numbers gives at most as many segments as there are
  /// `regions()`. `Learned_merging` and `Visibility_merging` make twice as many as the number given
  /// to the constructor, at least some 480, on a mesh of at least as many faces: so the largest
  /// number that will be asked for is to be given there.
  ///
  /// \param segment_map every key is written: ids 0 .. n-1, numbered by the first face
  /// \param number_of_segments an integer, at least 1
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters": `visitor`,
  ///        for a method that merges for each number
  ///
  /// \returns the number n of segments; see `segment()`
  /// \pre `number_of_segments` is at least 1; see `segment()`
  /// \throws Segmentation_cancelled if the visitor cancels; the map is unchanged
  ///
  /// Complexity: O(F) with a method that has one tree for all numbers; else that of merging.
  template <typename SegmentMap, typename Number,
            typename NamedParameters = parameters::Default_named_parameters>
  std::size_t segment(SegmentMap&& segment_map, Number number_of_segments,
                      const NamedParameters& np = parameters::default_values()) const
  {
    static_assert(std::is_integral<Number>::value, "the number of segments is an integer");
    CGAL_precondition_msg(number_of_segments >= 1, "number_of_segments is at least 1");
    return write(segments_of(std::size_t(number_of_segments), execution_of_request(np)),
                 segment_map);
  }

  /// adds edges that are always borders and are never merged across to those that are constrained
  /// already.
  ///
  /// The mesh is prepared anew, so the segments are those of a new segmenter with all constraints.
  /// No first region grows across a constrained edge. One that is inside a region nevertheless,
  /// since its line ends there, has no effect; one between two regions bars their section from
  /// being merged across.
  ///
  /// \param constraints as the named parameter `edge_is_constrained_map` of `segment()`; of a
  ///        polygon soup as `constrained_edges` of `segment_polygon_soup()`
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters": `visitor`,
  ///        `face_index_map`, `vertex_index_map`
  ///
  /// \throws Invalid_input if the edges separate equal seeds, Segmentation_cancelled if the visitor
  ///         cancels; nothing has changed then
  ///
  /// Complexity: that of the constructor without reading. The surface is copied.
  template <typename Constraints, typename NamedParameters = parameters::Default_named_parameters>
  void add_constraints(const Constraints& constraints,
                       const NamedParameters& np = parameters::default_values())
  {
    const Execution execution = execution_of_request(np);
    Surface constrained = surface();
    m_input.add_constraints(constrained, constraints, internal::pack(np));
    auto prepared = std::make_shared<const Prepared>(method(), std::move(constrained),
                                                     m_request.number_of_segments, execution);
    m_merged = merge(*prepared, m_request, execution);
    m_prepared = std::move(prepared);
  }

  /// replaces the seeds: faces with equal seeds belong to one segment, faces with different seeds
  /// to different ones.
  ///
  /// The number of different seeds is the least number of segments. Equal seeds that are not
  /// adjacent are joined along the cheapest path of faces that avoids all other seeds: a step costs
  /// its length, and 80 times as much for each radian of the deviation of a concave edge that it
  /// crosses.
  ///
  /// \param face_seed_map the seed of a face: as the named parameter of `segment()`
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters": `visitor`
  ///
  /// \throws Invalid_input if equal seeds are separated by constraints or by other seeds, or in
  ///         components without links; Segmentation_cancelled if the visitor cancels; nothing has
  ///         changed then
  ///
  /// Complexity: O(F log F) for each seed at worst, and that of annotating the regions and of
  /// merging.
  template <typename FaceSeedMap, typename NamedParameters = parameters::Default_named_parameters>
  void set_seeds(const FaceSeedMap& face_seed_map,
                 const NamedParameters& np = parameters::default_values())
  {
    const Execution execution = execution_of_request(np);
    Request request = m_request;
    request.seeds = internal::read_seeds(m_input, face_seed_map);
    m_merged = merge(*m_prepared, request, execution);
    m_request = std::move(request);
  }

protected:
  /// `read_surface(execution)`: reads the input, without its constraints
  template <typename Pack, typename ReadSurface>
  Segmenter_base(Input input, const Pack& np, const Execution& execution,
                 const ReadSurface& read_surface)
    : m_input(std::move(input))
    , m_request(internal::request_of_pack(m_input, np))
    , m_prepared(std::make_shared<const Prepared>(
        internal::method_of_pack<Method>(np),
        Calls::smoothed(internal::constrained(m_input, read_surface(execution), np), execution),
        m_request.number_of_segments, execution))
    , m_merged(merge(*m_prepared, m_request, execution))
  {
    internal::check_parameters<Pack, internal::Segmenting_parameters<Input>>();
    static_assert(!needs_number ||
                    !internal::has_parameter<Pack, internal_np::number_of_segments_t>,
                  "this method merges for each number: give it to "
                  "segment(segment_map, number_of_segments)");
    if constexpr (internal::has_outputs<Pack>)
      internal::write_outputs(m_input, merged(), np);
  }

  const Input& input() const { return m_input; }

private:
  /// The merges, which are made again only if constraints or seeds change.
  using Merged = std::conditional_t<needs_number, std::monostate, typename Calls::Merged>;

  /// The prepared surface, which only `add_constraints()` replaces. Copies of a segmenter share it.
  struct Prepared
  {
    Method method;
    Surface surface;
    typename Calls::Prepared prepared;

    Prepared(Method m, Surface s, std::size_t number, const Execution& execution)
      : method(std::move(m))
      , surface(std::move(s))
      , prepared(Calls::prepare(method, surface, number, execution))
    {}
  };

  /// Makes the execution of a later call, for which `visitor` is the only named parameter.
  template <typename NamedParameters>
  static Execution execution_of_request(const NamedParameters& np)
  {
    const auto& pack = internal::pack(np);
    internal::check_parameters<std::decay_t<decltype(pack)>,
                               internal::Tag_list<CGAL::internal_np::visitor_t>>();
    return internal::make_execution<CGAL::Sequential_tag>(pack);
  }

  static Merged merge(const Prepared& p, const Request& request, const Execution& execution)
  {
    if constexpr (needs_number) {
      if (!request.seeds.empty()) { // reports seeds that cannot be joined, by the least work
        Request any = request;
        any.number_of_segments = (std::max)(p.surface.number_of_faces(), std::size_t(1));
        Calls::merge(p.method, p.surface, p.prepared, any, execution);
      }
      return Merged();
    } else
      return Calls::merge(p.method, p.surface, p.prepared, request, execution);
  }

  const auto& merged() const
  {
    static_assert(!needs_number, "the order of merges of this method depends on the number of "
                                 "segments: it has no tree for all "
                                 "numbers, use segment(segment_map, number_of_segments)");
    return m_merged;
  }

  Partition segments_of(std::size_t number, const Execution& execution) const
  {
    if constexpr (needs_number) {
      Request request = m_request;
      request.number_of_segments = number;
      return Calls::merge(method(), surface(), m_prepared->prepared, request, execution)
        .segments(number);
    } else
      return m_merged.segments(number);
  }

  template <typename SegmentMap>
  std::size_t write(const Partition& segments, SegmentMap& segment_map) const
  {
    m_input.write(segments, segment_map);
    return segments.number_of_parts();
  }

  Input m_input;
  Request m_request;
  std::shared_ptr<const Prepared> m_prepared;
  Merged m_merged;
};

/// \ingroup PkgRegionSegmentationMain
/// A mesh that is prepared once and can then be segmented into any number of segments.
///
/// The segmenter refers to the mesh, whose faces must not change afterwards. Template arguments are
/// deduced: `Segmenter segmenter(mesh, parameters::method(m))`.
///
/// \tparam FaceGraph see `segment()`
/// \tparam Method a model of `SegmentationMethod`; the default needs its header,
///         `Superfacets/Learned_merging.h` or that of the package
template <typename FaceGraph, typename Method = Learned_merging>
class Segmenter : public Segmenter_base<internal::Face_graph_input<FaceGraph>, Method>
{
  using Input = internal::Face_graph_input<FaceGraph>;

public:
  /// prepares a mesh, which must exist as long as the segmenter.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`; see `segment()`
  /// \param mesh see `segment()`
  /// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters": those of
  ///        `segment()`. `number_of_segments` is the number for `segment(segment_map)`, not with a
  ///        method whose order of merges depends on the number; `visitor` follows the constructor
  ///
  /// \throws Invalid_input if a point is not finite, equal seeds cannot be joined, or the type of
  ///         `region_map` does not hold the labels; Invalid_method if a constant of the method is
  ///         not in its range; Segmentation_cancelled if the visitor cancels; all maps are
  ///         unchanged
  ///
  /// Complexity: that of the method.
  template <typename NamedParameters = parameters::Default_named_parameters,
            typename ConcurrencyTag = CGAL::Sequential_tag>
  explicit Segmenter(const FaceGraph& mesh,
                     const NamedParameters& np = parameters::default_values(),
                     ConcurrencyTag = ConcurrencyTag())
    : Segmenter::Segmenter_base(Input(mesh), internal::pack(np),
                                internal::make_execution<ConcurrencyTag>(internal::pack(np)),
                                [&](const Execution& execution) {
                                  return internal::make_surface(mesh, internal::pack(np),
                                                                execution);
                                })
  {}

  /// Deleted, since a reference to a temporary mesh would dangle.
  template <typename NamedParameters = parameters::Default_named_parameters,
            typename ConcurrencyTag = CGAL::Sequential_tag>
  explicit Segmenter(FaceGraph&& mesh, const NamedParameters& np = parameters::default_values(),
                     ConcurrencyTag = ConcurrencyTag()) = delete;

  const FaceGraph& mesh() const { return this->input().mesh(); }
};

// The guides have the parameters of the constructors, so that they are preferred to the implicit
// ones, which have the default method.
template <typename FaceGraph, typename NamedParameters = parameters::Default_named_parameters,
          typename ConcurrencyTag = CGAL::Sequential_tag>
Segmenter(const FaceGraph&, const NamedParameters& = parameters::default_values(),
          ConcurrencyTag = ConcurrencyTag())
  -> Segmenter<FaceGraph, internal::Method_of_parameters<NamedParameters>>;

/// \ingroup PkgRegionSegmentationMain
/// Points and polygons that are prepared once and can then be segmented into any number of
/// segments. They are not referred to afterwards.
///
/// The template argument is deduced: `Polygon_soup_segmenter segmenter(points, polygons)`.
///
/// \tparam Method a model of `SegmentationMethod`, see `Segmenter`
template <typename Method = Learned_merging>
class Polygon_soup_segmenter : public Segmenter_base<internal::Polygon_input, Method>
{
  using Input = internal::Polygon_input;

public:
  /// prepares points and polygons; see `segment_polygon_soup()`, and the constructor of `Segmenter`
  /// for the named parameters.
  template <typename PointRange, typename PolygonRange,
            typename NamedParameters = parameters::Default_named_parameters,
            typename ConcurrencyTag = CGAL::Sequential_tag>
  Polygon_soup_segmenter(const PointRange& points, const PolygonRange& polygons,
                         const NamedParameters& np = parameters::default_values(),
                         ConcurrencyTag = ConcurrencyTag())
    : Polygon_soup_segmenter::Segmenter_base(
        Input(std::size_t(std::distance(std::begin(polygons), std::end(polygons)))),
        internal::pack(np), internal::make_execution<ConcurrencyTag>(internal::pack(np)),
        [&](const Execution& execution) {
          return internal::make_surface_of_polygon_soup(points, polygons, internal::pack(np),
                                                        execution);
        })
  {}
};

template <typename PointRange, typename PolygonRange,
          typename NamedParameters = parameters::Default_named_parameters,
          typename ConcurrencyTag = CGAL::Sequential_tag>
Polygon_soup_segmenter(const PointRange&, const PolygonRange&,
                       const NamedParameters& = parameters::default_values(),
                       ConcurrencyTag = ConcurrencyTag())
  -> Polygon_soup_segmenter<internal::Method_of_parameters<NamedParameters>>;

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTER_H
