// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H

#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
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

/// A section as seen from one of its regions, by the number of the half.
struct Section_of_half
{
  Section_descriptor operator()(std::uint32_t half) const { return Section_descriptor(half); }
};
/// The first half of a section.
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

/// Those of a range of numbers or of halves that are not removed.
template <typename Iterator, typename Graph, typename Base>
std::pair<Iterator, Iterator> remaining(const Graph& graph, const Base& begin, const Base& end)
{
  using All = std::decay_t<decltype(std::declval<const Iterator&>().base())>;
  const Is_there<Graph> is_there{&graph};
  return {Iterator(is_there, All(begin), All(end)), Iterator(is_there, All(end), All(end))};
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_REGION_GRAPH_ITERATORS_H
