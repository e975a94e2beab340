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
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

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

/// The parts of a .glb file, as they are added.
class Glb_model
{
public:
  void add(const Segment_triangles& segment)
  {
    const Shaded_triangles shaded = shade(segment);
    const std::size_t positions = add_vectors(shaded.points), normals = add_vectors(shaded.normals),
                      indices = add_indices(shaded.triangles), i = m_json["meshes"].size();
    m_json["meshes"].push_back(
      {{"name", segment.name},
       {"primitives", Json::array({{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}},
                                    {"indices", indices},
                                    {"material", i}}})}});
    m_json["nodes"].push_back({{"name", segment.name}, {"mesh", i}});
    m_json["scenes"][0]["nodes"].push_back(i);
    Json color = Json::array({1, 1, 1, 1});
    for (std::size_t j = 0; j < 3; ++j)
      color[j] = linear_channel(segment.color[j]);
    m_json["materials"].push_back(
      {{"name", segment.name},
       {"doubleSided", true},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", color}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}});
  }

  void write(std::ostream& out)
  {
    m_json["buffers"] = Json::array({{{"byteLength", m_bytes.size()}}});
    std::string text = m_json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string header = "glTF", binary_chunk;
    for (const std::size_t number :
         {std::size_t(2), 12 + 8 + text.size() + 8 + m_bytes.size(), text.size()})
      append_little_endian(header, std::uint32_t(number));
    append_little_endian(binary_chunk, std::uint32_t(m_bytes.size()));
    out << header << "JSON" << text << binary_chunk << std::string("BIN\0", 4) << m_bytes;
  }

private:
  using Json = nlohmann::json;

  std::size_t add_vectors(const std::vector<Point>& vectors)
  {
    const std::size_t start = m_bytes.size();
    std::array<float, 3> least, greatest;
    least.fill(HUGE_VALF);
    greatest.fill(-HUGE_VALF);
    for (const Point& p : vectors)
      for (std::size_t j = 0; j < 3; ++j) {
        const float x = float(p[j]);
        append_little_endian(m_bytes, x);
        least[j] = (std::min)(least[j], x);
        greatest[j] = (std::max)(greatest[j], x);
      }
    constexpr int float_type = 5126, vertices = 34962;
    return add_accessor({{"componentType", float_type},
                         {"type", "VEC3"},
                         {"count", vectors.size()},
                         {"min", least},
                         {"max", greatest}},
                        start, vertices);
  }

  std::size_t add_indices(const Triangles& triangles)
  {
    const std::size_t start = m_bytes.size();
    for (const auto& triangle : triangles)
      for (std::uint32_t i : triangle)
        append_little_endian(m_bytes, i);
    constexpr int unsigned_type = 5125, indices = 34963;
    return add_accessor(
      {{"componentType", unsigned_type}, {"type", "SCALAR"}, {"count", 3 * triangles.size()}},
      start, indices);
  }

  /// Of the bytes from `start` on. \returns its number
  std::size_t add_accessor(Json accessor, std::size_t start, int target)
  {
    accessor["bufferView"] = m_json["bufferViews"].size();
    m_json["bufferViews"].push_back({{"buffer", 0},
                                     {"byteOffset", start},
                                     {"byteLength", m_bytes.size() - start},
                                     {"target", target}});
    m_json["accessors"].push_back(std::move(accessor));
    return m_json["accessors"].size() - 1;
  }

  Json m_json = {{"asset", {{"version", "2.0"}, {"generator", "segment_mesh"}}},
                 {"scene", 0},
                 {"scenes", Json::array({Json::object()})}};
  std::string m_bytes;
};

} // namespace

void write_glb(std::ostream& out, const Labelled_mesh& mesh)
{
  Glb_model model;
  for (const Segment_triangles& segment : triangles_of_segments(mesh))
    model.add(segment);
  model.write(out);
}

} // namespace segment_mesh
