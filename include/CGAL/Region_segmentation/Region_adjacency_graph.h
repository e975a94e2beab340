// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_REGION_ADJACENCY_GRAPH_H
#define CGAL_REGION_SEGMENTATION_REGION_ADJACENCY_GRAPH_H

#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Pair_index.h>
#include <CGAL/Region_segmentation/internal/region_graph_iterators.h>
#include <CGAL/Region_segmentation/region_and_section_data.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// Regions and the sections between them, with data on both; two regions can be merged across a
/// section.
///
/// A model of Boost.Graph's `VertexListGraph`, `EdgeListGraph`, `IncidenceGraph` and `AdjacencyGraph`
/// (undirected, no parallel edges, no loops): a region is a vertex, a section is an edge. As in \cgal,
/// `num_vertices()` and `num_edges()` are upper bounds once something was merged: indices, in
/// `[0, num_vertices())`, are not given anew, and the descriptors of what is left stay valid.
/// `number_of_regions()` and `number_of_sections()` count what is left.
///
/// `merge()` takes O(the sections of the region that has fewer) expected time. Bytes: 26 a region and 33
/// to 40 a section, beside the data.
///
/// \tparam RegionData_ a model of `RegionData`
/// \tparam SectionData_ a model of `SectionData`
template <typename RegionData_ = Region_geometry, typename SectionData_ = Section_geometry>
class Region_adjacency_graph
{
  using Self = Region_adjacency_graph;
  using Index = std::uint32_t;

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
  using adjacency_iterator = internal::Adjacent_region_iterator<Self>;
  static vertex_descriptor null_vertex() { return none; }
  /// @}

  /// What a merge did: `kept` is the lower one of the two ids.
  struct Merge
  {
    region_descriptor kept, removed;
  };

  void reserve(std::size_t regions, std::size_t sections)
  {
    m_place_of.reserve(regions);
    m_region_data.reserve(regions);
    m_places.reserve(regions);
    m_halves.reserve(2 * sections);
    m_section_data.reserve(sections);
    m_is_mergeable.reserve(sections);
  }

  /// Adds a region; ids are given in order.
  region_descriptor add_region(RegionData data = RegionData())
  {
    const Index r = Index(m_place_of.size());
    m_place_of.push_back(r);
    m_places.push_back({r, none, 0});
    m_region_data.push_back(std::move(data));
    ++m_number_of_regions;
    return r;
  }

  /// Adds a section, which is mergeable.
  /// \pre both regions are there, and have no section yet
  section_descriptor add_section(region_descriptor a, region_descriptor b,
                                 SectionData data = SectionData())
  {
    CGAL_precondition(a != b && !is_removed(a) && !is_removed(b));
    CGAL_precondition(!section(a, b));
    const Index s = Index(m_section_data.size());
    m_section_data.push_back(std::move(data));
    m_is_mergeable.push_back(1);
    m_halves.resize(m_halves.size() + 2);
    m_halves[2 * s].place = m_place_of[a];
    m_halves[2 * s + 1].place = m_place_of[b];
    link(2 * s);
    link(2 * s + 1);
    m_index.insert(s, ends());
    ++m_number_of_sections;
    return Section_descriptor(2 * s);
  }

  /// The indices of regions and of sections are below these, removed ones included.
  std::size_t index_bound_of_regions() const { return m_place_of.size(); }
  std::size_t index_bound_of_sections() const { return m_section_data.size(); }

  /// Bars a section, and every section that absorbs it, from merging.
  void forbid_merge(section_descriptor s) { m_is_mergeable[s.id()] = 0; }

  std::size_t number_of_regions() const { return m_number_of_regions; }
  std::size_t number_of_sections() const { return m_number_of_sections; }

  RegionData& operator[](region_descriptor r) { return m_region_data[r]; }
  const RegionData& operator[](region_descriptor r) const { return m_region_data[r]; }
  SectionData& operator[](section_descriptor s) { return m_section_data[s.id()]; }
  const SectionData& operator[](section_descriptor s) const { return m_section_data[s.id()]; }

  bool is_removed(region_descriptor r) const { return m_place_of[r] == none; }
  bool is_removed(section_descriptor s) const { return m_halves[s.half()].place == none; }
  /// Whether regions may be merged across a section: it holds no constrained edge.
  bool is_mergeable(section_descriptor s) const { return m_is_mergeable[s.id()] != 0; }

  /// The region that a descriptor, as it comes from `out_edges(r, g)`, starts from and leads to.
  region_descriptor source(section_descriptor s) const { return owner(s.half()); }
  region_descriptor target(section_descriptor s) const { return owner(s.half() ^ 1); }

  std::size_t degree(region_descriptor r) const { return m_places[m_place_of[r]].degree; }

