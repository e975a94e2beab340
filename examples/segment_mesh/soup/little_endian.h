// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LITTLE_ENDIAN_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LITTLE_ENDIAN_H

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace segment_mesh {

/// \name Numbers as bytes, whatever the order of bytes of the machine
/// @{
/// A number that stands there, little endian unless `Order` is another one.
template <typename T, boost::endian::order Order = boost::endian::order::little>
T read_bytes(const char* bytes)
{
  return boost::endian::endian_load<T, sizeof(T), Order>(
    reinterpret_cast<const unsigned char*>(bytes));
}

/// The types of numbers in PLY and glTF files, in the order of glTF's codes.
enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

/// Calls `f` with a value of the type.
template <typename Function>
decltype(auto) with_type(Number_type type, Function f)
{
  switch (type) {
  case Number_type::INT8:
    return f(std::int8_t());
  case Number_type::UINT8:
    return f(std::uint8_t());
  case Number_type::INT16:
    return f(std::int16_t());
  case Number_type::UINT16:
    return f(std::uint16_t());
  case Number_type::INT32:
    return f(std::int32_t());
  case Number_type::UINT32:
    return f(std::uint32_t());
  case Number_type::FLOAT32:
    return f(float());
  default:
    return f(double());
  }
}

inline std::size_t size_of(Number_type type)
{
  return with_type(type, [](auto value) { return sizeof value; });
}

inline bool is_floating_point(Number_type type)
{
  return type >= Number_type::FLOAT32;
}

template <typename T>
void append_little_endian(std::string& bytes, T value)
{
  unsigned char buffer[sizeof(T)];
  boost::endian::endian_store<T, sizeof(T), boost::endian::order::little>(buffer, value);
  bytes.append(buffer, buffer + sizeof(T));
}
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LITTLE_ENDIAN_H
