// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LITTLE_ENDIAN_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LITTLE_ENDIAN_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace segment_mesh {

/// \name Numbers as bytes, whatever the order of bytes of the machine
/// @{
inline bool is_little_endian_machine()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

template <typename T>
T read_bytes(const char* bytes, bool is_little_endian)
{
  char buffer[sizeof(T)];
  std::copy_n(bytes, sizeof(T), buffer);
  if (is_little_endian != is_little_endian_machine())
    std::reverse(buffer, buffer + sizeof(T));
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return value;
}

template <typename T>
T read_little_endian(const char* bytes)
{
  return read_bytes<T>(bytes, true);
}

template <typename T>
void append_little_endian(std::string& bytes, T value)
{
  char buffer[sizeof(T)];
  std::memcpy(buffer, &value, sizeof(T));
  if (!is_little_endian_machine())
    std::reverse(buffer, buffer + sizeof(T));
  bytes.append(buffer, sizeof(T));
}
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LITTLE_ENDIAN_H
