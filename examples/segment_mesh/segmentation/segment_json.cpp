// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/segment_json.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>

#include <CGAL/number_type_config.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace segment_mesh {

namespace {

using nlohmann::ordered_json;
namespace RS = CGAL::Region_segmentation;

template <typename Triple>
ordered_json vector_json(const Triple& v)
{
  return {v.x(), v.y(), v.z()};
}

bool has_radius(const RS::Fitted_surface<Kernel>& s)
{
  return s.kind == RS::Surface_kind::SPHERE || s.kind == RS::Surface_kind::CYLINDER ||
         s.kind == RS::Surface_kind::TORUS;
}

/// The surface of the face that a segment is, else the simple one that fits best; `point` of a cone
/// is its apex.
RS::Fitted_surface<Kernel> surface_of(const Segment_description& segment)
{
  RS::Fitted_surface<Kernel> s = segment.face ? segment.face->surface : segment.surface;
  if (s.kind == RS::Surface_kind::CONE) {
    const double to_apex = s.radius / std::tan(s.angle);
    s.point = s.apex();
    s.radius = 0;
    s.lowest += to_apex;
    s.highest += to_apex;
  }
  return s;
}

/// The largest distance of a vertex to the surface of a face, else the root mean square distance.
double error_of(const Segment_description& segment)
{
  return segment.face ? segment.face->surface.deviation : segment.surface_error();
}

ordered_json surface_json(const Segment_description& segment)
{
  const RS::Fitted_surface<Kernel> s = surface_of(segment);
  ordered_json json = {{"type", name_of(s.kind)}};
  if (s.kind == RS::Surface_kind::FREEFORM)
    return json;
  json["error"] = error_of(segment);
  json["point"] = vector_json(s.point);
  if (s.kind != RS::Surface_kind::SPHERE)
    json["direction"] = vector_json(s.direction);
  if (has_radius(s))
    json["radius"] = s.radius;
  if (s.kind == RS::Surface_kind::TORUS)
    json["minor_radius"] = s.minor_radius;
  if (s.kind == RS::Surface_kind::CONE)
    json["half_angle"] = s.angle * 180 / CGAL_PI;
  if (segment.face && s.kind != RS::Surface_kind::PLANE)
    json["concave"] = s.side < 0;
  if (segment.face && s.has_axis())
    json["extent"] = {s.lowest, s.highest};
  return json;
}

} // namespace

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
                       {"primitive", surface_json(segment)}};
  if (segment.face) {
    json["role"] = name_of(segment.face->role);
    json["same_surface"] = segment.face->same_surface;
    json["same_axis"] = segment.face->same_axis;
  }
  for (const Kernel::Vector_3& axis : segment.axes)
    json["axes"].push_back(vector_json(axis));
  for (const auto& neighbor : segment.neighbors) {
    ordered_json& entry = json["neighbors"].emplace_back(
      ordered_json{{"segment", std::int64_t(neighbor.segment)}, // -1 for no segment
                   {"border_length", neighbor.border_length},
                   {"mean_signed_deviation", neighbor.mean_signed_deviation * 180 / CGAL_PI}});
    if (const auto& smooth = segment.smooth_neighbors) {
      const bool is_smooth = std::count(smooth->begin(), smooth->end(), neighbor.segment) > 0;
      entry["border"] = is_smooth ? "smooth" : "sharp";
    }
  }
  return json;
}

} // namespace segment_mesh
