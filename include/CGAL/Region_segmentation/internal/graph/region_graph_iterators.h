// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H

#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>

#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// The regions, or the sections, that are not removed, in the order of their indices.
template <typename Graph, typename Descriptor>
class Remaining_iterator
  : public boost::iterator_facade<Remaining_iterator<Graph, Descriptor>, Descriptor,
                                  boost::forward_traversal_tag, Descriptor>
{
public:
  Remaining_iterator() = default;
  /// From the first one that is not below an index; `end`: the upper bound of indices
  Remaining_iterator(const Graph& graph, std::size_t index, std::size_t end)
    : m_graph(&graph)
    , m_number(step * index)
    , m_end(step * end)
  {
    skip();
  }

private:
  friend class boost::iterator_core_access;
  static constexpr std::size_t step = std::is_same<Descriptor, Section_descriptor>::value
                                        ? 2
                                        : 1; // has two halves

  Descriptor dereference() const { return Descriptor(std::uint32_t(m_number)); }
  bool equal(const Remaining_iterator& other) const { return m_number == other.m_number; }
  void increment()
  {
    m_number += step;
    skip();
  }
  void skip()
  {
    while (m_number < m_end && m_graph->is_removed(dereference()))
      m_number += step;
  }

  const Graph* m_graph = nullptr;
  std::size_t m_number = 0, m_end = 0;
};

/// The sections of a region, each seen from the region.
template <typename Lists>
class Out_section_iterator
  : public boost::iterator_facade<Out_section_iterator<Lists>, Section_descriptor,
                                  boost::forward_traversal_tag, Section_descriptor>
{
public:
  Out_section_iterator() = default;
  Out_section_iterator(const Lists& lists, std::uint32_t place)
    : m_lists(&lists)
    , m_left(lists.degree(place))
  {
    if (m_left > 0)
      m_position = lists.first(place);
  }

private:
  friend class boost::iterator_core_access;
  Section_descriptor dereference() const { return Section_descriptor(*m_position); }
  // The remaining number distinguishes positions of one traversal.
  bool equal(const Out_section_iterator& other) const { return m_left == other.m_left; }
  void increment()
  {
    if (--m_left > 0)
      m_position = m_lists->following(m_position);
  }

  const Lists* m_lists = nullptr;
  const std::uint32_t* m_position = nullptr;
  std::size_t m_left = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H
