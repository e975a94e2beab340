// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "glTF 2.0 Specification", The Khronos Group, 2021

#include "read/little_endian.h"
#include "read/tinygltf.h"
#include "soup/vector_algebra.h"
#include "write/write_mesh.h"

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

class Glb_model
{
public:
  Glb_model()
  {
    m_model.asset.version = "2.0";
    m_model.asset.generator = "segment_mesh";
    m_model.buffers.emplace_back();
    m_model.scenes.emplace_back();
    m_model.defaultScene = 0;
  }

  void add(const Segment_triangles& segment)
  {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    const Shaded_triangles shaded = shade(segment);
    primitive.attributes["POSITION"] = add_vectors(shaded.points);
    primitive.attributes["NORMAL"] = add_vectors(shaded.normals);
    primitive.indices = add_indices(shaded.triangles);
    primitive.material = add_material(segment);
    tinygltf::Mesh mesh;
    mesh.name = segment.name;
    mesh.primitives.push_back(primitive);
    tinygltf::Node node;
    node.name = segment.name;
    node.mesh = int(m_model.meshes.size());
    m_model.meshes.push_back(mesh);
    m_model.scenes[0].nodes.push_back(int(m_model.nodes.size()));
    m_model.nodes.push_back(node);
  }

  void write(std::ostream& out)
  {
    m_model.buffers[0].data.assign(m_bytes.begin(), m_bytes.end());
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&m_model, out, false, true);
  }

private:
  int add_vectors(const std::vector<Point>& vectors)
  {
    tinygltf::Accessor accessor;
    accessor.minValues.assign(3, HUGE_VAL);
    accessor.maxValues.assign(3, -HUGE_VAL);
    const std::size_t start = m_bytes.size();
    for (const Point& p : vectors)
      for (std::size_t j = 0; j < 3; ++j) {
        const float x = float(p[j]);
        append_little_endian(m_bytes, x);
        accessor.minValues[j] = (std::min)(accessor.minValues[j], double(x));
        accessor.maxValues[j] = (std::max)(accessor.maxValues[j], double(x));
      }
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.count = vectors.size();
    return add_accessor(accessor, start, TINYGLTF_TARGET_ARRAY_BUFFER);
  }

  int add_indices(const Triangles& triangles)
  {
    const std::size_t start = m_bytes.size();
    for (const auto& triangle : triangles)
      for (std::uint32_t i : triangle)
        append_little_endian(m_bytes, i);
    tinygltf::Accessor accessor;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = 3 * triangles.size();
    return add_accessor(accessor, start, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }

  /// Of the bytes from `start` on.
  int add_accessor(tinygltf::Accessor& accessor, std::size_t start, int target)
  {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = start;
    view.byteLength = m_bytes.size() - start;
    view.target = target;
    accessor.bufferView = int(m_model.bufferViews.size());
    m_model.bufferViews.push_back(view);
    m_model.accessors.push_back(accessor);
    return int(m_model.accessors.size()) - 1;
  }

  int add_material(const Segment_triangles& segment)
  {
    tinygltf::Material material;
    material.name = segment.name;
    material.doubleSided = true;
    auto& pbr = material.pbrMetallicRoughness;
    for (std::size_t j = 0; j < 3; ++j)
      pbr.baseColorFactor[j] = linear_channel(segment.color[j]);
    pbr.metallicFactor = 0;
    pbr.roughnessFactor = 0.8;
    m_model.materials.push_back(material);
    return int(m_model.materials.size()) - 1;
  }

  tinygltf::Model m_model;
  std::string m_bytes;
};

} // namespace

bool can_write_glb()
{
  return true;
}

void write_glb(std::ostream& out, const Labelled_mesh& mesh)
{
  Glb_model model;
  for (const Segment_triangles& segment : triangles_of_segments(mesh))
    model.add(segment);
  model.write(out);
}

} // namespace segment_mesh
