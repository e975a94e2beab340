// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "glTF 2.0 Specification", The Khronos Group, 2021

#include "soup/little_endian.h"
#include "view/Corner_normals.h"
#include "write/write_mesh.h"

#include <boost/algorithm/hex.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

using nlohmann::ordered_json;

/// With vertices of glTF.
struct Shaded_triangles
{
  std::vector<Point> points, normals;
  std::vector<Point> colors;                           ///< empty if there are none
  std::vector<Mesh_properties::Texture_point> texture; ///< the same; v is down
  Triangles triangles;
};

/// A vertex of glTF: a point with one normal, texture point and color.
using Vertex = std::tuple<Polygons::Index, Point, Mesh_properties::Texture_point,
                          Mesh_properties::Rgb>;

/// Of the first corner of a face that has the point.
template <typename Value>
Value value_at(const Corner_values<Value>& values, const Polygons& polygons, std::size_t face,
               std::size_t point, const Value& otherwise)
{
  if (values.empty())
    return otherwise;
  const Polygon_soup::Polygon& polygon = polygons[face];
  return values.at(
    polygons.first_corner(face) +
      std::size_t(std::find(polygon.begin(), polygon.end(), point) - polygon.begin()),
    otherwise);
}

Shaded_triangles shade(const Segment_triangles& segment)
{
  const auto& [soup, properties] = segment.part;
  const Corner_normals normals(soup.points, segment.triangles);
  Shaded_triangles result;
  std::map<Vertex, Polygons::Index> vertices;
  for (std::size_t t = 0; t < segment.triangles.size(); ++t) {
    const std::size_t face = segment.face_of_triangle[t];
    auto& triangle = result.triangles.emplace_back(segment.triangles[t]);
    for (Polygons::Index& i : triangle) {
      Point normal = normals.at(t, i);
      if (normal == Point{0, 0, 0})
        normal = {0, 0, 1}; // readers want a unit vector
      const auto texture = value_at(properties.texture, soup.polygons, face, i, {});
      const auto color = value_at(properties.colors, soup.polygons, face, i,
                                  Mesh_properties::white);
      const auto [vertex, is_new] = vertices.emplace(Vertex(i, normal, texture, color),
                                                     Polygons::Index(result.points.size()));
      if (is_new) {
        result.points.push_back(soup.points[i]);
        result.normals.push_back(normal);
        if (!properties.texture.empty())
          result.texture.push_back({texture[0], 1 - texture[1]});
        if (!properties.colors.empty())
          result.colors.push_back(
            {linear_from_srgb(color[0]), linear_from_srgb(color[1]), linear_from_srgb(color[2])});
      }
      i = vertex->second;
    }
  }
  return result;
}

/// With `%20` for a blank, and so for all that may not be in the path of a URI.
std::string to_uri(const std::string& path)
{
  std::string result;
  for (const char c : path)
    if (std::isalnum(static_cast<unsigned char>(c)) ||
        std::string_view("/._-~").find(c) != std::string_view::npos)
      result += c;
    else
      result += "%" + boost::algorithm::hex(std::string(1, c));
  return result;
}

class Glb_file
{
public:
  /// `folder`: that of the file
  Glb_file(const Mesh_properties& properties, const std::string& folder)
  {
    if (!properties.library || properties.library->gltf.empty())
      return;
    const Material_library& library = *properties.library;
    m_json.update(ordered_json::parse(library.gltf));
    m_number_of_materials = m_json["materials"].size();
    if (!m_json.contains("images"))
      return;
    std::vector<std::size_t> views;
    for (const std::string& image : library.images)
      views.push_back(add_view(image));
    std::string start = relative_name(library.folder, "x", folder);
    start = to_uri(start.substr(0, start.size() - 1)); // to the folder of the input
    for (ordered_json& image : m_json["images"])
      if (image.contains("bufferView"))
        image["bufferView"] = views[image["bufferView"]];
      else if (const std::string uri = image.value("uri", "");
               !uri.empty() && uri.find(':') == std::string::npos)
        image["uri"] = start + uri; // of a file, and not of data or of another place
  }

