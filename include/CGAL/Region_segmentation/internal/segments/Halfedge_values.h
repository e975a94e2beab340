// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_HALFEDGE_VALUES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_HALFEDGE_VALUES_H

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A value for every halfedge of a mesh, by its index map.
template <typename FaceGraph, typename Pack, typename T>
class Halfedge_values
{
  using Index_map = typename GetInitializedHalfedgeIndexMap<FaceGraph, Pack>::const_type;

public:
  using halfedge_descriptor = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;

  Halfedge_values(const FaceGraph& mesh, const Pack& np, const T& initial)
    : m_index_map(get_initialized_halfedge_index_map(mesh, np)), m_values(num_halfedges(mesh), initial)
  {}

  T& operator[](halfedge_descriptor h) { return m_values[std::size_t(get(m_index_map, h))]; }
  const T& operator[](halfedge_descriptor h) const { return m_values[std::size_t(get(m_index_map, h))]; }

private:
  Index_map m_index_map;
  std::vector<T> m_values;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_HALFEDGE_VALUES_H
