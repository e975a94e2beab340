// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_BORDER_STRAIGHTENING_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_BORDER_STRAIGHTENING_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Graph/internal/Dual_graph.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Superfacets/Border_cost.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Border_cut.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Moves the borders of the segments of a merge tree to minimum cuts, from its roots down: merges
/// are undone from the last one on, and the border between the two parts of a segment moves within
/// it. So partitions stay nested.
///
/// An element belongs to its region until it moves to another part, or is cut off from the part of
/// its region. From then on it has no region: where its segment is divided, it joins the part with
/// which it has the dearer border. A region can lose all its elements. A part that keeps none but
/// degenerate elements loses these to the other part, if its regions had others at first.
///
/// O((P + R) h) for P elements and R regions in a tree of height h, and the cuts.
class Nested_borders
{
public:
  using Index = Dual_graph::Index;

  /// See `Border_straightening::operator()`; the cells are the elements.
  Nested_borders(const Minimum_cut_borders& borders, const Surface& surface, const Patches& cells,
                 const Requested_regions& requested, const Merge_tree& tree)
    : m_borders(borders)
    , m_unit(surface.length_unit())
    , m_cells(cells)
    , m_requested(requested)
    , m_tree(tree)
    , m_costs(cells, Dual_graph::EDGES_AND_CONTACTS,
              [&](const Patches::Adjacency& a, double deviation) {
                return borders.cost(a.length / m_unit, deviation);
              })
    , m_regions(tree.number_of_regions())
    , m_elements(tree.number_of_regions())
    , m_lost(tree.number_of_regions())
    , m_is_proper_region(tree.number_of_regions())
    , m_part_of(tree.number_of_regions())
    , m_label_of(cells.size())
    , m_component_of(cells.size(), none)
    , m_cut(
        m_costs,
        [&](Index p, Index q) { return norm(cells[p].centroid - cells[q].centroid) / m_unit; },
        m_label_of)
  {
    for (Index r = 0; r < m_regions.size(); ++r)
      m_regions[r] = {r};
    for (const Merge_tree::Merge& merge : tree.merges()) {
      const std::vector<Index> removed = std::exchange(m_regions[merge.removed], {});
      m_numbers_of_removed.push_back(removed.size());
      std::vector<Index>& kept = m_regions[merge.kept];
      kept.insert(kept.end(), removed.begin(), removed.end());
    }
    for (Index segment = 0; segment < m_regions.size(); ++segment)
      for (const Index r : m_regions[segment])
        m_part_of[r] = segment;
    for (Index e = 0; e < cells.size(); ++e) {
      m_region_of.push_back(requested.regions[cells[e].center]);
      m_is_degenerate.push_back(surface.is_degenerate(cells[e].center));
      if (!m_is_degenerate[e])
        m_is_proper_region[m_region_of[e]] = true;
      m_label_of[e] = m_part_of[m_region_of[e]];
      m_elements[m_label_of[e]].push_back(e);
    }
  }

