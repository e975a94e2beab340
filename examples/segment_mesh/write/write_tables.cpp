// SPDX-License-Identifier: GPL-3.0-or-later

// The .csv and the .json output. doc/Region_segmentation/Program.txt has their columns and members.

#include "page/page.h"
#include "write/Text_buffer.h"
#include "write/write_segmentation.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Support/version.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;
using nlohmann::ordered_json;

/// The names of the columns of .csv after the first, and where their values are in a segment of
/// .json.
constexpr const char*
  columns = "faces /faces area /area area_share /area_share volume /volume "
            "volume_share /volume_share border_length /border_length "
            "boundary_length /boundary_length centroid_x /centroid/0 centroid_y /centroid/1 "
            "centroid_z /centroid/2 extent_1 /extents/0 extent_2 /extents/1 extent_3 /extents/2 "
            "primitive /primitive/type radius /primitive/radius half_angle /primitive/half_angle "
            "error /primitive/error neighbors /neighbor_ids point_x /primitive/point/0 "
            "point_y /primitive/point/1 point_z /primitive/point/2 "
            "direction_x /primitive/direction/0 direction_y /primitive/direction/1 "
            "direction_z /primitive/direction/2 minor_radius /primitive/minor_radius "
            "lowest /primitive/extent/0 highest /primitive/extent/1 concave /primitive/concave "
            "role /role same_surface /same_surface same_axis /same_axis "
            "smooth_neighbors /smooth_neighbor_ids name /name";

/// The values of a list are separated by spaces.
void write_field(Text_buffer& text, const ordered_json& value)
{
  if (value.is_array())
    for (const ordered_json& element : value) {
      text << (&element == &value.front() ? "" : " ");
      write_field(text, element);
    }
  else if (value.is_string())
    text << value.get_ref<const std::string&>();
  else if (value.is_boolean())
    text << (value.get<bool>() ? "1" : "0");
  else if (value.is_number_integer())
    text << value.get<std::int64_t>();
  else if (value.is_number() && std::isfinite(value.get<double>()))
    text << value.get<double>();
}

/// Of the segments: by the areas of regions, whose unit is so that none is too large.
std::vector<double> area_shares(const Result& result)
{
  std::vector<double> shares(result.segmentation.number_of_segments);
  double area = 0;
  for (const Region& region : result.details.regions()) {
    if (region.segment != RS::no_segment)
      shares[region.segment] += region.area;
    area += region.area;
  }
  for (double& share : shares)
    share = area > 0 ? share / area : 0;
  return shares;
}

ordered_json settings_json(const Result& result)
{
  if (!result.side_files.labels.empty())
    return {{"labels", result.side_files.labels}};
  if (const auto& kind = result.side_files.labels_from)
    return {{"labels_from", set_kind_names[std::size_t(*kind)]}};
  const Segmentation_settings& settings = result.settings;
  ordered_json json = {{"method", method_names[std::size_t(settings.method)]},
                       {"segments", nullptr},
                       {"links", settings.links == Component_links::FOUND},
                       {"smooth_borders", settings.borders == Border_treatment::SMOOTHING}};
  if (settings.number_of_segments)
    json["segments"] = *settings.number_of_segments;
  if (!result.side_files.constraints.empty())
    json["constraints"] = result.side_files.constraints;
  if (const auto& kind = result.side_files.constraints_from)
    json["constraints_from"] = set_kind_names[std::size_t(*kind)];
  if (!result.side_files.seeds.empty())
    json["seeds"] = result.side_files.seeds;
  if (settings.method == Method::TWO_STEP) {
    json["features"] = feature_names[std::size_t(settings.features)];
    json["max_angle"] = settings.maximum_angle;
  }
  if (settings.tolerance > 0)
    json["tolerance"] = settings.tolerance;
  return json;
}

template <typename Elements, typename ToJson>
ordered_json array_json(const Elements& elements, ToJson to_json)
{
  ordered_json array = ordered_json::array();
  for (const auto& element : elements)
    array.push_back(to_json(element));
  return array;
}

void add_details(const Result& result, ordered_json& json)
{
  const std::vector<std::string> names = result.details.names();
  json["segments"] = array_json(result.details.segments(), [&](const Segment_description& s) {
    ordered_json segment = {{"name", names[s.segment]}};
    segment.update(segment_json(s));
    return segment;
  });
  json["regions"] = array_json(result.details.regions(), [](const Region& r) -> ordered_json {
    return {{"segment", std::int64_t(r.segment)},
            {"faces", r.number_of_faces},
            {"area", r.area},
            {"perimeter", r.perimeter}};
  });
  json["sections"] = array_json(result.details.sections(), [](const Section& s) -> ordered_json {
    return {{"regions", s.regions},
            {"edges", s.number_of_adjacencies},
            {"length", s.length},
            {"mean_angle", s.mean_angle}};
  });
  json["merges"] = array_json(
    result.segmentation.tree.merges(), [](const auto& merge) -> ordered_json {
      return {{"regions", {merge.kept, merge.removed}}, {"cost", merge.cost}};
    });
}

void write_members(std::ostream& out, const ordered_json& json)
{
  const char* separator = "{\n";
  for (const auto& [name, value] : json.items()) {
    out << separator << "\"" << name << "\": ";
    separator = ",\n";
    if (!value.is_array() || value.empty() || !value.front().is_object()) {
      out << text_of(value);
      continue;
    }
    const char* before = "[\n";
    for (const ordered_json& element : value) {
      out << before << text_of(element);
      before = ",\n";
    }
    out << "]";
  }
  out << "\n}\n";
}

} // namespace

void write_csv(std::ostream& out, const Result& result)
{
  Text_buffer text(out);
  text << "segment";
  std::istringstream in(columns);
  std::vector<ordered_json::json_pointer> members;
  for (std::string name, member; in >> name >> member; members.emplace_back(member))
    text << "," << name;
  const std::vector<double> shares = area_shares(result);
  const std::vector<std::string> names = result.details.names();
  for (const Segment_description& s : result.details.segments()) {
    ordered_json json = segment_json(s);
    json["area_share"] = shares[s.segment];
    json["name"] = names[s.segment];
    ordered_json neighbors, smooth_neighbors;
    for (const ordered_json& neighbor : json["neighbors"]) {
      neighbors.push_back(neighbor["segment"]);
      if (neighbor.value("border", "") == "smooth")
        smooth_neighbors.push_back(neighbor["segment"]);
    }
    json["neighbor_ids"] = neighbors; // not while a reference to a member is in use
    json["smooth_neighbor_ids"] = smooth_neighbors;
    text << "\n" << s.segment;
    for (const auto& member : members) {
      text << ",";
      write_field(text, json.value(member, ordered_json()));
    }
  }
  text << "\n";
}

void write_json(std::ostream& out, const Result& result)
{
  ordered_json json = {
    {"format", "segment_mesh"}, {"version", 3}, {"program", CGAL_REGION_SEGMENTATION_VERSION}};
  json["input"] = {{"name", result.name},
                   {"faces", result.input.soup.polygons.size()},
                   {"points", result.input.soup.points.size()}};
  json["settings"] = settings_json(result);
  json["seconds"] = result.segmentation.seconds;
  add_details(result, json);
  json["face_segments"] = array_json(result.segmentation.segment_of_face,
                                     [](std::size_t s) { return std::int64_t(s); });
  json["face_regions"] = result.segmentation.region_of_face;
  json["remarks"] = result.input.remarks;
  write_members(out, json);
}

} // namespace segment_mesh
