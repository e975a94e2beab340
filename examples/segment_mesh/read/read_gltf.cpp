// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "glTF 2.0 Specification", The Khronos Group, 2021

#include "read/Face_set_builder.h"
#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/little_endian.h"
#include "read/read_mesh.h"
#include "soup/vector_algebra.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

using Json = nlohmann::json;

std::string from_base64(std::string_view text)
{
  constexpr std::string_view
    digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, number_of_bits = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos)
      continue;
    bits = bits << 6 | unsigned(digit);
    number_of_bits += 6;
    if (number_of_bits >= 8) {
      number_of_bits -= 8;
      bytes += char(bits >> number_of_bits & 0xff);
    }
  }
  return bytes;
}

/// With each `%20` replaced by the character of that number.
std::string from_uri(const std::string& uri)
{
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    const bool is_code = uri[i] == '%' && i + 2 < uri.size() &&
                         std::from_chars(&uri[i + 1], &uri[i + 1] + 2, value, 16).ptr ==
                           &uri[i + 1] + 2;
    result += is_code ? char(value) : uri[i];
    i += is_code ? 2 : 0;
  }
  return result;
}

bool is_of_materials(const std::string& extension)
{
  const char* const starts[] = {"KHR_materials_", "KHR_texture_", "EXT_texture_"};
  return std::any_of(std::begin(starts), std::end(starts),
                     [&](const char* start) { return extension.rfind(start, 0) == 0; });
}

/// Whether an extension changes no triangle, or only lets positions be integers.
bool is_harmless(const std::string& extension)
{
  return is_of_materials(extension) || extension == "KHR_mesh_quantization" ||
         extension.rfind("KHR_lights_", 0) == 0;
}

bool is_compression(const std::string& extension)
{
  return extension.find("compression") != std::string::npos;
}

/// "the extension 'NAME', which is not read", and what to do about it.
std::string not_read(const std::string& extension)
{
  return "the extension " + in_quotes(extension) + ", which is not read" +
         (is_compression(extension) ? ": save it without compression" : "");
}

/// Whether the numbers are indices of some of `size` elements.
bool are_below(const std::vector<double>& indices, std::size_t size)
{
  return std::all_of(indices.begin(), indices.end(),
                     [size](double index) { return index >= 0 && index < double(size); });
}

/// What the corners of a primitive make; smaller numbers are of points and lines.
enum Mode : std::size_t { TRIANGLES = 4, TRIANGLE_STRIP = 5, TRIANGLE_FAN = 6 };

class Gltf_reader
{
public:
  Gltf_reader(const std::string& file, std::string_view bytes)
    : m_file(file)
    , m_most_numbers(1000000 + most_numbers_per_byte * bytes.size())
    , m_text(bytes)
  {
    if (bytes.substr(0, 4) == "glTF")
      split(bytes);
    check_encoding(file, m_text);
  }

  Input_mesh read()
  {
    try {
      parse();
      read_header();
      read_nodes();
      finish_properties(m_input.remarks);
    } catch (const Json::out_of_range& error) {
      const std::string cause = error.what(); // "[json.exception.out_of_range.403] key 'x' not
                                              // found"
      fail(cause.substr(cause.find(' ') + 1));
    } catch (const Json::exception&) {
      fail("a value of another type than glTF has there");
    }
    if (m_number_of_skipped > 0)
      m_input.remarks.push_back(m_file + ": " + counted(m_number_of_skipped, "primitive") +
                                " of points or lines left out");
    return std::move(m_input);
  }

private:
  /// Its messages would quote the text.
  void parse()
  {
    try {
      const auto check_depth = [this](int depth, Json::parse_event_t, const Json&) {
        constexpr int deepest = 1000; // more would exhaust the stack
        if (depth > deepest)
          fail("the text is nested too deeply");
        return true;
      };
      m_json = Json::parse(m_text.begin(), m_text.end(), check_depth);
    } catch (const Json::parse_error& error) {
      const auto end = m_text.begin() + std::ptrdiff_t((std::min)(error.byte, m_text.size()));
      throw Input_error(m_file, 1 + std::size_t(std::count(m_text.begin(), end, '\n')),
                        "the text is not JSON");
    } catch (const Json::out_of_range&) {
      fail("a number of the text is not a finite number");
    }
  }