  /// Undoes merges until there are `number_of_segments` that have elements. The borders of the
  /// last `number_of_cuts` merges are moved. Returns, by element, the lowest region of its segment.
  std::vector<Index> run(std::size_t number_of_cuts, std::size_t number_of_segments,
                         const Execution& execution)
  {
    const std::size_t merges = m_tree.merges().size();
    std::size_t segments = m_tree.number_of_regions() - merges;
    Step_counter undone(execution, (std::min)(merges, number_of_segments));
    for (std::size_t i = merges; i-- > 0 && segments < number_of_segments;) {
      const Index a = m_tree.merges()[i].kept, b = m_tree.merges()[i].removed;
      std::vector<Index> elements = std::move(m_elements[a]);
      divide_regions(a, b, m_numbers_of_removed[i]);
      divide(elements, a, b);
      if (merges - i <= number_of_cuts)
        move_border(elements, a, b);
      join_if_degenerate(elements, a, b);
      join_if_degenerate(elements, b, a);
      const auto of_b = std::stable_partition(elements.begin(), elements.end(),
                                              [&](Index e) { return m_label_of[e] == a; });
      m_elements[b].assign(of_b, elements.end());
      elements.erase(of_b, elements.end());
      segments += std::size_t(!elements.empty() && !m_elements[b].empty());
      m_elements[a] = std::move(elements);
      undone.advance();
    }
    return std::move(m_label_of);
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// The share of the area of the surface.
  double area(Index element) const { return m_cells[element].area / m_unit / m_unit; }

  /// Whether the element stays in the segments of its region, of which there is at most one in a
  /// tree.
  bool is_fixed(Index element) const
  {
    return m_region_of[element] != none && m_requested.is_fixed(m_region_of[element]);
  }

  /// Undoes the merge of two parts. The regions of b are the last ones of the segment.
  void divide_regions(Index a, Index b, std::size_t number_of_b)
  {
    const auto of_b = m_regions[a].end() - std::ptrdiff_t(number_of_b);
    m_regions[b].assign(of_b, m_regions[a].end());
    m_regions[a].erase(of_b, m_regions[a].end());
    for (const Index r : m_regions[b])
      m_part_of[r] = b;
  }

  /// Labels the elements of a segment by its two parts, so that each is connected.
  void divide(const std::vector<Index>& elements, Index a, Index b)
  {
    for (const Index e : elements)
      m_label_of[e] = m_region_of[e] == none ? none : m_part_of[m_region_of[e]];
    for (const Index part : {a, b}) {
      std::vector<Index> lost; // by the regions of the part
      for (const Index r : m_regions[part])
        lost.insert(lost.end(), m_lost[r].begin(), m_lost[r].end());
      if (!m_cut.is_connected(part, lost))
        keep_one_component(elements, part);
    }
    std::vector<Index> unlabeled;
    for (const Index e : elements)
      if (m_label_of[e] == none) {
        take_from_region(e);
        unlabeled.push_back(e);
      }
    join_parts(std::move(unlabeled), a, b);
  }

  /// Takes the label from the elements of a part outside of one of its components: the one with
  /// fixed elements, else the largest by area, of equal ones that with the lowest element.
  void keep_one_component(const std::vector<Index>& elements, Index part)
  {
    std::vector<double> areas; // by component
    for (const Index e : elements)
      if (m_label_of[e] == part) {
        if (m_component_of[e] == none) {
          label_component(e, Index(areas.size()));
          areas.push_back(0);
        }
        areas[m_component_of[e]] += is_fixed(e) ? std::numeric_limits<double>::infinity() : area(e);
      }
    const auto largest = std::max_element(areas.begin(), areas.end()) - areas.begin();
    for (const Index e : elements)
      if (m_label_of[e] == part && std::exchange(m_component_of[e], none) != Index(largest))
        m_label_of[e] = none;
  }

  void label_component(Index first, Index component)
  {
    std::vector<Index> reached{first};
    m_component_of[first] = component;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const auto& step : m_costs.steps(reached[i]))
        if (m_label_of[step.face] == m_label_of[first] && m_component_of[step.face] == none) {
          m_component_of[step.face] = component;
          reached.push_back(step.face);
        }
  }

  /// In rounds: elements without a label that are adjacent to a part join the one with the dearer
  /// border, of equal ones the first. If no element is adjacent to a part, all join the first.
  void join_parts(std::vector<Index> unlabeled, Index a, Index b)
  {
    while (!unlabeled.empty()) {
      std::vector<std::pair<Index, Index>> joined; // element, part
      for (const Index e : unlabeled) {
        const double to_a = border_cost(e, a), to_b = border_cost(e, b);
        if (to_a >= 0 || to_b >= 0)
          joined.push_back({e, to_a >= to_b ? a : b});
      }
      if (joined.empty())
        for (const Index e : unlabeled)
          joined.push_back({e, a});
      for (const auto& [e, part] : joined)
        m_label_of[e] = part;
      unlabeled.erase(std::remove_if(unlabeled.begin(), unlabeled.end(),
                                     [&](Index e) { return m_label_of[e] != none; }),
                      unlabeled.end());
    }
  }

  /// The cost of the border between an element and a part, or -1 if they are not adjacent.
  double border_cost(Index element, Index part) const
  {
    double cost = -1;
    for (const auto& step : m_costs.steps(element))
      if (m_label_of[step.face] == part)
        cost = (std::max)(cost, 0.0) + double(step.length);
    return cost;
  }

  /// The elements that move have no region any more.
  void move_border(const std::vector<Index>& elements, Index a, Index b)
  {
    double area_of_a = 0, area_of_b = 0;
    std::vector<Index> border;
    for (const Index e : elements) {
      (m_label_of[e] == a ? area_of_a : area_of_b) += area(e);
      for (const auto& step : m_costs.steps(e))
        if (m_label_of[e] == b && m_label_of[step.face] == a)
          border.insert(border.end(), {e, step.face});
    }
    const double width = m_borders.band_width((std::min)(area_of_a, area_of_b));
    for (const Index e :
         m_cut.move_border(a, b, border, width, [&](Index element) { return is_fixed(element); }))
      take_from_region(e);
  }

  /// Moves the elements of a part to the other one if all of them are degenerate, unless its
  /// regions had no others at first, or a seed keeps one.
  void join_if_degenerate(const std::vector<Index>& elements, Index part, Index other)
  {
    const auto keeps_part = [&](Index e) {
      return m_label_of[e] == part && (!m_is_degenerate[e] || is_fixed(e));
    };
    const auto is_proper = [&](Index r) { return m_is_proper_region[r]; };
    const std::vector<Index>& regions = m_regions[part];
    if (std::any_of(elements.begin(), elements.end(), keeps_part) ||
        std::none_of(regions.begin(), regions.end(), is_proper))
      return;
    for (const Index e : elements)
      if (m_label_of[e] == part) {
        m_label_of[e] = other;
        take_from_region(e);
      }
  }

