// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_PREPARED_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_PREPARED_MESH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/segmenting/check_method.h>
#include <CGAL/Region_segmentation/internal/graph/build_graph.h>
#include <CGAL/Region_segmentation/internal/graph/merge.h>
#include <CGAL/Region_segmentation/internal/graph/renumber_tree.h>
#include <CGAL/Region_segmentation/internal/segmenting/Seeds.h>
#include <CGAL/Region_segmentation/internal/segmenting/apply_seeds.h>
#include <CGAL/Region_segmentation/internal/segmenting/matching_parts.h>
#include <CGAL/Region_segmentation/internal/segmenting/split_at_constraints.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>
#include <CGAL/Region_segmentation/merge_regions.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The segment of every face, through its region; or directly, if regions were split.
class Segments
{
  /// The labels of faces through their regions.
  struct Labels_by_region
  {
    const Partition::Index *region_of_face, *segment_of_region;

    Partition::Index operator[](std::size_t face) const { return segment_of_region[region_of_face[face]]; }
  };

public:
  Segments(const Partition& regions, Partition of_regions) : m_regions(&regions), m_parts(std::move(of_regions)) {}
  explicit Segments(Partition of_faces) : m_parts(std::move(of_faces)) {}

  std::size_t number() const { return m_parts.number_of_parts(); }

  /// Calls `f(labels)`, which are indexed by face.
  template <typename F>
  void visit(const F& f) const
  {
    if (m_regions)
      f(Labels_by_region{m_regions->data(), m_parts.data()});
    else
      f(m_parts);
  }

private:
  const Partition* m_regions = nullptr;
  Partition m_parts;
};

/// What a prepared mesh is used for: the segments of one number alone, these and its regions and merges, or any number and
/// changes of constraints and seeds.
enum class Preparation { FOR_ONE_NUMBER, FOR_ONE_USE, FOR_CHANGES };

/// A mesh prepared by a method for any number of segments: the mesh as arrays, its first regions, and, depending on the
/// method, their merge tree or their graph. Independent of the mesh type.
template <typename Method, typename ConcurrencyTag>
class Prepared_mesh
{
  static_assert(check_method<Method>());
  using Traits = Method_traits<Method>;
  using Graph = typename Traits::Graph;
  using Cache = typename Cache_of<typename Traits::Annotator>::type;

public:
  /// Whether one merge tree gives every number of segments.
  static constexpr bool has_one_tree = internal::has_one_tree<Method>();

  /// `number`: of segments, 0 if it is to be chosen; `seeds`: of the faces; `np`: a pack with the visitor
  /// \throws Invalid_input if equal seeds cannot be joined, Segmentation_cancelled if the visitor cancels
  template <typename Pack>
  Prepared_mesh(Flat_mesh flat, const Method& method, std::size_t number, Seeds seeds, Preparation preparation,
                const Pack& np)
    : m_flat(std::move(flat))
    , m_method(method)
    , m_number(number)
    , m_preparation(preparation)
    , m_first_regions(
        initialize_regions(m_method.initializer, m_flat, make_execution<ConcurrencyTag>(np, "regions")))
    , m_seeds(std::move(seeds))
  {
    m_result = make_result(m_first_regions, m_seeds, np);
  }

  const Flat_mesh& flat_mesh() const { return m_flat; }
  const Method& method() const { return m_method; }
  /// What segments consist of: the regions that were merged, or those with their borders straightened.
  const Partition& regions() const
  {
    return m_result.straightened_regions ? *m_result.straightened_regions : merged_regions();
  }
  /// \pre `has_one_tree`
  const Merge_tree& merge_tree() const { return m_result.tree; }

  /// The number of segments that was given, or else that which the method has chosen; 0 if it has no chooser.
  std::size_t number_of_segments() const { return number_of_segments(m_result); }

  /// Adds constrained dual edges. On failure nothing changes.
  template <typename Pack>
  void add_constraints(const std::vector<Flat_mesh::Index>& dual_edges, const Pack& np)
  {
    std::vector<Flat_mesh::Index> added;
    for (const Flat_mesh::Index e : dual_edges)
      if (!m_flat.has_flag(e, Flat_mesh::CONSTRAINED)) {
        added.push_back(e);
        m_flat.constrain(e);
      }
    if (added.empty())
      return;
    try {
      Partition first_regions = split_at_constraints(m_flat, m_first_regions);
      m_result = make_result(first_regions, m_seeds, np);
      m_first_regions = std::move(first_regions);
    } catch (...) {
      for (const Flat_mesh::Index e : added)
        m_flat.release(e);
      throw;
    }
  }

