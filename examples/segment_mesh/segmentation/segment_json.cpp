// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Segmentation_details.h"

#include "segmentation/segment_attributes.h"

#include <CGAL/number_type_config.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace segment_mesh {

namespace {

using nlohmann::ordered_json;
namespace RS = CGAL::Region_segmentation;

/// Of a number, of numbers, of a point or a vector.
template <typename Value>
ordered_json to_json(const Value& value)
{
  if constexpr (std::is_constructible<ordered_json, Value>::value)
    return value;
  else
    return {value.x(), value.y(), value.z()};
}

ordered_json to_json(const std::array<Kernel::Vector_3, 3>& vectors)
{
  return {to_json(vectors[0]), to_json(vectors[1]), to_json(vectors[2])};
}

bool has_radius(const RS::Fitted_surface<Kernel>& s)
{
  return s.kind == RS::Surface_kind::SPHERE || s.kind == RS::Surface_kind::CYLINDER ||
         s.kind == RS::Surface_kind::TORUS;
}

/// The largest distance of a vertex to the surface of a face, else the root mean square distance.
double error_of(const Segment_description& segment)
{
  return segment.face ? segment.face->surface.deviation : segment.surface_error();
}

/// The surface of the face that a segment is, else the simple one that fits best.
ordered_json surface_json(const Segment_description& segment)
{
  const RS::Fitted_surface<Kernel> s = from_apex(segment.face ? segment.face->surface
                                                              : segment.surface);
  ordered_json json = {{"type", name_of(s.kind)}};
  if (s.kind == RS::Surface_kind::FREEFORM)
    return json;
  json["error"] = error_of(segment);
  json["point"] = to_json(s.point);
  if (s.kind != RS::Surface_kind::SPHERE)
    json["direction"] = to_json(s.direction);
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
  ordered_json json = {{"faces", segment.number_of_faces}};
  visit_attributes(segment,
                   [&json](const char* name, const auto& value) { json[name] = to_json(value); });
  json["neighbors"] = ordered_json::array();
  json["primitive"] = surface_json(segment);
  if (segment.face) {
    json["role"] = name_of(segment.face->role);
    json["same_surface"] = segment.face->same_surface;
    json["same_axis"] = segment.face->same_axis;
  }
  for (const auto& neighbor : segment.neighbors) {
    ordered_json& entry = json["neighbors"].emplace_back();
    visit_attributes_of_neighbor(
      neighbor, [&entry](const char* name, const auto& value) { entry[name] = to_json(value); });
    if (const auto& smooth = segment.smooth_neighbors) {
      const bool is_smooth = std::count(smooth->begin(), smooth->end(), neighbor.segment) > 0;
      entry["border"] = is_smooth ? "smooth" : "sharp";
    }
  }
  return json;
}

} // namespace segment_mesh