  void add(const Segment_triangles& segment)
  {
    const Mesh_properties& properties = segment.part.properties;
    const Shaded_triangles shaded = shade(segment);
    ordered_json attributes = {{"POSITION", add_vectors<3>(shaded.points)},
                               {"NORMAL", add_vectors<3>(shaded.normals)}};
    if (!properties.texture.empty())
      attributes["TEXCOORD_0"] = add_vectors<2>(shaded.texture);
    if (!properties.colors.empty())
      attributes["COLOR_0"] = add_vectors<3>(shaded.colors);
    std::map<std::size_t, Triangles> triangles_of_material;
    const Face_sets& materials = properties.of(Set_kind::MATERIALS);
    for (std::size_t t = 0; t < shaded.triangles.size(); ++t)
      triangles_of_material[m_number_of_materials == 0
                              ? m_json["materials"].size()
                              : materials.set_of_face[segment.face_of_triangle[t]]]
        .push_back(shaded.triangles[t]);
    ordered_json primitives = ordered_json::array();
    for (const auto& [material, triangles] : triangles_of_material) {
      primitives.push_back({{"attributes", attributes}, {"indices", add_indices(triangles)}});
      if (m_number_of_materials == 0 || material < m_number_of_materials)
        primitives.back()["material"] = material;
    }
    const std::size_t index = m_json["nodes"].size();
    m_json["scenes"][0]["nodes"].push_back(index);
    m_json["nodes"].push_back({{"name", segment.name}, {"mesh", index}});
    m_json["meshes"].push_back({{"name", segment.name}, {"primitives", std::move(primitives)}});
    if (m_number_of_materials == 0)
      add_material(segment);
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

  /// Of a segment; white where points have colors, by which it is multiplied.
  void add_material(const Segment_triangles& segment)
  {
    ordered_json color = ordered_json::array();
    for (const std::uint8_t channel : segment.color)
      color.push_back(segment.part.properties.colors.empty() ? linear_from_srgb(channel / 255.0)
                                                             : 1);
    color.push_back(1);
    m_json["materials"].push_back(
      {{"name", segment.name},
       {"doubleSided", true},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", color}, {"metallicFactor", 0}, {"roughnessFactor", 0.8}}}});
  }

  template <std::size_t Size>
  std::size_t add_vectors(const std::vector<std::array<double, Size>>& vectors)
  {
    std::string bytes;
    std::array<float, Size> least, most;
    least.fill(HUGE_VALF);
    most.fill(-HUGE_VALF);
    for (const std::array<double, Size>& p : vectors)
      for (std::size_t j = 0; j < Size; ++j) {
        const float x = float(p[j]);
        append_little_endian(bytes, x);
        least[j] = (std::min)(least[j], x);
        most[j] = (std::max)(most[j], x);
      }
    return add_accessor({{"componentType", 5126}, // float
                         {"count", vectors.size()},
                         {"type", "VEC" + std::to_string(Size)},
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
    accessor["bufferView"] = add_view(bytes);
    m_json["bufferViews"].back()["target"] = target;
    m_json["accessors"].push_back(std::move(accessor));
    return index;
  }

  std::size_t add_view(const std::string& bytes)
  {
    const std::size_t index = m_json["bufferViews"].size();
    m_json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", m_bytes.size()}, {"byteLength", bytes.size()}});
    m_bytes += bytes;
    m_bytes.resize((m_bytes.size() + 3) / 4 * 4, '\0'); // where numbers may start
    return index;
  }

  ordered_json m_json = {{"asset", {{"version", "2.0"}, {"generator", "segment_mesh"}}},
                         {"scene", 0},
                         {"scenes", ordered_json::array({ordered_json::object()})}};
  std::string m_bytes;
  std::size_t m_number_of_materials = 0; // those of the input, in place of one for each segment
};

} // namespace

void write_glb(std::ostream& out, const Labelled_mesh& mesh, const std::string& folder)
{
  Glb_file file(mesh.properties, folder);
  for (const Segment_triangles& segment : triangles_of_segments(mesh))
    file.add(segment);
  file.write(out);
}

} // namespace segment_mesh
