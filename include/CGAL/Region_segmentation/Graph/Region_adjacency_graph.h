// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_REGION_ADJACENCY_GRAPH_H
#define CGAL_REGION_SEGMENTATION_GRAPH_REGION_ADJACENCY_GRAPH_H

#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/Graph/internal/Section_lists.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <boost/graph/adjacency_iterator.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// A section as seen from one of its two regions. Both descriptors of a section compare equal.
class Section_descriptor
{
public:
  Section_descriptor() = default;
  explicit Section_descriptor(std::uint32_t half)
    : m_half(half)
  {}

  /// The index of the section.
  std::uint32_t id() const { return m_half / 2; }
  /// The index of the section as seen from one region: 2 `id()` or 2 `id()` + 1.
  std::uint32_t half() const { return m_half; }

  friend bool operator==(Section_descriptor a, Section_descriptor b) { return a.id() == b.id(); }
  friend bool operator!=(Section_descriptor a, Section_descriptor b) { return a.id() != b.id(); }
  friend bool operator<(Section_descriptor a, Section_descriptor b) { return a.id() < b.id(); }
  friend std::size_t hash_value(Section_descriptor s) { return s.id(); }

private:
  std::uint32_t m_half = (std::numeric_limits<std::uint32_t>::max)();
};

/// \ingroup PkgRegionSegmentationPolicies
/// The section across which a policy proposes to merge next, and its cost in the units of the
/// policy.
struct Merge_candidate
{
  Section_descriptor section;
  double cost; ///< a number, possibly infinite
};

/// \ingroup PkgRegionSegmentationPolicies
/// A sequence of policies, each with the number of regions at which the next policy takes over. All
/// functions that merge by a policy take such a sequence, too. Merging ends when the current policy
/// has no further candidate.
///
/// \code
/// RS::merge_regions(graph, RS::Policy_phases<RS::Smallest_region_first, My_policy>{
///                            {RS::Smallest_region_first(), 100}, {My_policy(), 1}}, 8);
/// \endcode
///
/// \tparam Policies models of `MergingPolicy`
template <typename... Policies>
using Policy_phases = std::tuple<std::pair<Policies, std::size_t>...>;
namespace internal {

template <typename Graph>
struct Is_there
{
  const Graph* graph = nullptr;

  template <typename Descriptor>
  bool operator()(Descriptor d) const
  {
    return !graph->is_removed(d);
  }
};

/// Returns a section as seen from the region of one of its halves.
struct Section_of_half
{
  Section_descriptor operator()(std::uint32_t half) const { return Section_descriptor(half); }
};
/// Returns a section as seen from the region of its first half.
struct Section_of_number
{
  Section_descriptor operator()(std::uint32_t s) const { return Section_descriptor(2 * s); }
};

using Number_iterator = boost::counting_iterator<std::uint32_t>;
template <typename Graph>
using Region_iterator = boost::filter_iterator<Is_there<Graph>, Number_iterator>;
template <typename Graph>
using Section_iterator = boost::filter_iterator<
  Is_there<Graph>, boost::transform_iterator<Section_of_number, Number_iterator>>;
template <typename Graph>
using Out_section_iterator = boost::filter_iterator<
  Is_there<Graph>, boost::transform_iterator<Section_of_half, const std::uint32_t*>>;

/// Returns the part of a range of numbers, or of halves of sections, whose sections and regions are
/// not removed.
template <typename Iterator, typename Graph, typename Base>
std::pair<Iterator, Iterator> remaining(const Graph& graph, const Base& begin, const Base& end)
{
  using All = std::decay_t<decltype(std::declval<const Iterator&>().base())>;
  const Is_there<Graph> is_there{&graph};
  return {Iterator(is_there, All(begin), All(end)), Iterator(is_there, All(end), All(end))};
}

} // namespace internal

