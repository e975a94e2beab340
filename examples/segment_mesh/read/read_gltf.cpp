// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "glTF 2.0 Specification", The Khronos Group, 2021

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/little_endian.h"
#include "read/read_soup.h"
#include "read/tinygltf.h"
#include "soup/merge_equal_points.h"
#include "soup/vector_algebra.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

/// \name Files beside a .gltf file: of its folder and those below it
/// @{
bool is_beside(const std::string& path, void*)
{
  return fs::is_regular_file(path);
}

std::string same_path(const std::string& path, void*)
{
  return path;
}

bool read_beside(std::vector<unsigned char>* bytes, std::string* error, const std::string& path,
                 void* folder)
{
  const fs::path relative = fs::path(path).lexically_normal().lexically_relative(
    *static_cast<const fs::path*>(folder));
  if (relative.empty() || *relative.begin() == "..") {
    *error += path + " is not in the folder of the file\n";
    return false;
  }
  std::ifstream in(path, std::ios::binary);
  bytes->assign(std::istreambuf_iterator<char>(in), {});
  return bool(in);
}
/// @}

bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
                int, void*)
{
  return true;
}

tinygltf::Model parse(const std::string& file, std::string_view bytes)
{
  fs::path folder = fs::path(file).parent_path().lexically_normal();
  folder = folder.empty() ? fs::path(".") : folder;
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(skip_image, nullptr);
  parser.SetFsCallbacks({is_beside, same_path, read_beside, nullptr, &folder});
  if (bytes.size() > (std::numeric_limits<unsigned>::max)())
    throw Input_error(file, "has more than 4 GB");
  tinygltf::Model model;
  std::string error, warning;
  const bool is_binary = bytes.substr(0, 4) == "glTF";
  const unsigned size = unsigned(bytes.size());
  if (is_binary
        ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                      reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                      folder.string())
        : parser.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder.string()))
    return model;
  throw Input_error(file, error.empty() ? "is no glTF file" : error.substr(0, error.find('\n')));
}

/// The values of an accessor, all within its buffer.
class Values
{
public:
  /// \throws Input_error if they are not there, or have another type
  Values(const std::string& file, const tinygltf::Model& model, int accessor, int type)
  {
    const auto require = [&](bool condition, const char* what) {
      if (!condition)
        throw Input_error(file, "accessor " + std::to_string(accessor) + " " + what);
    };
    require(accessor >= 0 && std::size_t(accessor) < model.accessors.size(), "does not exist");
    const tinygltf::Accessor& a = model.accessors[std::size_t(accessor)];
    require(a.type == type, "has another type than its use");
    require(!a.sparse.isSparse, "is sparse, which is not supported");
    require(a.bufferView >= 0, "has no data: compressed meshes are not supported");
    require(std::size_t(a.bufferView) < model.bufferViews.size(),
            "has a buffer view that does not exist");
    const tinygltf::BufferView& view = model.bufferViews[std::size_t(a.bufferView)];
    require(view.buffer >= 0 && std::size_t(view.buffer) < model.buffers.size(),
            "has a buffer that does not exist");
    const std::vector<unsigned char>& data = model.buffers[std::size_t(view.buffer)].data;
    require(view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset,
            "has a buffer view beyond the end of its buffer");
    const int stride = a.ByteStride(view),
              component_size = tinygltf::GetComponentSizeInBytes(std::uint32_t(a.componentType)),
              components = tinygltf::GetNumComponentsInType(std::uint32_t(a.type));
    require(stride > 0 && component_size > 0 && components > 0, "has an unknown type");
    const std::size_t size = std::size_t(components * component_size);
    require(a.count == 0 ||
              (a.byteOffset <= view.byteLength && size <= view.byteLength - a.byteOffset &&
               a.count - 1 <= (view.byteLength - a.byteOffset - size) / std::size_t(stride)),
            "reaches beyond the end of its buffer view");
    m_size = a.count;
    m_stride = std::size_t(stride);
    m_component_size = std::size_t(component_size);
    m_type = a.componentType;
    m_is_normalized = a.normalized;
    m_data = reinterpret_cast<const char*>(data.data()) + view.byteOffset + a.byteOffset;
  }

  std::size_t size() const { return m_size; }

  double operator()(std::size_t i, std::size_t component = 0) const
  {
    const char* const at = m_data + i * m_stride + component * m_component_size;
    switch (m_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return normalized<std::int8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalized<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return normalized<std::int16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return normalized<std::uint16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return normalized<std::uint32_t>(at);
    default:
      return m_component_size == sizeof(double) ? read_little_endian<double>(at)
                                                : read_little_endian<float>(at);
    }
  }

private:
  template <typename Integer>
  double normalized(const char* at) const
  {
    const double value = read_little_endian<Integer>(at);
    return m_is_normalized ? value / (std::numeric_limits<Integer>::max)() : value;
  }

  std::size_t m_size, m_stride, m_component_size;
  int m_type;
  bool m_is_normalized;
  const char* m_data;
};

class Gltf_reader
{
public:
  Gltf_reader(const std::string& file, std::string_view bytes)
    : m_file(file)
    , m_model(parse(file, bytes))
  {
    for (const tinygltf::Buffer& buffer : m_model.buffers)
      m_most_numbers += most_numbers_per_byte * buffer.data.size();
  }

