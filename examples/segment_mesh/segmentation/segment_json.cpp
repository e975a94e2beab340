// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Segmentation_details.h"

#include "segmentation/segment_attributes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace segment_mesh {

namespace {

using nlohmann::ordered_json;
namespace RS = CGAL::Region_segmentation;

/// The largest distance of a vertex to the surface of a face, else the root mean square distance.
double error_of(const Segment_description& segment)
{
  return segment.face ? segment.face->surface.deviation : segment.surface_error();
}

/// The surface of the face that a segment is, else the simple one that fits best.
ordered_json surface_json(const Segment_description& segment)
{
  const RS::Fitted_surface<Kernel>& s = segment.face ? segment.face->surface : segment.surface;
  ordered_json json;
  visit_attributes_of_surface(s, [&](const char* name, const auto& value) {
    const std::string key = name;
    if (key == "deviation")
      json["error"] = error_of(segment);
    else if (key != "extent" || (segment.face && s.has_axis()))
      json[key] = value;
  });
  if (segment.face && s.kind != RS::Surface_kind::PLANE && s.kind != RS::Surface_kind::FREEFORM)
    json["concave"] = s.side < 0;
  return json;
}

} // namespace

ordered_json segment_json(const Segment_description& segment)
{
  ordered_json json = {{"faces", segment.number_of_faces}};
  visit_attributes(segment, [&json](const char* name, const auto& value) { json[name] = value; });
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
      neighbor, [&entry](const char* name, const auto& value) { entry[name] = value; });
    if (const auto& smooth = segment.smooth_neighbors) {
      const bool is_smooth = std::count(smooth->begin(), smooth->end(), neighbor.segment) > 0;
      entry["border"] = is_smooth ? "smooth" : "sharp";
    }
  }
  return json;
}

} // namespace segment_mesh
