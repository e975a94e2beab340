// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/segment_json.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>

#include <CGAL/number_type_config.h>

#include <nlohmann/json.hpp>

namespace segment_mesh {

namespace {

using nlohmann::ordered_json;
namespace RS = CGAL::Region_segmentation;

template <typename Triple>
ordered_json vector_json(const Triple& v)
{
  return {v.x(), v.y(), v.z()};
}

ordered_json primitive_json(const Fitted_primitive& primitive)
{
  ordered_json json = {{"type", name_of(primitive.type)},
                       {"error", primitive.error},
                       {"point", vector_json(primitive.point)}};
  if (primitive.type != RS::Primitive_type::SPHERE)
    json["direction"] = vector_json(primitive.direction);
  if (has_radius(primitive))
    json["radius"] = primitive.radius;
  if (primitive.type == RS::Primitive_type::CONE)
    json["half_angle"] = primitive.half_angle * 180 / CGAL_PI;
  return json;
}

} // namespace

const char* name_of(RS::Primitive_type type)
{
  switch (type) {
  case RS::Primitive_type::PLANE:
    return "plane";
  case RS::Primitive_type::SPHERE:
    return "sphere";
  case RS::Primitive_type::CYLINDER:
    return "cylinder";
  case RS::Primitive_type::CONE:
    return "cone";
  }
  return "";
}

bool has_radius(const Fitted_primitive& primitive)
{
  return primitive.type == RS::Primitive_type::SPHERE ||
         primitive.type == RS::Primitive_type::CYLINDER;
}

ordered_json segment_json(const Segment_description& segment)
{
  ordered_json json = {{"faces", segment.number_of_faces},
                       {"area", segment.area},
                       {"volume", segment.volume},
                       {"volume_share", segment.volume_share},
                       {"centroid", vector_json(segment.centroid)},
                       {"axes", ordered_json::array()},
                       {"extents", segment.extents},
                       {"border_length", segment.border_length},
                       {"boundary_length", segment.boundary_length},
                       {"neighbors", ordered_json::array()},
                       {"primitive", primitive_json(segment.primitive)}};
  for (const Kernel::Vector_3& axis : segment.axes)
    json["axes"].push_back(vector_json(axis));
  for (const auto& neighbor : segment.neighbors)
    if (RS::is_segment(neighbor.segment))
      json["neighbors"].push_back(
        {{"segment", neighbor.segment},
         {"border_length", neighbor.border_length},
         {"mean_signed_deviation", neighbor.mean_signed_deviation * 180 / CGAL_PI}});
  return json;
}

} // namespace segment_mesh