  Polygon_soup read(Remarks& remarks)
  {
    std::vector<Placed_node> open;
    for (int node : root_nodes())
      open.push_back({node, Eigen::Affine3d::Identity()});
    std::vector<char> is_reached(m_model.nodes.size());
    while (!open.empty()) {
      const Placed_node placed = open.back();
      open.pop_back();
      if (placed.node < 0 || std::size_t(placed.node) >= m_model.nodes.size())
        throw Input_error(m_file, "node " + std::to_string(placed.node) + " does not exist");
      if (std::exchange(is_reached[std::size_t(placed.node)], true))
        throw Input_error(m_file, "node " + std::to_string(placed.node) + " has two parents");
      const tinygltf::Node& node = m_model.nodes[std::size_t(placed.node)];
      const Eigen::Affine3d to_world = placed.to_world * transformation(node);
      if (node.mesh >= 0)
        add_mesh(node.mesh, to_world);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        open.push_back({*child, to_world});
    }
    if (m_number_of_skipped > 0)
      remarks.push_back(m_file + ": " + counted(m_number_of_skipped, "primitive") +
                        " of points or lines left out");
    if (m_soup.polygons.empty())
      throw Input_error(m_file, "no faces");
    merge_equal_points(m_soup);
    return std::move(m_soup);
  }

private:
  struct Placed_node
  {
    int node;
    Eigen::Affine3d to_world; // of its parent
  };

  /// Of the scene that is shown, the last one first; of a file without scenes the nodes without
  /// parents.
  std::vector<int> root_nodes() const
  {
    std::vector<int> roots;
    if (!m_model.scenes.empty()) {
      const std::size_t scene = std::size_t((std::max)(m_model.defaultScene, 0));
      if (scene >= m_model.scenes.size())
        throw Input_error(m_file, "scene " + std::to_string(scene) + " does not exist");
      roots = m_model.scenes[scene].nodes;
    } else {
      std::vector<char> is_child(m_model.nodes.size());
      for (const tinygltf::Node& node : m_model.nodes)
        for (int child : node.children)
          if (child >= 0 && std::size_t(child) < is_child.size())
            is_child[std::size_t(child)] = true;
      for (std::size_t node = 0; node < is_child.size(); ++node)
        if (!is_child[node])
          roots.push_back(int(node));
    }
    std::reverse(roots.begin(), roots.end());
    return roots;
  }

  Eigen::Affine3d transformation(const tinygltf::Node& node) const
  {
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    const auto& t = node.translation;
    const auto& r = node.rotation;
    const auto& s = node.scale;
    if (node.matrix.size() == 16)
      result.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    if (t.size() == 3)
      result.translate(Eigen::Vector3d(t[0], t[1], t[2]));
    if (r.size() == 4)
      result.rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized());
    if (s.size() == 3)
      result.scale(Eigen::Vector3d(s[0], s[1], s[2]));
    return result;
  }

  void add_mesh(int mesh, const Eigen::Affine3d& to_world)
  {
    if (std::size_t(mesh) >= m_model.meshes.size())
      throw Input_error(m_file, "mesh " + std::to_string(mesh) + " does not exist");
    for (const tinygltf::Primitive& primitive : m_model.meshes[std::size_t(mesh)].primitives)
      if (primitive.mode < TINYGLTF_MODE_TRIANGLES && primitive.mode >= 0)
        ++m_number_of_skipped;
      else
        add_primitive(primitive, to_world);
  }

  void add_primitive(const tinygltf::Primitive& primitive, const Eigen::Affine3d& to_world)
  {
    const auto attribute = primitive.attributes.find("POSITION");
    if (attribute == primitive.attributes.end())
      throw Input_error(m_file, "a primitive without positions");
    const Values positions(m_file, m_model, attribute->second, TINYGLTF_TYPE_VEC3);
    const std::size_t first = m_soup.points.size();
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Eigen::Vector3d p = to_world *
                                Eigen::Vector3d(positions(i, 0), positions(i, 1), positions(i, 2));
      m_soup.points.push_back({p.x(), p.y(), p.z()});
      if (!is_finite(m_soup.points.back()))
        throw Input_error(m_file, "a position that is not a finite number");
    }

    std::vector<std::size_t> corners;
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < positions.size(); ++i)
        corners.push_back(first + i);
    } else {
      const Values indices(m_file, m_model, primitive.indices, TINYGLTF_TYPE_SCALAR);
      for (std::size_t i = 0; i < indices.size(); ++i) {
        const double index = indices(i);
        if (!(index >= 0 && index < double(positions.size())))
          throw Input_error(m_file, "an index of a vertex that does not exist");
        corners.push_back(first + std::size_t(index));
      }
    }
    if (m_soup.points.size() + m_soup.polygons.corners().size() + corners.size() > m_most_numbers)
      throw Input_error(m_file, "its meshes are repeated too often");
    add_triangles(corners, primitive.mode, to_world.linear().determinant() < 0);
  }

  /// \param is_mirrored corners then run the other way round
  void add_triangles(const std::vector<std::size_t>& corners, int mode, bool is_mirrored)
  {
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                                 mode == TINYGLTF_MODE_TRIANGLE_FAN
                               ? 1
                               : 3;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      const std::size_t a = corners[mode == TINYGLTF_MODE_TRIANGLE_FAN ? 0 : i];
      std::size_t b = corners[i + 1], c = corners[i + 2];
      if (step == 1 && (a == b || b == c || c == a))
        continue; // leads from one strip to the next
      if (is_mirrored != (mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1))
        std::swap(b, c);
      m_soup.polygons.push_back({a, b, c});
    }
  }

  /// Many nodes may show one mesh, as of a screw; what is repeated more often was made to exhaust
  /// the memory.
  static constexpr std::size_t most_numbers_per_byte = 10;

  const std::string& m_file;
  const tinygltf::Model m_model;
  std::size_t m_most_numbers = 1000000; // of points and corners
  Polygon_soup m_soup;
  std::size_t m_number_of_skipped = 0;
};

} // namespace

Polygon_soup read_gltf(const std::string& file, std::string_view bytes, Remarks& remarks)
{
  return Gltf_reader(file, bytes).read(remarks);
}

} // namespace segment_mesh