  void take_from_region(Index element)
  {
    if (const Index r = std::exchange(m_region_of[element], none); r != none)
      m_lost[r].push_back(element);
  }

  const Minimum_cut_borders& m_borders;
  const double m_unit; // of lengths
  const Patches& m_cells;
  const Requested_regions& m_requested;
  const Merge_tree& m_tree;
  Dual_graph m_costs;                            // of the borders between elements
  std::vector<Index> m_region_of;                // by element; none if it has moved
  std::vector<std::size_t> m_numbers_of_removed; // by merge: the number of first regions of the
                                                 // removed segment
  std::vector<std::vector<Index>> m_regions, m_elements; // by segment
  std::vector<std::vector<Index>> m_lost;                // by region: the elements that it has lost
  std::vector<bool> m_is_degenerate;                     // by element
  std::vector<bool> m_is_proper_region; // whether a region had an element that is not degenerate
  std::vector<Index> m_part_of;         // by region: its segment
  std::vector<Index> m_label_of;        // by element: its segment, named by the lowest region
  std::vector<Index> m_component_of;    // by element, in `keep_one_component()`
  Border_cut m_cut;
};

} // namespace internal

/// \ingroup PkgRegionSegmentationInitializers
/// moves the borders of the segments of a merge tree to minimum cuts, from the roots of the tree
/// down, so that the segmentations of all numbers stay nested.
///
/// Elements are cells: the patches of the surface; a patch with faces of several regions is divided
/// by them into connected elements. At first each element has the region of its faces. Merges are
/// undone from the last one on. Each divides a segment into two parts, the kept one and the removed
/// one:
/// -# The elements of either part's regions belong to it. If they are not connected, the elements
///    outside of the component of largest area (of equal ones, that with the lowest element) lose
///    their region.
/// -# In rounds, elements of the segment without a region that are adjacent to elements of the two
///    parts join the part to which their border costs more, of equal ones the kept one. If no
///    element of the segment has a region, all join the kept part. Costs are those of
///    `Border_cost`, rounded to `float`.
/// -# In the last \f$n\f$ merges, the border between the parts moves. Its band contains the
///    elements of both within \f$\min(D_0, q \sqrt{a / A})\f$ of it, \f$a\f$ the area of the
///    smaller part and \f$A\f$ that of the surface; if this width is below \f$10^{-6}\f$, the
///    border stays. Elements at the border have the distance 0, and a step to an adjacent element
///    of the same part has the length \f$|c_i - c_j| / \sqrt{A}\f$. An element of the band that is
///    adjacent to one of its part outside of the band stays. If some stay in either part, elements
///    move to the minimum cut: the sides between which the borders of elements of the band cost
///    least, of several cuts one that moves the fewest elements, and of these that with the fewest
///    elements in the kept part. Costs are rounded to multiples of about \f$2^{-50} N C\f$, \f$N\f$
///    the number of elements that may move and \f$C\f$ the sum of their costs. Elements outside of
///    the band count with their own part. The move is not made if it disconnects a part. Moved
///    elements lose their region.
/// -# If a part whose regions had cells that are not degenerate has none any more, its cells lose
///    their region and join the other part, unless one has a seed.
///
/// A region can lose all elements: then its merge is left out. The regions that remain are numbered
/// by their first face.
///
/// Complexity: O((P + R) h) for P elements and R regions in a tree of height h, and the cuts, whose
/// bands contain few elements.
///
/// Source: minimum cuts in a fuzzy band \cgalCite{KT03}; the flow \cgalCite{BK04}.
struct Border_straightening : Minimum_cut_borders
{
  std::size_t number_of_cuts = 63; ///< n: at most one less than the largest number of segments
                                   ///< whose borders are moved

  Border_straightening()
    : Minimum_cut_borders{0.03, 0.2, Border_cost()}
  {}

  /// The region of each cell after moving borders, by its former number; or, if
  /// `number_of_segments` is less than the number of regions that are left, the segment of each
  /// cell in that segmentation (or in the nearest one that exists), named by its lowest region: the
  /// other merges are not undone then.
  ///
  /// `cells`: of the surface; `requested`: the regions of its faces, each a union of cells; regions
  /// with a seed keep their faces; `tree`: the merges of the regions, which are connected.
  std::vector<Surface::Index> operator()(const Surface& surface, const Patches& cells,
                                         const Requested_regions& requested, const Merge_tree& tree,
                                         std::size_t number_of_segments,
                                         const Execution& execution) const
  {
    return internal::Nested_borders(*this, surface, cells, requested, tree)
      .run(number_of_cuts, number_of_segments, execution);
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_BORDER_STRAIGHTENING_H