/// \ingroup PkgRegionSegmentationGraph
/// Regions and the sections between them, with data on both; two regions can be merged across a
/// section.
///
/// A model of Boost.Graph's `VertexListGraph`, `EdgeListGraph`, `IncidenceGraph` and
/// `AdjacencyGraph` (undirected, no parallel edges, no loops): a region is a vertex, a section is
/// an edge. As in \cgal, `num_vertices()` and `num_edges()` are upper bounds after merges: indices,
/// in `[0, num_vertices())`, are not reused, and the descriptors of remaining elements stay valid.
/// `number_of_regions()` and `number_of_sections()` count the remaining ones.
///
/// `merge()` takes time in proportion to the number of sections of the region that has fewer,
/// unless both regions of these have many. Bytes, without the data: 84 per region and 9 per
/// section; more for regions with more than 12 sections.
///
/// \tparam RegionData_ a model of `RegionData`
/// \tparam SectionData_ a model of `SectionData`
template <typename RegionData_ = Region_geometry, typename SectionData_ = Section_geometry>
class Region_adjacency_graph
{
  using Self = Region_adjacency_graph;
  using Index = std::uint32_t;
  using Lists = internal::Section_lists<SectionData_>;

public:
  using RegionData = RegionData_;
  using SectionData = SectionData_;

  using region_descriptor = Index;
  using section_descriptor = Section_descriptor;

  /// \name Boost.Graph
  /// @{
  struct traversal_category : public virtual boost::incidence_graph_tag,
                              public virtual boost::adjacency_graph_tag,
                              public virtual boost::vertex_list_graph_tag,
                              public virtual boost::edge_list_graph_tag
  {};
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using vertex_descriptor = region_descriptor;
  using edge_descriptor = section_descriptor;
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using vertex_iterator = internal::Region_iterator<Self>;
  using edge_iterator = internal::Section_iterator<Self>;
  using out_edge_iterator = internal::Out_section_iterator<Self>;
  using adjacency_iterator = boost::adjacency_iterator<Self, Index, out_edge_iterator,
                                                       std::ptrdiff_t>;
  static vertex_descriptor null_vertex() { return none; }
  /// @}

  /// The result of a merge: `kept` is the lower of the two ids.
  struct Merge
  {
    region_descriptor kept, removed;
  };

  /// Makes regions without sections; their ids are 0 .. `number_of_regions` - 1.
  explicit Region_adjacency_graph(std::size_t number_of_regions = 0)
    : m_place_of(number_of_regions)
    , m_lists(number_of_regions)
    , m_region_data(number_of_regions)
    , m_number_of_regions(number_of_regions)
  {
    std::iota(m_place_of.begin(), m_place_of.end(), Index(0));
  }

  /// Adds a region; ids are assigned in order.
  region_descriptor add_region(RegionData data = RegionData())
  {
    const Index r = Index(m_place_of.size());
    m_place_of.push_back(r);
    m_lists.add_place(r);
    m_region_data.push_back(std::move(data));
    ++m_number_of_regions;
    return r;
  }

  /// Adds a section, which is mergeable; ids are assigned in order.
  /// \pre both regions are there, and have no section yet
  section_descriptor add_section(region_descriptor a, region_descriptor b,
                                 SectionData data = SectionData())
  {
    return append_section(a, b, std::move(data), ADJACENT);
  }

  /// Adds a section between two regions that have no common edge, which keeps data of the pair. It
  /// is not mergeable. When it is united with another section, the result is mergeable if the other
  /// section is.
  /// \pre both regions are there, and have no section yet
  section_descriptor add_nonadjacent_section(region_descriptor a, region_descriptor b,
                                             SectionData data = SectionData())
  {
    return append_section(a, b, std::move(data), 0);
  }

  /// The indices of regions and of sections are below these, removed ones included.
  std::size_t index_bound_of_regions() const { return m_place_of.size(); }
  std::size_t index_bound_of_sections() const { return m_flags.size(); }

  /// Makes a section not mergeable, and every section that absorbs it later.
  void forbid_merge(section_descriptor s) { m_flags[s.id()] |= BARRED; }

  std::size_t number_of_regions() const { return m_number_of_regions; }
  std::size_t number_of_sections() const { return m_number_of_sections; }

  RegionData& operator[](region_descriptor r) { return m_region_data[r]; }
  const RegionData& operator[](region_descriptor r) const { return m_region_data[r]; }
  SectionData& operator[](section_descriptor s) { return m_lists.data(s.id()); }
  const SectionData& operator[](section_descriptor s) const { return m_lists.data(s.id()); }

