// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "glTF 2.0 Specification", The Khronos Group, 2021

#include "read/Face_set_builder.h"
#include "read/Gltf_file.h"
#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/read_mesh.h"
#include "soup/vector_algebra.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <numeric>
#include <utility>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

using Json = nlohmann::json;

/// What the corners of a primitive make; smaller numbers are of points and lines.
enum Mode : std::size_t { TRIANGLES = 4, TRIANGLE_STRIP = 5, TRIANGLE_FAN = 6 };

class Gltf_reader
{
public:
  Gltf_reader(const std::string& file, std::string_view bytes)
    : m_gltf(file, bytes)
  {}

  Input_mesh read()
  {
    try {
      m_gltf.open();
      read_nodes();
      finish_properties();
    } catch (const Json::out_of_range& error) {
      const std::string cause = error.what(); // "[json.exception.out_of_range.403] key 'x' not
                                              // found"
      m_gltf.fail(cause.substr(cause.find(' ') + 1));
    } catch (const Json::exception&) {
      m_gltf.fail("a value of another type than glTF has there");
    }
    if (m_number_of_skipped > 0)
      m_input.remarks.push_back(m_gltf.name() + ": " + counted(m_number_of_skipped, "primitive") +
                                " of points or lines left out");
    return std::move(m_input);
  }

private:
  struct Placed_node
  {
    std::size_t node;
    Eigen::Affine3d to_world; // of its parent
  };

  void read_nodes()
  {
    std::vector<Placed_node> open;
    for (const std::size_t node : root_nodes())
      open.push_back({node, Eigen::Affine3d::Identity()});
    std::vector<char> is_reached(m_gltf.json().contains("nodes") ? m_gltf.json()["nodes"].size()
                                                                 : 0);
    while (!open.empty()) {
      const Placed_node placed = open.back();
      open.pop_back();
      const Json& node = m_gltf.element("nodes", placed.node);
      if (std::exchange(is_reached[placed.node], true))
        m_gltf.fail("has two parents");
      if (node.contains("extensions") && node["extensions"].contains(instancing))
        m_gltf.fail("is repeated by " + gltf_extension_not_read(instancing));
      const Eigen::Affine3d to_world = placed.to_world * transformation(node);
      const Json children = m_gltf.list(node, "children");
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        open.push_back({m_gltf.index(*child, "a child"), to_world});
      if (node.contains("mesh")) {
        m_nodes.start_new(name_of(node, placed.node), m_soup.polygons.size());
        add_mesh(m_gltf.member(node, "mesh"), to_world);
      }
    }
  }

  /// A node without a name has that of its mesh.
  std::string name_of(const Json& node, std::size_t index)
  {
    const Json& mesh = m_gltf.element("meshes", m_gltf.member(node, "mesh"));
    return node.value("name", mesh.value("name", "node_" + std::to_string(index)));
  }

  /// Of the scene that is shown, the last one first; of a file without scenes the nodes without
  /// parents.
  std::vector<std::size_t> root_nodes()
  {
    std::vector<std::size_t> roots;
    m_gltf.leave_element();
    if (m_gltf.json().contains("scenes")) {
      for (const Json& node :
           m_gltf.list(m_gltf.element("scenes", m_gltf.member(m_gltf.json(), "scene", 0)), "nodes"))
        roots.push_back(m_gltf.index(node, "a node"));
    } else if (m_gltf.json().contains("nodes")) {
      std::vector<char> is_child(m_gltf.json()["nodes"].size());
      for (const Json& node : m_gltf.json()["nodes"])
        for (const Json& child : m_gltf.list(node, "children"))
          if (const std::size_t i = m_gltf.index(child, "a child"); i < is_child.size())
            is_child[i] = true;
      for (std::size_t node = 0; node < is_child.size(); ++node)
        if (!is_child[node])
          roots.push_back(node);
    }
    std::reverse(roots.begin(), roots.end());
    return roots;
  }

