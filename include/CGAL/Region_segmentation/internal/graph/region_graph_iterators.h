// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H

#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>

#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// The ids below the upper bound that are not removed.
template <typename Graph>
class Region_iterator
  : public boost::iterator_facade<Region_iterator<Graph>, std::uint32_t,
                                  boost::forward_traversal_tag, std::uint32_t>
{
public:
  Region_iterator() = default;
  Region_iterator(const Graph& graph, std::size_t region) : m_graph(&graph), m_region(region)
  {
    skip();
  }

private:
  friend class boost::iterator_core_access;
  std::uint32_t dereference() const { return std::uint32_t(m_region); }
  bool equal(const Region_iterator& other) const { return m_region == other.m_region; }
  void increment()
  {
    ++m_region;
    skip();
  }
  void skip()
  {
    while (m_region < m_graph->index_bound_of_regions() && m_graph->is_removed(std::uint32_t(m_region)))
      ++m_region;
  }

  const Graph* m_graph = nullptr;
  std::size_t m_region = 0;
};

/// The sections that are not removed.
template <typename Graph>
class Section_iterator
  : public boost::iterator_facade<Section_iterator<Graph>, Section_descriptor,
                                  boost::forward_traversal_tag, Section_descriptor>
{
public:
  Section_iterator() = default;
  Section_iterator(const Graph& graph, std::size_t section) : m_graph(&graph), m_section(section)
  {
    skip();
  }

private:
  friend class boost::iterator_core_access;
  Section_descriptor dereference() const { return Section_descriptor(std::uint32_t(2 * m_section)); }
  bool equal(const Section_iterator& other) const { return m_section == other.m_section; }
  void increment()
  {
    ++m_section;
    skip();
  }
  void skip()
  {
    while (m_section < m_graph->index_bound_of_sections() && m_graph->is_removed(dereference()))
      ++m_section;
  }

  const Graph* m_graph = nullptr;
  std::size_t m_section = 0;
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
    : m_lists(&lists), m_left(lists.degree(place))
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

/// The regions on the other side of the sections of a region.
template <typename Graph>
class Adjacent_region_iterator
  : public boost::iterator_facade<Adjacent_region_iterator<Graph>, std::uint32_t,
                                  boost::forward_traversal_tag, std::uint32_t>
{
public:
  Adjacent_region_iterator() = default;
  Adjacent_region_iterator(const Graph& graph, typename Graph::out_edge_iterator section)
    : m_graph(&graph), m_section(section)
  {}

private:
  friend class boost::iterator_core_access;
  std::uint32_t dereference() const { return m_graph->target(*m_section); }
  bool equal(const Adjacent_region_iterator& other) const { return m_section == other.m_section; }
  void increment() { ++m_section; }

  const Graph* m_graph = nullptr;
  typename Graph::out_edge_iterator m_section;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H