  bool is_removed(region_descriptor r) const { return m_place_of[r] == none; }
  bool is_removed(section_descriptor s) const { return m_lists.place(s.half()) == none; }
  /// Whether the two regions of a section have a common edge.
  bool is_adjacent(section_descriptor s) const { return (m_flags[s.id()] & ADJACENT) != 0; }
  /// Whether regions may be merged across a section: they are adjacent, and it holds no constrained
  /// edge.
  bool is_mergeable(section_descriptor s) const { return m_flags[s.id()] == ADJACENT; }

  /// The region from which a descriptor sees its section (r, if it comes from `sections(r)`), and
  /// the other region.
  region_descriptor source(section_descriptor s) const { return owner(s.half()); }
  region_descriptor target(section_descriptor s) const { return owner(s.half() ^ 1); }

  std::size_t degree(region_descriptor r) const { return m_lists.degree(m_place_of[r]); }

  /// The sections of a region, each with the region as its source.
  Iterator_range<out_edge_iterator> sections(region_descriptor r) const
  {
    const auto halves = m_lists.halves(m_place_of[r]);
    return internal::remaining<out_edge_iterator>(*this, halves.begin(), halves.end());
  }

  /// The section between two regions, with `a` as its source; empty where there is none. Linear in
  /// the smaller of their degrees.
  std::optional<section_descriptor> section(region_descriptor a, region_descriptor b) const
  {
    const Index half = m_lists.find(m_place_of[a], m_place_of[b]);
    return half == none ? std::nullopt : std::optional<section_descriptor>(half);
  }

  /// Merges the two regions of a section. The lower id is kept; its data absorbs that of the other
  /// region, and sections to a common neighbor absorb each other.
  /// \pre the section exists and is mergeable
  Merge merge(section_descriptor s)
  {
    CGAL_precondition_msg(!is_removed(s) && is_mergeable(s),
                          "a section that is removed or not mergeable is not merged across");
    const Merge result{(std::min)(source(s), target(s)), (std::max)(source(s), target(s))};
    m_region_data[result.kept].absorb(m_region_data[result.removed], m_lists.data(s.id()));
    --m_number_of_sections;
    const Index place = m_lists.unite(
      s.id(), m_place_of[result.removed], m_place_of[result.kept],
      [this](Index twin, Index gone) { absorb_section(twin, gone); });
    m_lists.set_owner(place, result.kept);
    m_place_of[result.kept] = place;
    m_place_of[result.removed] = none;
    --m_number_of_regions;
    return result;
  }

private:
  static constexpr Index none = Lists::none;

  /// The flags of a section. A section that absorbs another one also has its flags.
  enum Section_flag : std::uint8_t {
    ADJACENT = 1, ///< it has edges
    BARRED = 2    ///< it must not be merged across
  };

  section_descriptor append_section(region_descriptor a, region_descriptor b, SectionData data,
                                    std::uint8_t flags)
  {
    CGAL_precondition(a != b && !is_removed(a) && !is_removed(b));
    CGAL_precondition(!section(a, b));
    const Index s = Index(m_flags.size());
    m_flags.push_back(flags);
    m_lists.add_section(m_place_of[a], m_place_of[b], std::move(data));
    ++m_number_of_sections;
    return Section_descriptor(2 * s);
  }

  region_descriptor owner(Index half) const { return m_lists.owner(m_lists.place(half)); }

  void absorb_section(Index twin, Index gone)
  {
    m_lists.data(twin).absorb(m_lists.data(gone));
    m_flags[twin] |= m_flags[gone];
    --m_number_of_sections;
  }

  // The sections of a region are in a list that has a place of its own. When two regions are
  // merged, the shorter list is appended to the longer one, whose place the kept region takes: so
  // merging a region of many sections with small ones takes linear time in total.
  std::vector<Index> m_place_of; // by region
  Lists m_lists;
  std::vector<RegionData> m_region_data;
  std::vector<std::uint8_t> m_flags; // by section
  std::size_t m_number_of_regions;
  std::size_t m_number_of_sections = 0;
};

} // namespace Region_segmentation
} // namespace CGAL

namespace std {
template <>
struct hash<CGAL::Region_segmentation::Section_descriptor>
{
  std::size_t operator()(CGAL::Region_segmentation::Section_descriptor s) const { return s.id(); }
};
} // namespace std

#include <CGAL/Region_segmentation/Graph/internal/region_graph_bgl.h>

#endif // CGAL_REGION_SEGMENTATION_GRAPH_REGION_ADJACENCY_GRAPH_H
