// SPDX-License-Identifier: GPL-3.0-or-later

// The .json output. One object:
//
//   format        "segment_mesh"
//   version       2; grows when a member changes its meaning or goes, not when one is added
//   program       version of the program
//   input         name, faces, points
//   settings      method: as on the command line; segments: the wanted number, null if it was chosen;
//                 mesh: the mesh type; and of two-step features: "concave", "convex" or "all";
//                 max_angle: in degrees
//   times         in seconds: total, from the mesh in memory to the labels, and its stages, each
//                 with stage and seconds, in order
//   segments      for each segment, by its id: faces, area (in squared units of the mesh)
//   regions       for each region that merging started from, by its id: segment, faces, area,
//                 perimeter (shared with other regions, in units of the mesh)
//   sections      for each pair of regions that share edges: regions (two ids), edges, length (in
//                 units of the mesh), mean_angle (the dihedral angle, in radians; pi is flat)
//   face_segments the segment of each face, in the order of the input's file
//   face_regions  the region of each face
//   remarks       what the reader had to say, as texts
//
// Numbers are finite, but where a value is too large for a double there is null.

#include "io/Text_buffer.h"
#include "io/write_segmentation.h"

#include <CGAL/Region_segmentation/version.h>

#include <cmath>

namespace segment_mesh {

namespace {

/// A JSON value of each kind that there is here.
struct Json_text
{
  const std::string& text;
};

struct Json_number
{
  double value;
};

Text_buffer& operator<<(Text_buffer& out, const Json_number& number)
{
  return std::isfinite(number.value) ? out << number.value : out << "null";
}

/// Bytes above 0x7f are taken for UTF-8.
Text_buffer& operator<<(Text_buffer& out, const Json_text& json)
{
  constexpr const char* hexadecimal = "0123456789abcdef";
  std::string escaped = "\"";
  for (char c : json.text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (escaped += '\\') += c;
    else if (byte < 0x20)
      ((escaped += "\\u00") += hexadecimal[byte / 16]) += hexadecimal[byte % 16];
    else
      escaped += c;
  }
  return out << (escaped += '"');
}

/// `"name": [...]`, an item a line or all on one.
template <typename Range, typename Write>
void write_array(Text_buffer& out, const char* name, const Range& range, const char* between,
                 Write write)
{
  out << ",\n  \"" << name << "\": [";
  const char* separator = between + 1;
  for (const auto& item : range) {
    out << separator;
    write(item);
    separator = between;
  }
  out << "]";
}

constexpr const char* a_line_each = ",\n    ";
constexpr const char* on_one_line = ", ";

const char* name_of(CGAL::Region_segmentation::Feature_convexity features)
{
  using CGAL::Region_segmentation::Feature_convexity;
  return features == Feature_convexity::CONCAVE  ? "concave"
         : features == Feature_convexity::CONVEX ? "convex"
                                                 : "all";
}

const char* name_of(Mesh_type type)
{
  return type == Mesh_type::SURFACE_MESH ? "surface_mesh"
         : type == Mesh_type::POLYHEDRON ? "polyhedron"
                                         : "openmesh";
}

const char* name_of(Method method)
{
  return method == Method::TWO_STEP     ? "two-step"
         : method == Method::VISIBILITY ? "visibility"
         : method == Method::LEARNED    ? "learned"
                                        : "smooth-faces";
}

void write_head(Text_buffer& out, const Result& result)
{
  const std::optional<std::size_t>& wanted = result.settings.number_of_segments;
  out << "{\n  \"format\": \"segment_mesh\",\n  \"version\": 2,\n  \"program\": \""
      << CGAL_REGION_SEGMENTATION_VERSION
      << "\",\n  \"input\": {\"name\": " << Json_text{result.name}
      << ", \"faces\": " << result.input.soup.polygons.size()
      << ", \"points\": " << result.input.soup.points.size()
      << "},\n  \"settings\": {\"method\": \""
      << name_of(result.settings.method)
      << "\", \"segments\": " << (wanted ? std::to_string(*wanted) : "null") << ", \"mesh\": \""
      << name_of(result.settings.mesh_type) << "\"";
  if (const auto& features = result.segmentation.features)
    out << ", \"features\": \"" << name_of(features->convexity)
        << "\", \"max_angle\": " << features->maximum_angle;
  out << "},\n  \"times\": {\"total\": " << result.segmentation.seconds;
  write_array(out, "stages", result.segmentation.stages, a_line_each, [&](const Stage_time& time) {
    out << "{\"stage\": " << Json_text{time.stage} << ", \"seconds\": " << time.seconds << "}";
  });
  out << "}";
}

struct Segment
{
  std::size_t number_of_faces = 0;
  double area = 0;
};

std::vector<Segment> sum_up_segments(const Result& result)
{
  std::vector<Segment> segments(result.segmentation.number_of_segments);
  for (std::size_t label : labels_of_faces(result.input, result.segmentation))
    ++segments[label].number_of_faces;
  for (const Region& region : result.segmentation.regions)
    segments[region.segment].area += region.area;
  return segments;
}

} // namespace

void write_json(std::ostream& stream, const Result& result)
{
  const Segmentation& segmentation = result.segmentation;
  Text_buffer out(stream);
  write_head(out, result);
  write_array(out, "segments", sum_up_segments(result), a_line_each, [&](const Segment& s) {
    out << "{\"faces\": " << s.number_of_faces << ", \"area\": " << Json_number{s.area} << "}";
  });
  write_array(out, "regions", segmentation.regions, a_line_each, [&](const Region& r) {
    out << "{\"segment\": " << r.segment << ", \"faces\": " << r.number_of_faces
        << ", \"area\": " << Json_number{r.area} << ", \"perimeter\": " << Json_number{r.perimeter}
        << "}";
  });
  write_array(out, "sections", segmentation.sections, a_line_each, [&](const Section& s) {
    out << "{\"regions\": [" << s.regions[0] << ", " << s.regions[1]
        << "], \"edges\": " << s.number_of_edges << ", \"length\": " << Json_number{s.length}
        << ", \"mean_angle\": " << Json_number{s.mean_angle} << "}";
  });
  const auto write_size = [&](std::size_t value) { out << value; };
  write_array(out, "face_segments", labels_of_faces(result.input, segmentation), on_one_line,
              write_size);
  const auto write_region = [&](std::size_t f) { out << segmentation.region_of_face[f]; };
  write_array(out, "face_regions", result.input.mesh_face_of_face, on_one_line, write_region);
  write_array(out, "remarks", result.input.remarks, a_line_each,
              [&](const std::string& remark) { out << Json_text{remark}; });
  out << "\n}\n";
}

} // namespace segment_mesh
