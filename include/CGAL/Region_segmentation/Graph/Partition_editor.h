// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_PARTITION_EDITOR_H
#define CGAL_REGION_SEGMENTATION_GRAPH_PARTITION_EDITOR_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// A partition of the regions of a merge tree that a user changes: segments are split along the
/// tree, joined at will, and every change can be undone.
///
/// A segment is a set of subtrees of the merge tree: one, unless segments were joined. At first
/// there is a segment for each region that was never merged into another one, as after all merges.
/// Segments are named by their ids in `partition()`, which change with every operation that changes
/// the segments, since they are numbered by their first regions.
///
/// \code{.cpp}
/// RS::Segmenter segmenter(mesh);
/// RS::Partition_editor editor(segmenter.merge_tree());
/// editor.set_count(8);
/// editor.split(3);
/// RS::write_face_values(mesh, composed(segmenter.regions(), editor.partition()), segment_map);
/// \endcode
///
/// Complexity: O(R log R) for an operation, O(R) for `partition()`, in R regions. The tree is
/// copied. An editor does not follow a `Segmenter` whose constraints or seeds change: its regions
/// are others.
class Partition_editor
{
public:
  using Index = Partition::Index;

  explicit Partition_editor(Merge_tree tree)
    : m_tree(std::move(tree))
  {
    const std::size_t regions = m_tree.number_of_regions();
    std::vector<Index> subtree_of(regions); // the largest one so far in which a region is the
                                            // lowest
    for (std::size_t r = 0; r < regions; ++r)
      m_subtrees.push_back({Index(r), none, none, -std::numeric_limits<double>::infinity()});
    std::iota(subtree_of.begin(), subtree_of.end(), Index(0));
    for (const Merge_tree::Merge& merge : m_tree.merges()) {
      const Index kept = subtree_of[merge.kept], removed = subtree_of[merge.removed];
      const double highest = (std::max)(
        {merge.cost, m_subtrees[kept].highest_cost, m_subtrees[removed].highest_cost});
      subtree_of[merge.kept] = Index(m_subtrees.size());
      m_subtrees.push_back({merge.kept, kept, removed, highest});
    }
    set_count(1);
    m_history.clear();
  }

  const Merge_tree& merge_tree() const { return m_tree; }
  std::size_t number_of_segments() const { return m_segments.size(); }

  /// The segments of the regions.
  Partition partition() const
  {
    Partition::Numbers segment_of(m_tree.number_of_regions());
    std::vector<Index> stack;
    for (std::size_t s = 0; s < m_segments.size(); ++s) {
      stack.assign(m_segments[s].begin(), m_segments[s].end());
      while (!stack.empty()) {
        const Subtree& subtree = m_subtrees[stack.back()];
        stack.pop_back();
        if (subtree.kept == none)
          segment_of[subtree.first_region] = Index(s);
        else
          stack.insert(stack.end(), {subtree.kept, subtree.removed});
      }
    }
    return Partition(std::move(segment_of), m_segments.size());
  }

  /// \name Changes of one segment
  /// @{

  /// Splits a segment into `number` parts: what was joined comes apart first, then the last merges
  /// are undone.
  /// \returns the number of parts: fewer than `number` if the segment has fewer regions
  /// \pre `segment < number_of_segments()`, and `number` is at least 1
  std::size_t split(std::size_t segment, std::size_t number = 2)
  {
    CGAL_precondition(segment < m_segments.size() && number >= 1);
    std::vector<Segment> parts;
    for (Index subtree : m_segments[segment])
      parts.push_back({subtree});
    if (parts.size() >= number) { // those that are first stay together
      for (std::size_t i = number; i < parts.size(); ++i)
        parts.front().push_back(parts[i].front());
      parts.resize(number);
    } else
      undo_last_merges(parts, number);
    if (parts.size() > 1) {
      Segments changed = m_segments;
      changed.erase(changed.begin() + std::ptrdiff_t(segment));
      changed.insert(changed.end(), parts.begin(), parts.end());
      change_to(std::move(changed));
    }
    return parts.size();
  }

  /// Joins two segments, which need not be adjacent.
  /// \pre both are below `number_of_segments()`, and different
  void join(std::size_t a, std::size_t b)
  {
    CGAL_precondition(a < m_segments.size() && b < m_segments.size() && a != b);
    Segments changed = m_segments;
    const auto [lower, higher] = std::minmax(a, b);
    changed[lower].insert(changed[lower].end(), changed[higher].begin(), changed[higher].end());
    changed.erase(changed.begin() + std::ptrdiff_t(higher));
    change_to(std::move(changed));
  }
  /// @}