  struct Placed_node
  {
    std::size_t node;
    Eigen::Affine3d to_world; // of its parent
  };

  [[noreturn]] void fail(const std::string& cause) const
  {
    throw Input_error(m_file, m_place + cause);
  }

  /// Finds the text and the first buffer of a .glb file.
  void split(std::string_view bytes)
  {
    const auto number = [bytes](std::size_t at) {
      return std::size_t(read_little_endian<std::uint32_t>(&bytes[at]));
    };
    const auto chunk = [&](std::size_t start) {
      if (bytes.size() < start + 8)
        return std::string_view();
      const std::string_view rest = bytes.substr(start + 8);
      if (number(start) > rest.size())
        fail("is cut off: a chunk has " + counted(rest.size(), "byte") + " of " +
             std::to_string(number(start)));
      return rest.substr(0, number(start));
    };
    constexpr std::size_t size_of_header = 12;
    if (bytes.size() < size_of_header + 8)
      fail("is cut off");
    if (number(4) != 2)
      fail("is of glTF version " + std::to_string(number(4)) + "; version 2 is read");
    m_text = chunk(size_of_header);
    m_binary = chunk(size_of_header + 8 + m_text.size());
  }

  /// An element of a list of the file, which messages name from now on.
  const Json& element(const char* list, std::size_t i)
  {
    m_place = std::string(list) + "[" + std::to_string(i) + "]: ";
    return m_json.at(list).at(i);
  }

  std::size_t index(const Json& value, const char* name) const
  {
    if (!value.is_number_unsigned())
      fail(std::string(name) + " is not an integer of at least 0");
    return value.get<std::size_t>();
  }

  /// A member of an object.
  std::size_t member(const Json& object, const char* name) const
  {
    return index(object.at(name), name);
  }

  std::size_t member(const Json& object, const char* name, std::size_t otherwise) const
  {
    return object.contains(name) ? member(object, name) : otherwise;
  }

  /// A member that is a list; an empty one where it is missing.
  static Json list(const Json& object, const char* name)
  {
    return object.value(name, Json::array());
  }

  void read_header()
  {
    const std::string version = m_json.at("asset").at("version");
    if (version.rfind("2.", 0) != 0)
      fail("is of glTF version " + in_quotes(version) + "; version 2 is read");
    for (const Json& extension : list(m_json, "extensionsRequired"))
      if (!is_harmless(extension))
        fail("needs " + not_read(extension));
    for (const Json& extension : list(m_json, "extensionsUsed"))
      if (is_compression(extension))
        m_hint = ": the file uses " + not_read(extension);
    for (std::size_t i = 0; m_json.contains("buffers") && i < m_json["buffers"].size(); ++i) {
      const Json& buffer = element("buffers", i);
      const std::size_t size = member(buffer, "byteLength");
      const bool has_uri = buffer.contains("uri");
      m_buffers.push_back(has_uri ? load(buffer["uri"], size)
                                  : std::string(i == 0 ? m_binary : ""));
      m_most_numbers += most_numbers_per_byte * m_buffers[i].size();
      if ((has_uri || !m_buffers[i].empty()) && m_buffers[i].size() < size)
        fail("has " + std::to_string(m_buffers[i].size()) + " of " + counted(size, "byte"));
    }
  }

  /// The bytes of a buffer that are in its URI, or the first ones of a file of the folder of the
  /// file or below it.
  std::string load(const std::string& uri, std::size_t size) const
  {
    constexpr std::string_view encoding = ";base64,";
    if (uri.rfind("data:", 0) == 0) {
      const std::size_t start = uri.find(encoding);
      if (start == std::string::npos)
        fail("data that are not in base64");
      return from_base64(std::string_view(uri).substr(start + encoding.size()));
    }
    fs::path folder = fs::path(m_file).parent_path().lexically_normal();
    folder = folder.empty() ? fs::path(".") : folder;
    const fs::path path = (folder / from_uri(uri)).lexically_normal();
    const fs::path relative = path.lexically_relative(folder);
    if (relative.empty() || *relative.begin() == "..")
      fail(in_quotes(uri) + " is not in the folder of the file");
    std::error_code error;
    if (!fs::is_regular_file(path, error)) // a pipe would be waited for
      fail(in_quotes(uri) + " is not a file");
    std::ifstream in(path, std::ios::binary);
    std::string bytes((std::min)(size, std::size_t(fs::file_size(path))), '\0');
    if (!in.read(bytes.data(), std::streamsize(bytes.size())))
      fail(in_quotes(uri) + " cannot be read");
    return bytes;
  }