  Eigen::Affine3d transformation(const Json& node) const
  {
    const auto numbers = [&](const char* name, std::vector<double> otherwise) {
      const std::vector<double> result = node.value(name, otherwise);
      if (result.size() != otherwise.size())
        m_gltf.fail(std::string(name) + " has " + std::to_string(result.size()) + " of " +
                    counted(otherwise.size(), "number"));
      return result;
    };
    const auto matrix = numbers("matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
               t = numbers("translation", {0, 0, 0}), r = numbers("rotation", {0, 0, 0, 1}),
               s = numbers("scale", {1, 1, 1});
    return Eigen::Affine3d(Eigen::Matrix4d::Map(matrix.data()))
      .translate(Eigen::Vector3d::Map(t.data()))
      .rotate(Eigen::Quaterniond(Eigen::Vector4d::Map(r.data())).normalized())
      .scale(Eigen::Vector3d::Map(s.data()));
  }

  void add_mesh(std::size_t mesh, const Eigen::Affine3d& to_world)
  {
    for (const Json& primitive : m_gltf.element("meshes", mesh).at("primitives")) {
      m_gltf.element("meshes", mesh); // what messages name
      const std::size_t mode = m_gltf.member(primitive, "mode", TRIANGLES);
      if (mode > TRIANGLE_FAN)
        m_gltf.fail("an unknown mode");
      if (mode < TRIANGLES)
        ++m_number_of_skipped;
      else
        add_primitive(primitive, mode, to_world);
    }
  }

  void add_primitive(const Json& primitive, std::size_t mode, const Eigen::Affine3d& to_world)
  {
    const std::vector<double> positions = m_gltf.values(primitive.at("attributes").at("POSITION"),
                                                        "VEC3", 3);
    const std::size_t first = m_soup.points.size(), number_of_points = positions.size() / 3;
    for (std::size_t i = 0; i < number_of_points; ++i) {
      const Eigen::Vector3d p = to_world * Eigen::Vector3d::Map(&positions[3 * i]);
      m_soup.points.push_back({p.x(), p.y(), p.z()});
      if (!is_finite(m_soup.points.back()))
        m_gltf.fail("a position that is not a finite number");
    }
    std::vector<double> indices(number_of_points);
    std::iota(indices.begin(), indices.end(), 0);
    if (primitive.contains("indices"))
      indices = m_gltf.values(primitive["indices"], "SCALAR", 1);
    if (!are_below(indices, number_of_points))
      m_gltf.fail("an index of a vertex that does not exist");
    std::vector<std::size_t> corners;
    for (const double index : indices)
      corners.push_back(first + std::size_t(index));
    const std::size_t first_corner = m_soup.polygons.corners().size();
    add_triangles(corners, mode, to_world.linear().determinant() < 0);
    try_properties([&] { add_properties(primitive, first, first_corner); });
  }

  /// What is wrong with properties is no reason to refuse the mesh.
  template <typename Read>
  void try_properties(const Read& read)
  {
    try {
      read();
    } catch (const Input_error&) {
      m_has_wrong_properties = true;
    } catch (const Json::exception&) {
      m_has_wrong_properties = true;
    }
  }

  /// Of the points from `first` on and the corners from `first_corner` on: what they have beside
  /// positions.
  void add_properties(const Json& primitive, std::size_t first, std::size_t first_corner)
  {
    Mesh_properties& properties = m_input.properties;
    const Json& attributes = primitive["attributes"];
    m_materials.resize(m_soup.polygons.size(), m_gltf.member(primitive, "material", no_material));
    if (attributes.contains("COLOR_0"))
      for (const char* type : {"VEC3", "VEC4"})
        add_values<3>(attributes["COLOR_0"], type, first, first_corner, properties.colors,
                      [](double x) { return float(srgb_from_linear(x)); });
    if (attributes.contains("TEXCOORD_0"))
      add_values<2>(attributes["TEXCOORD_0"], "VEC2", first, first_corner, properties.texture,
                    [](double x) { return x; });
  }

  /// Of an accessor, if it is of this type: the first `Size` numbers of each of its elements.
  template <std::size_t Size, typename Value, typename Convert>
  void add_values(const Json& accessor, const std::string& type, std::size_t first,
                  std::size_t first_corner, Corner_values<Value>& result, const Convert& convert)
  {
    if (m_gltf.element("accessors", m_gltf.index(accessor, "an accessor")).at("type") != type)
      return;
    const std::size_t step = std::size_t(type.back() - '0'), start = result.values.size();
    const std::vector<double> numbers = m_gltf.values(accessor, type.c_str(), step);
    for (std::size_t i = 0; i < numbers.size(); i += step) {
      Value& value = result.values.emplace_back();
      for (std::size_t j = 0; j < Size; ++j)
        value[j] = convert(usable_value(numbers[i + j]));
    }
    const std::vector<Polygons::Index>& corners = m_soup.polygons.corners();
    result.of_corner.resize(first_corner, result.none);
    for (std::size_t c = first_corner; c < corners.size(); ++c) {
      const std::size_t i = start + corners[c] - first;
      result.of_corner.push_back(i < result.values.size() ? Polygons::Index(i) : result.none);
    }
  }

  void finish_properties()
  {
    Mesh_properties& properties = m_input.properties;
    for (auto& point : properties.texture.values)
      point[1] = 1 - point[1]; // v is down in glTF
    properties.of(Set_kind::GROUPS) = m_nodes.build(m_soup.polygons.size());
    if (m_gltf.json().contains("materials") && !m_gltf.json()["materials"].empty())
      try_properties([&] { add_materials(); });
    if (m_has_wrong_properties)
      m_input.remarks.push_back(
        m_gltf.name() +
        ": colors, texture coordinates or materials that are not as in glTF are left out");
  }

  void add_materials()
  {
    std::vector<std::string> names;
    for (const Json& material : m_gltf.json()["materials"])
      names.push_back(material.value("name", "material_" + std::to_string(names.size())));
    m_input.properties.library = std::make_shared<Material_library>(library());
    Face_sets& materials = m_input.properties.of(Set_kind::MATERIALS);
    m_materials.resize(m_soup.polygons.size(), no_material);
    for (std::size_t material : m_materials)
      materials.set_of_face.push_back(Polygons::Index((std::min)(material, names.size())));
    names.push_back("unnamed");
    materials.names = std::make_shared<const std::vector<std::string>>(std::move(names));
  }

  /// The materials, with the bytes of images that are in buffers.
  Material_library library() const
  {
    Material_library result;
    result.folder = fs::path(m_gltf.name()).parent_path().string();
    Json json;
    for (const char* name : {"materials", "textures", "samplers", "images"})
      if (m_gltf.json().contains(name))
        json[name] = m_gltf.json()[name];
    for (const char* name : {"extensionsUsed", "extensionsRequired"})
      for (const Json& extension : m_gltf.list(m_gltf.json(), name))
        if (is_of_gltf_materials(extension))
          json[name].push_back(extension);
    std::size_t size = 0, most = 0;
    for (const std::string& buffer : m_gltf.buffers())
      most += buffer.size();
    for (std::size_t i = 0; json.contains("images") && i < json["images"].size(); ++i) {
      Json& image = json["images"][i];
      const std::string uri = image.value("uri", ""); // fails if it is no text
      if (!image.contains("bufferView"))
        continue;
      const Json& view = m_gltf.json().at("bufferViews").at(std::size_t(image["bufferView"]));
      image["bufferView"] = result.images.size();
      const std::size_t buffer = view.at("buffer"),
                        start = view.value("byteOffset", std::size_t(0));
      const std::string_view bytes = buffer < m_gltf.buffers().size()
                                       ? std::string_view(m_gltf.buffers()[buffer])
                                       : std::string_view();
      result.images.emplace_back(
        bytes.substr((std::min)(start, bytes.size()), view.at("byteLength")));
      if ((size += result.images.back().size()) > most)
        m_gltf.fail("images that overlap");
    }
    result.gltf = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return result;
  }

  /// \param is_mirrored corners then run the other way round
  void add_triangles(const std::vector<std::size_t>& corners, std::size_t mode, bool is_mirrored)
  {
    const std::size_t step = mode == TRIANGLES ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      const std::size_t a = corners[mode == TRIANGLE_FAN ? 0 : i];
      std::size_t b = corners[i + 1], c = corners[i + 2];
      if (step == 1 && (a == b || b == c || c == a))
        continue; // leads from one strip to the next
      if (is_mirrored != (mode == TRIANGLE_STRIP && i % 2 == 1))
        std::swap(b, c);
      m_soup.polygons.push_back({a, b, c});
    }
  }

  static constexpr std::size_t no_material = std::size_t(-1);
  static constexpr const char* instancing = "EXT_mesh_gpu_instancing";

  Gltf_file m_gltf;
  Input_mesh m_input;
  Polygon_soup& m_soup = m_input.soup;
  Face_set_builder m_nodes;
  std::vector<std::size_t> m_materials; // of the faces
  bool m_has_wrong_properties = false;
  std::size_t m_number_of_skipped = 0;
};

} // namespace

Input_mesh read_gltf(const std::string& file, std::string_view bytes)
{
  return Gltf_reader(file, bytes).read();
}

} // namespace segment_mesh