  /// \name Changes of all segments
  /// These replace the segments by subtrees; what was joined is forgotten, until it is undone.
  /// @{

  /// As `Merge_tree::partition_at_count()`.
  void set_count(std::size_t number_of_segments)
  {
    std::vector<Segment> parts = all_trees();
    undo_last_merges(parts, number_of_segments);
    change_to(std::move(parts));
  }

  /// The largest subtrees without a merge that costs more than `maximum_cost`.
  /// (`Merge_tree::partition_at_cost()` stops at the first such merge of the whole tree.)
  void set_maximum_cost(double maximum_cost)
  {
    descend([&](Index subtree) { return m_subtrees[subtree].highest_cost > maximum_cost; });
  }

  /// The largest subtrees whose size is at most `maximum_size`; a region that is larger is a
  /// segment.
  ///
  /// `size_of_region`: for each region, at least 0; its area, for example.
  /// \pre it has `merge_tree().number_of_regions()` elements
  void set_maximum_size(const std::vector<double>& size_of_region, double maximum_size)
  {
    CGAL_precondition(size_of_region.size() == m_tree.number_of_regions());
    std::vector<double> sizes = size_of_region;
    for (std::size_t i = sizes.size(); i < m_subtrees.size(); ++i)
      sizes.push_back(sizes[m_subtrees[i].kept] + sizes[m_subtrees[i].removed]);
    descend([&](Index subtree) { return sizes[subtree] > maximum_size; });
  }
  /// @}

  /// \name History
  /// @{

  /// Returns to the segments before the last change, which is any call above that changed them.
  /// \returns whether there was one
  bool undo()
  {
    if (m_history.empty())
      return false;
    m_segments = std::move(m_history.back());
    m_history.pop_back();
    return true;
  }

  std::size_t number_of_changes() const { return m_history.size(); }
  /// @}

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// A region, or two subtrees and their merge. Regions come first, then merges in their order.
  struct Subtree
  {
    Index first_region, kept, removed;
    double highest_cost; // of the merges in it
  };
  using Segment = std::vector<Index>;    // subtrees
  using Segments = std::vector<Segment>; // by first region

  bool is_region(Index subtree) const { return subtree < m_tree.number_of_regions(); }

  Index first_region(const Segment& segment) const
  {
    Index first = none;
    for (Index subtree : segment)
      first = (std::min)(first, m_subtrees[subtree].first_region);
    return first;
  }

  void change_to(Segments segments)
  {
    for (Segment& segment : segments)
      std::sort(segment.begin(), segment.end(), [this](Index a, Index b) {
        return m_subtrees[a].first_region < m_subtrees[b].first_region;
      });
    std::sort(segments.begin(), segments.end(), [this](const Segment& a, const Segment& b) {
      return first_region(a) < first_region(b);
    });
    if (segments == m_segments)
      return;
    m_history.push_back(std::exchange(m_segments, std::move(segments)));
  }

  std::vector<Segment> all_trees() const
  {
    std::vector<char> is_root(m_subtrees.size(), true);
    for (const Subtree& subtree : m_subtrees)
      if (subtree.kept != none)
        is_root[subtree.kept] = is_root[subtree.removed] = false;
    std::vector<Segment> trees;
    for (std::size_t i = 0; i < m_subtrees.size(); ++i)
      if (is_root[i])
        trees.push_back({Index(i)});
    return trees;
  }

  /// Of single subtrees, until there are `number` parts.
  void undo_last_merges(std::vector<Segment>& parts, std::size_t number) const
  {
    std::priority_queue<Index> latest;
    for (const Segment& part : parts)
      latest.push(part.front());
    while (latest.size() < number && !latest.empty() && !is_region(latest.top())) {
      const Subtree& subtree = m_subtrees[latest.top()];
      latest.pop();
      latest.push(subtree.kept);
      latest.push(subtree.removed);
    }
    parts.clear();
    for (; !latest.empty(); latest.pop())
      parts.push_back({latest.top()});
  }

  template <typename IsSplit>
  void descend(const IsSplit& is_split)
  {
    Segments segments;
    std::vector<Index> stack;
    for (const Segment& tree : all_trees())
      stack.push_back(tree.front());
    while (!stack.empty()) {
      const Index subtree = stack.back();
      stack.pop_back();
      if (!is_region(subtree) && is_split(subtree))
        stack.insert(stack.end(), {m_subtrees[subtree].kept, m_subtrees[subtree].removed});
      else
        segments.push_back({subtree});
    }
    change_to(std::move(segments));
  }

  Merge_tree m_tree;
  std::vector<Subtree> m_subtrees;
  Segments m_segments;
  std::vector<Segments> m_history;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_PARTITION_EDITOR_H
