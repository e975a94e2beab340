// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/page.h"

#include "soup/little_endian.h"
#include "view/choose_viewpoint.h"
#include "view/segment_colors.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

using nlohmann::ordered_json;

/// The slider goes to this number of segments at least, and to twice the number of the
/// segmentation.
constexpr std::size_t least_range = 20;

/// The shapes of segments are described for partitions up to the segmentation and to `least_range`;
/// of a segmentation into more segments than this up to `least_range` alone: each takes up to 0.1
/// s, and the mesh is read again for each few of them.
constexpr std::size_t most_described = 200;

/// Colors of segments, repeated if there are more.
constexpr std::size_t number_of_colors = 256;

/// Arrays of numbers of four bytes, little endian, one after the other, and their names, types and
/// lengths.
class Array_file
{
public:
  template <typename Value>
  void append(Value value)
  {
    static_assert(sizeof(Value) == 4, "all numbers have four bytes");
    append_little_endian(m_bytes, value);
    ++m_length;
  }

  void end_array(const char* name, const char* type)
  {
    m_index.push_back({{"name", name}, {"type", type}, {"length", m_length}});
    m_length = 0;
  }

  const ordered_json& index() const { return m_index; }

  const std::string& bytes() const { return m_bytes; }

private:
  std::string m_bytes;
  std::size_t m_length = 0;
  ordered_json m_index = ordered_json::array();
};

void append_points(const Scene& scene, Array_file& file)
{
  for (const Point& p : scene.soup.points)
    for (double x : p)
      file.append(float(x));
  file.end_array("points", "Float32Array");
}

void append_faces(const Page_content& content, Array_file& file)
{
  const Polygons& polygons = content.soup.polygons;
  for (const Polygon_soup::Polygon& polygon : polygons)
    file.append(std::uint32_t(polygon.size()));
  file.end_array("sizes", "Uint32Array");
  for (const std::uint32_t corner : polygons.corners())
    file.append(corner);
  file.end_array("corners", "Uint32Array");
  for (const std::size_t region : content.segmentation.region_of_face)
    file.append(std::uint32_t(region));
  file.end_array("regions", "Uint32Array");
}

void append_graph(const Page_content& content, Array_file& file)
{
  for (const auto& merge : content.segmentation.tree.merges()) {
    file.append(merge.kept);
    file.append(merge.removed);
  }
  file.end_array("merges", "Uint32Array");
  const std::vector<Section> sections = content.details.sections();
  for (const Section& section : sections)
    for (std::size_t region : section.regions)
      file.append(std::uint32_t(region));
  file.end_array("sections", "Uint32Array");
  for (const Section& section : sections)
    file.append(float(section.length));
  file.end_array("lengths", "Float32Array");
  for (const Region& region : content.details.regions())
    file.append(float(region.area));
  file.end_array("areas", "Float32Array");
}

ordered_json colors_json()
{
  ordered_json colors = ordered_json::array();
  for (std::size_t i = 0; i < number_of_colors; ++i)
    colors.push_back(segment_color(i));
  return colors;
}

/// The region of the faces of no segment, null if there are none.
ordered_json none_region(const Segmentation& segmentation)
{
  const auto& segments = segmentation.segment_of_face;
  const auto none = std::find(segments.begin(), segments.end(),
                              CGAL::Region_segmentation::no_segment);
  return none == segments.end()
           ? ordered_json()
           : ordered_json(segmentation.region_of_face[std::size_t(none - segments.begin())]);
}

/// The names of the segments, by their first faces, as the page orders them.
std::vector<std::string> names_by_first_faces(const Page_content& content)
{
  const std::vector<std::string> names = content.details.names();
  std::vector<char> is_listed(names.size());
  std::vector<std::string> result;
  for (const std::size_t segment : content.segmentation.segment_of_face)
    if (segment < names.size() && !std::exchange(is_listed[segment], true))
      result.push_back(names[segment]);
  return result;
}

ordered_json content_json(const Page_content& content, const Scene& scene, const Array_file& file)
{
  const Segmentation& segmentation = content.segmentation;
  const std::size_t greatest = (std::min)(
    segmentation.number_of_regions, (std::max)(least_range, 2 * segmentation.number_of_segments));
  const Viewpoint viewpoint = choose_viewpoint(scene, content.up);
  return {{"name", content.name},
          {"segments", segmentation.number_of_segments},
          {"names", names_by_first_faces(content)},
          {"regions", segmentation.number_of_regions},
          {"greatest", greatest},
          {"none", none_region(segmentation)},
          {"center", scene.center},
          {"radius", scene.radius},
          {"view", {{"toward", viewpoint.toward_viewer}, {"up", viewpoint.up}}},
          {"colors", colors_json()},
          {"arrays", file.index()}};
}

} // namespace

Page_data page_data(const Page_content& content)
{
  Array_file file;
  const Scene scene = make_scene(content.soup, content.segmentation.segment_of_face);
  append_points(scene, file);
  append_faces(content, file);
  append_graph(content, file);
  return {content_json(content, scene, file), file.bytes()};
}

ordered_json shape_json(const Segment_description& shape)
{
  ordered_json json = {{"node", shape.segment}};
  const ordered_json description = segment_json(shape);
  for (const char* name : {"volume", "extents", "primitive"})
    json[name] = description.at(name);
  return json;
}

ordered_json shapes_json(const Page_content& content)
{
  const std::size_t n = content.segmentation.number_of_segments,
                    described = n > most_described ? least_range : (std::max)(least_range, n);
  ordered_json shapes = ordered_json::array();
  for (const Segment_description& shape : content.details.nodes(described))
    shapes.push_back(shape_json(shape));
  return shapes;
}

std::string text_of(const ordered_json& json)
{
  constexpr int on_one_line = -1;
  return json.dump(on_one_line, ' ', false, ordered_json::error_handler_t::replace);
}

} // namespace segment_mesh