  /// The sections of a region, each with the region as its source.
  Iterator_range<out_edge_iterator> sections(region_descriptor r) const
  {
    const Place& place = m_places[m_place_of[r]];
    return {out_edge_iterator(*this, place.first_half, place.degree), out_edge_iterator()};
  }

  /// The section between two regions, with `a` as its source; empty where there is none. O(1) expected.
  std::optional<section_descriptor> section(region_descriptor a, region_descriptor b) const
  {
    const Index s = m_index.find({m_place_of[a], m_place_of[b]}, ends());
    if (s == none)
      return std::nullopt;
    return Section_descriptor(owner(2 * s) == a ? 2 * s : 2 * s + 1);
  }

  /// Merges the two regions of a section. The lower id is kept; its data absorbs that of the other
  /// region, and sections to a common neighbor absorb each other.
  /// \pre the section is there and mergeable
  Merge merge(section_descriptor s)
  {
    CGAL_precondition_msg(!is_removed(s) && is_mergeable(s),
                          "a section that is removed, or holds a constrained edge, is not merged");
    const Merge result{(std::min)(source(s), target(s)), (std::max)(source(s), target(s))};
    m_region_data[result.kept].absorb(m_region_data[result.removed], m_section_data[s.id()]);
    remove_section(s.id());

    Index from = m_place_of[result.removed], to = m_place_of[result.kept];
    if (m_places[from].degree > m_places[to].degree)
      std::swap(from, to);
    while (m_places[from].degree > 0)
      move_section(m_places[from].first_half, to);
    m_place_of[result.removed] = none;
    m_place_of[result.kept] = to;
    m_places[to].region = result.kept;
    --m_number_of_regions;
    return result;
  }

private:
  template <typename>
  friend class internal::Out_section_iterator;

  static constexpr Index none = internal::Pair_index::none;

  // Small into large: the sections of a region belong to a place, and the region that is kept takes
  // over the place that has more of them, so that only those of the other place are touched. The
  // index of pairs speaks of places. Section s has the halves 2s and 2s + 1, one in the circular list
  // of each of its places.
  struct Place
  {
    Index region, first_half, degree;
  };
  struct Half
  {
    Index place = none, next = none, previous = none;
  };

  auto ends() const
  {
    return [this](Index s) {
      return internal::Pair_index::Pair(m_halves[2 * s].place, m_halves[2 * s + 1].place);
    };
  }

  region_descriptor owner(Index half) const { return m_places[m_halves[half].place].region; }

  void link(Index half)
  {
    Place& place = m_places[m_halves[half].place];
    if (place.degree++ == 0) {
      place.first_half = m_halves[half].next = m_halves[half].previous = half;
      return;
    }
    const Index next = place.first_half, previous = m_halves[next].previous;
    m_halves[half].next = next;
    m_halves[half].previous = previous;
    m_halves[previous].next = m_halves[next].previous = half;
  }

  void unlink(Index half)
  {
    Place& place = m_places[m_halves[half].place];
    const Half h = m_halves[half];
    m_halves[h.previous].next = h.next;
    m_halves[h.next].previous = h.previous;
    if (--place.degree == 0)
      place.first_half = none;
    else if (place.first_half == half)
      place.first_half = h.next;
  }

  void remove_section(Index s)
  {
    m_index.erase(s, ends());
    unlink(2 * s);
    unlink(2 * s + 1);
    m_halves[2 * s].place = m_halves[2 * s + 1].place = none;
    --m_number_of_sections;
  }

  /// Hangs the section of `half` over to the place `to`, where a section to its other end may be.
  void move_section(Index half, Index to)
  {
    const Index s = half / 2;
    const Index twin = m_index.find({to, m_halves[half ^ 1].place}, ends());
    if (twin != none) {
      m_section_data[twin].absorb(m_section_data[s]);
      m_is_mergeable[twin] = m_is_mergeable[twin] && m_is_mergeable[s];
      remove_section(s);
      return;
    }
    m_index.erase(s, ends());
    unlink(half);
    m_halves[half].place = to;
    link(half);
    m_index.insert(s, ends());
  }

  internal::Large_array<Index> m_place_of; // by region
  internal::Large_array<Place> m_places;
  internal::Large_array<Half> m_halves;
  internal::Large_array<RegionData> m_region_data;
  internal::Large_array<SectionData> m_section_data;
  internal::Large_array<std::uint8_t> m_is_mergeable;
  internal::Pair_index m_index;
  std::size_t m_number_of_regions = 0;
  std::size_t m_number_of_sections = 0;
};

} // namespace Region_segmentation
} // namespace CGAL

#include <CGAL/Region_segmentation/internal/region_graph_bgl.h>

#endif // CGAL_REGION_SEGMENTATION_REGION_ADJACENCY_GRAPH_H
