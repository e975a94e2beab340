// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_FUZZ_SAMPLE_FILES_H
#define CGAL_REGION_SEGMENTATION_TEST_FUZZ_SAMPLE_FILES_H

#include "soup/little_endian.h"

#include <boost/crc.hpp>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>

// A tetrahedron in every format, as its file may stand on a disk. Points 0 (0,0,0), 1 (1,0,0),
// 2 (0,1,0), 3 (0,0,1); faces 0 2 1, 0 1 3, 1 2 3, 0 3 2.

namespace sample {

constexpr double points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

inline std::string off()
{
  return "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
}

inline std::string obj()
{
  return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
}

inline std::string ply_header(const std::string& format)
{
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ply()
{
  return ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
}

template <typename T>
void append(std::string& bytes, T value, const std::string& format)
{
  const std::size_t start = bytes.size();
  segment_mesh::append_little_endian(bytes, value);
  if (format == "binary_big_endian")
    std::reverse(bytes.begin() + std::ptrdiff_t(start), bytes.end());
}

inline std::string binary_ply(const std::string& format)
{
  std::string bytes = ply_header(format);
  for (const auto& p : points)
    for (double x : p)
      append(bytes, float(x), format);
  for (const auto& f : faces) {
    bytes += '\3';
    for (std::int32_t i : f)
      append(bytes, i, format);
  }
  return bytes;
}

inline std::string stl()
{
  std::string text = "solid tetrahedron\n";
  for (const auto& f : faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (std::int32_t i : f) {
      text += "vertex";
      for (double x : points[i])
        text += " " + std::to_string(x);
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

inline std::string binary_stl(std::string header = "binary")
{
  header.resize(80, ' ');
  segment_mesh::append_little_endian(header, std::uint32_t(4));
  for (const auto& f : faces) {
    header.append(12, '\0');
    for (std::int32_t i : f)
      for (double x : points[i])
        segment_mesh::append_little_endian(header, float(x));
    header.append(2, '\0');
  }
  return header;
}

/// Points as floats, then indices as unsigned short.
inline std::string gltf_buffer()
{
  std::string bytes;
  for (const auto& p : points)
    for (double x : p)
      segment_mesh::append_little_endian(bytes, float(x));
  for (const auto& f : faces)
    for (std::int32_t i : f)
      segment_mesh::append_little_endian(bytes, std::uint16_t(i));
  return bytes;
}

/// \param source of the buffer: a member of the JSON, with a comma
inline std::string gltf_json(const std::string& source)
{
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"mode":4}]}],)"
         R"("buffers":[{)" +
         source +
         R"("byteLength":72}],)"
         R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},)"
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
}

/// With `gltf_buffer()` as text.
inline std::string gltf()
{
  return gltf_json(
    R"("uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAACAAEAAAABAAMAAQACAAMAAAADAAIA",)");
}

/// \param json in place of `gltf_json("")`
inline std::string glb(std::string json = gltf_json(""), const std::string& buffer = gltf_buffer())
{
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string bytes = "glTF";
  for (std::size_t number : {std::size_t(2), 12 + 8 + json.size() + 8 + buffer.size(), json.size()})
    segment_mesh::append_little_endian(bytes, std::uint32_t(number));
  bytes += "JSON" + json;
  segment_mesh::append_little_endian(bytes, std::uint32_t(buffer.size()));
  return bytes + std::string("BIN\0", 4) + buffer;
}

/// An archive of one file without compression.
inline std::string zip(const std::string& name, const std::string& content)
{
  const auto little_endian = [](std::initializer_list<std::uint32_t> numbers) {
    std::string bytes;
    for (const std::uint32_t number : numbers)
      segment_mesh::append_little_endian(bytes, number);
    return bytes;
  };
  const std::uint32_t size = std::uint32_t(content.size()), length = std::uint32_t(name.size());
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  // Version, flags, method, time, date; then sum, sizes, the length of the name, and none of more.
  std::string common("\x14\0\0\0\0\0\0\0\x21\0", 10);
  common += little_endian({crc.checksum(), size, size, length});
  const std::string entry = "PK\3\4" + common + name + content;
  const std::string directory = std::string("PK\1\2\x14\0", 6) + common + std::string(14, '\0') +
                                name;
  return entry + directory + std::string("PK\5\6\0\0\0\0\1\0\1\0", 12) +
         little_endian({std::uint32_t(directory.size()), std::uint32_t(entry.size())}) +
         std::string(2, '\0');
}

/// The text with the first `from` in it replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

} // namespace sample

#endif // CGAL_REGION_SEGMENTATION_TEST_FUZZ_SAMPLE_FILES_H
