// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_SEEDS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_SEEDS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Key_numbering.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The seeds of faces or regions: elements with the same number belong to one segment, elements with different numbers
/// to different ones.
struct Seeds
{
  using Index = Partition::Index;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  std::vector<Index> of;           // by element: 0 .. number() - 1, or none
  std::vector<std::size_t> values; // of the user's map, by seed

  std::size_t number() const { return values.size(); }
  bool empty() const { return values.empty(); }
};

/// The seeds of faces, from the values of a map; `std::size_t(-1)` stands for none.
template <typename Value>
Seeds make_seeds(const std::vector<Value>& values)
{
  constexpr std::size_t no_seed = (std::numeric_limits<std::size_t>::max)();
  Seeds seeds;
  Key_numbering number(2 * values.size() + 1024);
  seeds.of.reserve(values.size());
  for (const Value v : values) {
    const std::size_t value = std::size_t(v);
    seeds.of.push_back(value == no_seed ? Seeds::Index(Seeds::none) : number(value));
    if (seeds.values.size() < number.size())
      seeds.values.push_back(value);
  }
  return seeds;
}

/// Bars the sections between regions of different seeds, while regions are merged.
class Seed_barriers
{
public:
  explicit Seed_barriers(Seeds of_regions) : m_seeds(std::move(of_regions)) {}

  template <typename Graph>
  void bar_sections(Graph& graph) const
  {
    if (!m_seeds.empty())
      for (auto range = edges(graph); range.first != range.second; ++range.first)
        bar_if_between_seeds(graph, *range.first);
  }

  template <typename Graph>
  void on_merge(Graph& graph, const typename Graph::Merge& merge)
  {
    if (m_seeds.empty())
      return;
    Seeds::Index& kept = m_seeds.of[merge.kept];
    if (kept == Seeds::none)
      kept = m_seeds.of[merge.removed];
    if (kept != Seeds::none)
      for (auto s : graph.sections(merge.kept))
        bar_if_between_seeds(graph, s);
  }

private:
  template <typename Graph, typename Section>
  void bar_if_between_seeds(Graph& graph, Section s) const
  {
    const Seeds::Index a = m_seeds.of[graph.source(s)], b = m_seeds.of[graph.target(s)];
    if (a != b && a != Seeds::none && b != Seeds::none)
      graph.forbid_merge(s);
  }

  Seeds m_seeds; // of the regions
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_SEEDS_H
