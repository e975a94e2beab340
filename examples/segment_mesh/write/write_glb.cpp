// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "glTF 2.0 Specification", The Khronos Group, 2021

#include "read/little_endian.h"
#include "soup/vector_algebra.h"
#include "write/write_mesh.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

using nlohmann::ordered_json;

/// Of sRGB, from 0 to 255.
double linear_channel(std::uint8_t channel)
{
  const double s = channel / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// A vertex of glTF is a point with one normal.
struct Shaded_triangles
{
  std::vector<Point> points, normals;
  Triangles triangles;
};

/// At each corner of a triangle the mean of the normals round its point, by area, of triangles that
/// are within 40 degrees of this one: the surface looks smooth, but for edges that are sharp.
Shaded_triangles shade(const Segment_triangles& segment)
{
  constexpr double cosine_of_sharp = 0.77;
  constexpr std::size_t many = 64; // a fan of n triangles would take n * n steps
  std::vector<Point> areas, units;
  std::vector<std::vector<std::size_t>> triangles_of_point(segment.points.size());
  for (const auto& [a, b, c] : segment.triangles) {
    for (const Polygons::Index i : {a, b, c})
      triangles_of_point[i].push_back(areas.size());
    areas.push_back(cross_product(minus(segment.points[b], segment.points[a]),
                                  minus(segment.points[c], segment.points[a])));
    units.push_back(unit_vector(areas.back()));
  }
  Shaded_triangles result;
  std::map<std::pair<Polygons::Index, Point>, Polygons::Index> vertices;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    auto& triangle = result.triangles.emplace_back(segment.triangles[t]);
    for (Polygons::Index& i : triangle) {
      Point sum = areas[t];
      if (triangles_of_point[i].size() <= many) {
        sum = {0, 0, 0};
        for (std::size_t other : triangles_of_point[i])
          if (inner_product(units[t], units[other]) > cosine_of_sharp)
            sum = plus(sum, areas[other]);
      }
      const Point unit = unit_vector(sum), normal = unit == Point{0, 0, 0} ? Point{0, 0, 1} : unit;
      const auto [vertex, is_new] = vertices.emplace(std::pair(i, normal),
                                                     Polygons::Index(result.points.size()));
      if (is_new) {
        result.points.push_back(segment.points[i]);
        result.normals.push_back(normal);
      }
      i = vertex->second;
    }
  }
  return result;
}

class Glb_file
{
public:
  void add(const Segment_triangles& segment)
  {
    const Shaded_triangles shaded = shade(segment);
    const std::size_t index = m_json["nodes"].size();
    const ordered_json attributes = {{"POSITION", add_vectors(shaded.points)},
                                     {"NORMAL", add_vectors(shaded.normals)}};
    ordered_json primitive = {
      {"attributes", attributes}, {"indices", add_indices(shaded.triangles)}, {"material", index}};
    m_json["scenes"][0]["nodes"].push_back(index);
    m_json["nodes"].push_back({{"name", segment.name}, {"mesh", index}});
    m_json["meshes"].push_back(
      {{"name", segment.name}, {"primitives", ordered_json::array({std::move(primitive)})}});
    ordered_json color = ordered_json::array();
    for (const std::uint8_t channel : segment.color)
      color.push_back(linear_channel(channel));
    color.push_back(1);
    m_json["materials"].push_back(
      {{"name", segment.name},
       {"doubleSided", true},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", color}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}});
  }

  void write(std::ostream& out)
  {
    if (!m_bytes.empty())
      m_json["buffers"] = ordered_json::array({{{"byteLength", m_bytes.size()}}});
    std::string json = m_json.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string header = "glTF", bytes = m_bytes.empty() ? "" : chunk("BIN", m_bytes);
    const std::string text = chunk("JSON", json);
    append_little_endian(header, std::uint32_t(2)); // the version
    append_little_endian(header, std::uint32_t(12 + text.size() + bytes.size()));
    out << header << text << bytes;
  }

private:
  static std::string chunk(std::string type, const std::string& content)
  {
    type.resize(4, '\0');
    std::string size;
    append_little_endian(size, std::uint32_t(content.size()));
    return size + type + content;
  }

  std::size_t add_vectors(const std::vector<Point>& vectors)
  {
    std::string bytes;
    std::array<float, 3> least, most;
    least.fill(HUGE_VALF);
    most.fill(-HUGE_VALF);
    for (const Point& p : vectors)
      for (std::size_t j = 0; j < 3; ++j) {
        const float x = float(p[j]);
        append_little_endian(bytes, x);
        least[j] = (std::min)(least[j], x);
        most[j] = (std::max)(most[j], x);
      }
    return add_accessor({{"componentType", 5126}, // float
                         {"count", vectors.size()},
                         {"type", "VEC3"},
                         {"min", least},
                         {"max", most}},
                        bytes, 34962); // of vertices
  }

  std::size_t add_indices(const Triangles& triangles)
  {
    std::string bytes;
    for (const auto& triangle : triangles)
      for (const std::uint32_t i : triangle)
        append_little_endian(bytes, i);
    return add_accessor({{"componentType", 5125}, // unsigned int
                         {"count", 3 * triangles.size()},
                         {"type", "SCALAR"}},
                        bytes, 34963); // of indices
  }

  std::size_t add_accessor(ordered_json accessor, const std::string& bytes, int target)
  {
    const std::size_t index = m_json["accessors"].size();
    accessor["bufferView"] = index;
    m_json["accessors"].push_back(std::move(accessor));
    m_json["bufferViews"].push_back({{"buffer", 0},
                                     {"byteOffset", m_bytes.size()},
                                     {"byteLength", bytes.size()},
                                     {"target", target}});
    m_bytes += bytes;
    return index;
  }

  ordered_json m_json = {{"asset", {{"version", "2.0"}, {"generator", "segment_mesh"}}},
                         {"scene", 0},
                         {"scenes", ordered_json::array({ordered_json::object()})}};
  std::string m_bytes;
};

} // namespace

void write_glb(std::ostream& out, const Labelled_mesh& mesh)
{
  Glb_file file;
  for (const Segment_triangles& segment : triangles_of_segments(mesh))
    file.add(segment);
  file.write(out);
}

} // namespace segment_mesh