  /// Replaces the seeds. On failure nothing changes.
  template <typename Pack>
  void set_seeds(Seeds seeds, const Pack& np)
  {
    m_result = make_result(m_first_regions, seeds, np);
    m_seeds = std::move(seeds);
  }

  /// The segments for a number, or for the nearest possible one.
  template <typename Pack>
  Segments segments(std::size_t number, const Pack& np) const
  {
    if (can_split(number))
      return split(number, np);
    if constexpr (has_one_tree)
      return Segments(regions(), merge_tree().partition_at_count(number));
    else {
      Graph graph = *m_result.graph;
      return Segments(regions(), partition(graph, number, nullptr, np));
    }
  }

  /// As above, for the last call: the graph is not copied. `tree`: receives the merges, unless it is null.
  /// \pre if prepared for one number, `number` is `number_of_segments()`
  template <typename Pack>
  Segments take_segments(std::size_t number, Merge_tree* tree, const Pack& np)
  {
    if (m_result.segments)
      return Segments(std::move(*m_result.segments));
    if constexpr (has_one_tree) {
      if (tree)
        *tree = merge_tree();
      return segments(number, np);
    } else {
      Partition of_regions = partition(*m_result.graph, number, tree, np);
      return can_split(number) ? split(number, np) : Segments(regions(), std::move(of_regions));
    }
  }

private:
  /// The data derived from the first regions and the seeds.
  struct Result
  {
    std::optional<Partition> seeded_regions; // the first regions as seeds split and join them
    Seeds seeds;                             // of the merged regions
    std::optional<Graph> graph;              // unless there is one tree
    Merge_tree tree;                         // of `regions()`
    std::optional<Partition> straightened_regions;
    std::optional<Partition> segments; // of the faces, if prepared for one number whose borders were straightened
    std::size_t chosen_number = 0;     // of segments
    std::optional<Cache> cache; // of the annotator, for `merged_regions()`; empty after a failed change
  };

  const Partition& merged_regions() const
  {
    return m_result.seeded_regions ? *m_result.seeded_regions : m_first_regions;
  }

  template <typename Pack>
  Result make_result(const Partition& first_regions, const Seeds& seeds, const Pack& np)
  {
    Result result;
    if (!seeds.empty()) {
      result.seeded_regions = apply_seeds(m_flat, first_regions, seeds);
      result.seeds = seeds_of_regions(*result.seeded_regions, seeds);
    }
    const Partition& regions = result.seeded_regions ? *result.seeded_regions : first_regions;
    Graph graph = make_graph(regions, result.cache, np);
    if constexpr (has_one_tree) {
      result.tree = merge(graph, 1, [](const Graph&, double) { return false; }, result.seeds, np);
      if constexpr (has_chooser<Method>())
        if (m_number == 0)
          result.chosen_number = choose_number(result.tree);
      if constexpr (straightens_borders)
        straighten_borders(regions, result, np);
    }
    else
      result.graph = std::move(graph);
    return result;
  }

  std::size_t number_of_segments(const Result& result) const { return m_number > 0 ? m_number : result.chosen_number; }

  /// Moves the borders of the regions that were merged, now that it is known which of them are borders of segments. For one
  /// number of segments, no further than it needs.
  template <typename Pack>
  void straighten_borders(const Partition& regions, Result& result, const Pack& np) const
  {
    const std::size_t number = number_of_segments(result);
    const bool is_one_number = m_preparation == Preparation::FOR_ONE_NUMBER && number > 0;
    const std::vector<Partition::Index> labels = m_method.initializer.straighten_borders(
      m_flat, regions, result.tree,
      [&](Partition::Index r) { return !result.seeds.empty() && result.seeds.of[r] != Seeds::none; },
      make_execution<ConcurrencyTag>(np, "borders"), is_one_number ? number : regions.number_of_parts());
    Partition straightened = Partition::from_labels(labels);
    // If there are fewer, the labels are those of regions, which may be split.
    if (is_one_number && straightened.number_of_parts() >= number)
      result.segments = std::move(straightened);
    else
      set_straightened_regions(labels, std::move(straightened), result);
  }

