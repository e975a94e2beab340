// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_VERTEX_POINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_VERTEX_POINTS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The points of the vertices of a face graph in double, all scaled by a factor. Small enough that loops keep a copy in
/// registers.
template <typename FaceGraph, typename Pack>
class Vertex_points
{
  using Point_map = typename GetVertexPointMap<FaceGraph, Pack>::const_type;

public:
  Vertex_points(const FaceGraph& mesh, const Pack& np, double scale)
    : m_point_map(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        get_const_property_map(vertex_point, mesh)))
    , m_scale(scale)
  {}

  Double_3 operator()(const typename boost::graph_traits<FaceGraph>::vertex_descriptor& v) const
  {
    const auto& p = get(m_point_map, v);
    return {m_scale * CGAL::to_double(p[0]), m_scale * CGAL::to_double(p[1]), m_scale * CGAL::to_double(p[2])};
  }

private:
  Point_map m_point_map;
  double m_scale;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_VERTEX_POINTS_H