  void read_nodes()
  {
    std::vector<Placed_node> open;
    for (const std::size_t node : root_nodes())
      open.push_back({node, Eigen::Affine3d::Identity()});
    std::vector<char> is_reached(m_json.contains("nodes") ? m_json["nodes"].size() : 0);
    while (!open.empty()) {
      const Placed_node placed = open.back();
      open.pop_back();
      const Json& node = element("nodes", placed.node);
      if (std::exchange(is_reached[placed.node], true))
        fail("has two parents");
      if (node.contains("extensions") && node["extensions"].contains(instancing))
        fail("is repeated by " + not_read(instancing));
      const Eigen::Affine3d to_world = placed.to_world * transformation(node);
      const Json children = list(node, "children");
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        open.push_back({index(*child, "a child"), to_world});
      if (node.contains("mesh")) {
        m_nodes.start_new(name_of(node, placed.node), m_soup.polygons.size());
        add_mesh(member(node, "mesh"), to_world);
      }
    }
  }

  /// A node without a name has that of its mesh.
  std::string name_of(const Json& node, std::size_t index)
  {
    const Json& mesh = element("meshes", member(node, "mesh"));
    return node.value("name", mesh.value("name", "node_" + std::to_string(index)));
  }

  /// Of the scene that is shown, the last one first; of a file without scenes the nodes without
  /// parents.
  std::vector<std::size_t> root_nodes()
  {
    std::vector<std::size_t> roots;
    m_place.clear();
    if (m_json.contains("scenes")) {
      for (const Json& node : list(element("scenes", member(m_json, "scene", 0)), "nodes"))
        roots.push_back(index(node, "a node"));
    } else if (m_json.contains("nodes")) {
      std::vector<char> is_child(m_json["nodes"].size());
      for (const Json& node : m_json["nodes"])
        for (const Json& child : list(node, "children"))
          if (const std::size_t i = index(child, "a child"); i < is_child.size())
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
        fail(std::string(name) + " has " + std::to_string(result.size()) + " of " +
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
    for (const Json& primitive : element("meshes", mesh).at("primitives")) {
      element("meshes", mesh); // what messages name
      const std::size_t mode = member(primitive, "mode", TRIANGLES);
      if (mode > TRIANGLE_FAN)
        fail("an unknown mode");
      if (mode < TRIANGLES)
        ++m_number_of_skipped;
      else
        add_primitive(primitive, mode, to_world);
    }
  }

  void add_primitive(const Json& primitive, std::size_t mode, const Eigen::Affine3d& to_world)
  {
    const std::vector<double> positions = values(primitive.at("attributes").at("POSITION"), "VEC3",
                                                 3);
    const std::size_t first = m_soup.points.size(), number_of_points = positions.size() / 3;
    for (std::size_t i = 0; i < number_of_points; ++i) {
      const Eigen::Vector3d p = to_world * Eigen::Vector3d::Map(&positions[3 * i]);
      m_soup.points.push_back({p.x(), p.y(), p.z()});
      if (!is_finite(m_soup.points.back()))
        fail("a position that is not a finite number");
    }
    std::vector<double> indices(number_of_points);
    std::iota(indices.begin(), indices.end(), 0);
    if (primitive.contains("indices"))
      indices = values(primitive["indices"], "SCALAR", 1);
    if (!are_below(indices, number_of_points))
      fail("an index of a vertex that does not exist");
    std::vector<std::size_t> corners;
    for (const double index : indices)
      corners.push_back(first + std::size_t(index));
    const std::size_t first_corner = m_soup.polygons.corners().size();
    add_triangles(corners, mode, to_world.linear().determinant() < 0);
    add_properties(primitive, first, first_corner);
  }

  /// Of the points from `first` on and the corners from `first_corner` on: what they have beside
  /// positions. What is wrong with it is no reason to refuse the mesh.
  void add_properties(const Json& primitive, std::size_t first, std::size_t first_corner)
  {
    Mesh_properties& properties = m_input.properties;
    const Json& attributes = primitive["attributes"];
    try {
      m_materials.resize(m_soup.polygons.size(), member(primitive, "material", no_material));
      if (attributes.contains("COLOR_0"))
        for (const char* type : {"VEC3", "VEC4"})
          add_values<3>(attributes["COLOR_0"], type, first, first_corner, properties.colors,
                        [](double x) { return float(srgb_from_linear(x)); });
      if (attributes.contains("TEXCOORD_0"))
        add_values<2>(attributes["TEXCOORD_0"], "VEC2", first, first_corner, properties.texture,
                      [](double x) { return x; });
    } catch (const Input_error&) {
      m_has_wrong_properties = true;
    } catch (const Json::exception&) {
      m_has_wrong_properties = true;
    }
  }

  /// Of an accessor, if it is of this type: the first `Size` numbers of each of its elements.
  template <std::size_t Size, typename Value, typename Convert>
  void add_values(const Json& accessor, const std::string& type, std::size_t first,
                  std::size_t first_corner, Corner_values<Value>& result, const Convert& convert)
  {
    if (element("accessors", index(accessor, "an accessor")).at("type") != type)
      return;
    const std::size_t step = std::size_t(type.back() - '0'), start = result.values.size();
    const std::vector<double> numbers = values(accessor, type.c_str(), step);
    for (std::size_t i = 0; i < numbers.size(); i += step) {
      Value& value = result.values.emplace_back();
      for (std::size_t j = 0; j < Size; ++j)
        value[j] = convert(std::isfinite(numbers[i + j]) ? numbers[i + j] : 0);
    }
    const std::vector<Polygons::Index>& corners = m_soup.polygons.corners();
    result.of_corner.resize(first_corner, result.none);
    for (std::size_t c = first_corner; c < corners.size(); ++c) {
      const std::size_t i = start + corners[c] - first;
      result.of_corner.push_back(i < result.values.size() ? Polygons::Index(i) : result.none);
    }
  }

  void finish_properties(Remarks& remarks)
  {
    Mesh_properties& properties = m_input.properties;
    for (auto& point : properties.texture.values)
      point[1] = 1 - point[1]; // v is down in glTF
    const std::size_t number_of_corners = m_soup.polygons.corners().size();
    if (!properties.texture.empty())
      properties.texture.of_corner.resize(number_of_corners, properties.texture.none);
    if (!properties.colors.empty())
      properties.colors.of_corner.resize(number_of_corners, properties.colors.none);
    properties.of(Set_kind::GROUPS) = m_nodes.build(m_soup.polygons.size());
    try {
      if (m_json.contains("materials") && !m_json["materials"].empty())
        add_materials();
    } catch (const Input_error&) {
      m_has_wrong_properties = true;
    } catch (const Json::exception&) {
      m_has_wrong_properties = true;
    }
    if (m_has_wrong_properties)
      remarks.push_back(
        m_file + ": colors, texture coordinates or materials that are not as in glTF are left out");
  }

  void add_materials()
  {
    std::vector<std::string> names;
    for (const Json& material : m_json["materials"])
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
    result.folder = fs::path(m_file).parent_path().string();
    Json json;
    for (const char* name : {"materials", "textures", "samplers", "images"})
      if (m_json.contains(name))
        json[name] = m_json[name];
    for (const char* name : {"extensionsUsed", "extensionsRequired"})
      for (const Json& extension : list(m_json, name))
        if (is_of_materials(extension))
          json[name].push_back(extension);
    std::size_t size = 0, most = 0;
    for (const std::string& buffer : m_buffers)
      most += buffer.size();
    std::map<std::size_t, std::size_t> place_of_view;
    for (std::size_t i = 0; json.contains("images") && i < json["images"].size(); ++i) {
      Json& image = json["images"][i];
      const std::string uri = image.value("uri", ""); // fails if it is no text
      if (!image.contains("bufferView"))
        continue;
      const std::size_t index = image["bufferView"];
      const auto [place, is_new] = place_of_view.emplace(index, result.images.size());
      image["bufferView"] = place->second;
      const Json& view = m_json.at("bufferViews").at(index);
      const std::size_t buffer = view.at("buffer"),
                        start = view.value("byteOffset", std::size_t(0));
      const std::string_view bytes = buffer < m_buffers.size() ? std::string_view(m_buffers[buffer])
                                                               : std::string_view();
      if (!is_new)
        continue;
      result.images.emplace_back(
        bytes.substr((std::min)(start, bytes.size()), view.at("byteLength")));
      if ((size += result.images.back().size()) > most)
        fail("images that overlap");
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

  /// The numbers of an accessor, `size` of them for each element.
  std::vector<double> values(const Json& accessor_index, const char* type, std::size_t size)
  {
    const Json& accessor = element("accessors", index(accessor_index, "an accessor"));
    if (accessor.at("type") != type)
      fail("has another type than its use");
    const std::size_t count = member(accessor, "count");
    if (count > m_most_numbers || (m_number_of_numbers += count * size) > m_most_numbers)
      fail("more points than the file has, or a mesh that is repeated too often");
    std::vector<double> result(count * size);
    if (accessor.contains("bufferView"))
      result = stored(accessor, accessor, count, size);
    else if (!accessor.contains("sparse"))
      fail("has no data" + m_hint);
    if (accessor.contains("sparse")) {
      const Json& sparse = accessor["sparse"];
      const std::size_t number = member(sparse, "count");
      const std::vector<double> places = stored(sparse.at("indices"), sparse.at("indices"), number,
                                                1),
                                changes = stored(sparse.at("values"), accessor, number, size);
      if (!are_below(places, count))
        fail("an index of an element that does not exist");
      for (std::size_t i = 0; i < number; ++i)
        std::copy_n(&changes[i * size], size, &result[std::size_t(places[i]) * size]);
    }
    return result;
  }

  /// Numbers of a buffer.
  /// \param place names their buffer view
  /// \param format names their type
  std::vector<double> stored(const Json& place, const Json& format, std::size_t count,
                             std::size_t components) const
  {
    constexpr std::size_t first_type = 5120;
    const std::size_t code = member(format, "componentType");
    if (code < first_type || code > first_type + std::size_t(Number_type::FLOAT32))
      fail("an unknown type of numbers");
    const Number_type type = Number_type(code - first_type);
    const bool is_normalized = format.value("normalized", false);

    const Json& view = m_json.at("bufferViews").at(member(place, "bufferView"));
    const std::size_t buffer = member(view, "buffer"), start = member(view, "byteOffset", 0),
                      length = member(view, "byteLength");
    const std::size_t size = components * size_of(type), offset = member(place, "byteOffset", 0),
                      stride = member(view, "byteStride", size);
    if (stride < size)
      fail("elements that overlap: a byteStride of " + counted(stride, "byte"));
    if (buffer >= m_buffers.size() || m_buffers[buffer].empty())
      fail("has no data" + m_hint);
    const std::string_view bytes = std::string_view(m_buffers[buffer])
                                     .substr((std::min)(start, m_buffers[buffer].size()), length);
    if (count > 0 && (offset > bytes.size() || size > bytes.size() - offset ||
                      count - 1 > (bytes.size() - offset - size) / stride))
      fail("reaches beyond the end of its data");
    std::vector<double> result;
    result.reserve(count * components);
    with_type(type, [&](auto zero) {
      using Number = decltype(zero);
      constexpr double unit = double((std::numeric_limits<Number>::max)());
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < components; ++j) {
          const double number = read_little_endian<Number>(
            &bytes[offset + i * stride + j * sizeof(Number)]);
          result.push_back(is_normalized ? (std::max)(number / unit, -1.0) : number);
        }
    });
    return result;
  }

  /// Many nodes may show one mesh, as of a screw; what is repeated more often was made to exhaust
  /// the memory.
  static constexpr std::size_t most_numbers_per_byte = 30;
  static constexpr std::size_t no_material = std::size_t(-1);
  static constexpr const char* instancing = "EXT_mesh_gpu_instancing";

  const std::string& m_file;
  std::size_t m_most_numbers, m_number_of_numbers = 0; // of coordinates and indices
  std::string_view m_text, m_binary;
  Json m_json;
  std::string m_place; // in messages: what is read, with a colon
  std::string m_hint;  // on data that are not there
  std::vector<std::string> m_buffers;
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