  /// `labels`: by face, the former number of its region
  static void set_straightened_regions(const std::vector<Partition::Index>& labels, Partition straightened, Result& result)
  {
    constexpr Partition::Index none = (std::numeric_limits<Partition::Index>::max)();
    std::vector<Partition::Index> new_numbers(result.tree.number_of_regions(), none);
    for (std::size_t f = 0; f < labels.size(); ++f)
      new_numbers[labels[f]] = straightened[f];
    result.tree = renumber_tree(result.tree, std::move(new_numbers));
    result.straightened_regions = std::move(straightened);
  }

  std::size_t choose_number(const Merge_tree& tree) const
  {
    if constexpr (satisfies<Sees_mesh, decltype(m_method.chooser)>)
      return m_method.chooser(tree, m_flat);
    else
      return m_method.chooser(tree);
  }

  template <typename Pack>
  Graph make_graph(const Partition& regions, std::optional<Cache>& new_cache, const Pack& np)
  {
    const auto execution = make_execution<ConcurrencyTag>(np, "graph");
    Graph graph = build_graph<Graph>(m_flat, regions, execution.step(0, 0.1));
    Cache cache = take_cache(regions);
    annotate(m_method.annotator, graph, m_flat, regions, execution.step(0.1, 1), cache);
    if (m_preparation == Preparation::FOR_CHANGES)
      new_cache = std::move(cache);
    return graph;
  }

  /// The cached data of regions, renumbered for new regions. It is moved out: if annotating fails, it is computed
  /// again.
  Cache take_cache(const Partition& regions)
  {
    if constexpr (std::is_same<Cache, No_cache>::value)
      return Cache();
    else {
      if (!m_result.cache)
        return Cache();
      Cache cache = std::move(*std::exchange(m_result.cache, std::nullopt));
      cache.renumber(matching_parts(merged_regions(), regions));
      return cache;
    }
  }

  /// Merges, or partitions, a graph for a number of segments; returns the segments of the regions.
  template <typename Pack>
  Partition partition(Graph& graph, std::size_t number, Merge_tree* tree, const Pack& np) const
  {
    if constexpr (Traits::is_partitioning) {
      static_cast<void>(tree);
      make_execution<ConcurrencyTag>(np, "merging");
      Partition segments = m_method.partitioner(graph, number);
      if (segments.size() != regions().number_of_parts())
        throw Invalid_method("the GraphPartitioner made a partition of " + std::to_string(segments.size()) +
                             " elements for " + std::to_string(regions().number_of_parts()) + " regions");
      return segments;
    } else {
      // Initializing a policy may take quadratic time.
      Merge_tree merges = graph.number_of_regions() <= number
                            ? unmerged(graph, np)
                            : merge(graph, number, Stop_at_count{number}, m_result.seeds, np);
      Partition segments = merges.partition_at_count(number);
      if (tree)
        *tree = std::move(merges);
      return segments;
    }
  }

  template <typename Pack>
  static Merge_tree unmerged(const Graph& graph, const Pack& np)
  {
    make_execution<ConcurrencyTag>(np, "merging");
    return Merge_tree(graph.index_bound_of_regions());
  }

  template <typename Stop, typename Pack>
  Merge_tree merge(Graph& graph, std::size_t number, Stop stop, const Seeds& seeds, const Pack& np) const
  {
    auto policy = m_method.policy;
    Seed_barriers barriers(seeds);
    barriers.bar_sections(graph);
    return internal::merge(
      graph, policy, number, stop, [&](const typename Graph::Merge& merge) { barriers.on_merge(graph, merge); },
      make_execution<ConcurrencyTag>(np, "merging"));
  }

  static constexpr bool splits_regions =
    satisfies<Splits_regions, typename Traits::Initializer, ConcurrencyTag>;
  static constexpr bool straightens_borders =
    satisfies<Straightens_borders, typename Traits::Initializer, ConcurrencyTag>;

  /// Whether there are fewer regions than `number`, and their initializer can split them: not those that equal seeds joined.
  bool can_split(std::size_t number) const
  {
    return splits_regions && m_result.seeds.empty() && number > regions().number_of_parts();
  }

  template <typename Pack>
  Segments split(std::size_t number, const Pack& np) const
  {
    if constexpr (splits_regions)
      return Segments(m_method.initializer.split(m_flat, regions(), number, make_execution<ConcurrencyTag>(np, "regions")));
    else
      return Segments(Partition());
  }

  Flat_mesh m_flat;
  Method m_method;
  std::size_t m_number; // of segments, as given; 0: to be chosen
  Preparation m_preparation;
  Partition m_first_regions; // as the initializer made them and later constraints split them
  Seeds m_seeds;             // of the faces
  Result m_result;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_PREPARED_MESH_H
