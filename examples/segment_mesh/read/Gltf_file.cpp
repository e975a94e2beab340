// SPDX-License-Identifier: GPL-3.0-or-later

// Source: "glTF 2.0 Specification", The Khronos Group, 2021

#include "read/Gltf_file.h"

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "soup/little_endian.h"

#ifdef SEGMENT_MESH_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

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

#ifdef SEGMENT_MESH_HAS_MESHOPTIMIZER
constexpr const char* compression = "EXT_meshopt_compression";

/// Decodes `count` elements of `stride` bytes each. Filters of normals and of animations stay:
/// these are not read. \returns whether the bytes are as the extension says
bool decompress(const Gltf_file::Json& compressed, std::string_view bytes, std::size_t count,
                std::size_t stride, char* result)
{
  const std::string mode = compressed.at("mode");
  const auto by = [&](const auto& decode) {
    return decode(result, count, stride, reinterpret_cast<const unsigned char*>(bytes.data()),
                  bytes.size()) == 0;
  };
  if (mode == "ATTRIBUTES") {
    if (stride % 4 != 0 || stride > 256 || !by(meshopt_decodeVertexBuffer))
      return false;
    if (compressed.value("filter", "NONE") == "EXPONENTIAL")
      meshopt_decodeFilterExp(result, count, stride);
    return true;
  }
  using Decode = int (*)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
  return (stride == 2 || stride == 4) &&
         ((mode == "TRIANGLES" && count % 3 == 0 && by(Decode(meshopt_decodeIndexBuffer))) ||
          (mode == "INDICES" && by(Decode(meshopt_decodeIndexSequence))));
}
#else
constexpr const char* compression = "none that is read";

bool decompress(const Gltf_file::Json&, std::string_view, std::size_t, std::size_t, char*)
{
  return false;
}
#endif

/// Whether an extension is read, or changes no triangle, or only lets positions be integers.
bool is_harmless(const std::string& extension)
{
  return is_of_gltf_materials(extension) || extension == "KHR_mesh_quantization" ||
         extension == compression || extension.rfind("KHR_lights_", 0) == 0;
}

bool is_compression(const std::string& extension)
{
  return extension.find("compression") != std::string::npos;
}

} // namespace

bool is_of_gltf_materials(const std::string& extension)
{
  const char* const starts[] = {"KHR_materials_", "KHR_texture_", "EXT_texture_"};
  return std::any_of(std::begin(starts), std::end(starts),
                     [&](const char* start) { return extension.rfind(start, 0) == 0; });
}

std::string gltf_extension_not_read(const std::string& extension)
{
  return "the extension " + in_quotes(extension) + ", which is not read" +
         (is_compression(extension) ? ": save it without compression" : "");
}

bool are_below(const std::vector<double>& indices, std::size_t size)
{
  return std::all_of(indices.begin(), indices.end(),
                     [size](double index) { return index >= 0 && index < double(size); });
}

Gltf_file::Gltf_file(const std::string& file, std::string_view bytes)
  : m_file(file)
  , m_most_numbers(1000000 + most_numbers_per_byte * bytes.size())
  , m_text(bytes)
{
  if (bytes.substr(0, 4) == "glTF")
    split(bytes);
  check_encoding(file, m_text);
}

void Gltf_file::open()
{
  parse();
  read_header();
}

/// Its messages would quote the text.
void Gltf_file::parse()
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

void Gltf_file::fail(const std::string& cause) const
{
  throw Input_error(m_file, m_place + cause);
}

/// Finds the text and the first buffer of a .glb file.
void Gltf_file::split(std::string_view bytes)
{
  const auto number = [bytes](std::size_t at) {
    return std::size_t(read_bytes<std::uint32_t>(&bytes[at]));
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

const Gltf_file::Json& Gltf_file::element(const char* list, std::size_t i)
{
  m_place = std::string(list) + "[" + std::to_string(i) + "]: ";
  return m_json.at(list).at(i);
}

std::size_t Gltf_file::index(const Json& value, const char* name) const
{
  if (!value.is_number_unsigned())
    fail(std::string(name) + " is not an integer of at least 0");
  return value.get<std::size_t>();
}

std::size_t Gltf_file::member(const Json& object, const char* name) const
{
  return index(object.at(name), name);
}

std::size_t Gltf_file::member(const Json& object, const char* name, std::size_t otherwise) const
{
  return object.contains(name) ? member(object, name) : otherwise;
}

Gltf_file::Json Gltf_file::list(const Json& object, const char* name)
{
  return object.value(name, Json::array());
}

void Gltf_file::read_header()
{
  const Json& asset = m_json.at("asset");
  const std::string version = asset.at("version"), least = asset.value("minVersion", "2.0");
  if (version.rfind("2.", 0) != 0)
    fail("is of glTF version " + in_quotes(version) + "; version 2 is read");
  if (least != "2.0")
    fail("needs glTF version " + in_quotes(least) + "; version 2.0 is read");
  for (const Json& extension : list(m_json, "extensionsRequired"))
    if (!is_harmless(extension))
      fail("needs " + gltf_extension_not_read(extension));
  for (const Json& extension : list(m_json, "extensionsUsed"))
    if (is_compression(extension) && !is_harmless(extension))
      m_hint = ": the file uses " + gltf_extension_not_read(extension);
  for (std::size_t i = 0; m_json.contains("buffers") && i < m_json["buffers"].size(); ++i) {
    const Json& buffer = element("buffers", i);
    const std::size_t size = member(buffer, "byteLength");
    const bool has_uri = buffer.contains("uri");
    m_buffers.push_back(has_uri ? load(buffer["uri"], size) : std::string(i == 0 ? m_binary : ""));
    m_most_numbers += most_numbers_per_byte * m_buffers[i].size();
    if ((has_uri || !m_buffers[i].empty()) && m_buffers[i].size() < size)
      fail("has " + std::to_string(m_buffers[i].size()) + " of " + counted(size, "byte"));
  }
  decompress_views();
}

/// The bytes of a buffer that are in its URI, or the first ones of a file of the folder of the
/// file or below it.
std::string Gltf_file::load(const std::string& uri, std::size_t size) const
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

/// Replaces each buffer view that is compressed by one of a buffer of its own.
void Gltf_file::decompress_views()
{
  for (std::size_t i = 0; m_json.contains("bufferViews") && i < m_json["bufferViews"].size(); ++i) {
    const Json extensions = element("bufferViews", i).value("extensions", Json());
    if (!extensions.contains(compression))
      continue;
    const Json& compressed = extensions[compression];
    const std::size_t count = member(compressed, "count"),
                      stride = member(compressed, "byteStride");
    if (stride == 0 || count > m_most_numbers / stride)
      fail("more data than a file of this size holds");
    std::string bytes(count * stride, '\0');
    if (!decompress(compressed, bytes_of(compressed), count, stride, bytes.data()))
      fail("data that are not as in " + in_quotes(compression));
    Json& view = m_json["bufferViews"][i];
    view["buffer"] = m_buffers.size();
    view["byteOffset"] = std::size_t(0);
    view["byteLength"] = bytes.size();
    m_buffers.push_back(std::move(bytes));
  }
}

/// The bytes of a buffer view.
std::string_view Gltf_file::bytes_of(const Json& view) const
{
  const std::size_t buffer = member(view, "buffer"), start = member(view, "byteOffset", 0),
                    length = member(view, "byteLength");
  if (buffer >= m_buffers.size() || m_buffers[buffer].empty())
    fail("has no data" + m_hint);
  if (start > m_buffers[buffer].size() || length > m_buffers[buffer].size() - start)
    fail("is in a part of a buffer that goes beyond its end");
  return std::string_view(m_buffers[buffer]).substr(start, length);
}

std::vector<double> Gltf_file::values(const Json& accessor_index, const char* type,
                                      std::size_t size)
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
std::vector<double> Gltf_file::stored(const Json& place, const Json& format, std::size_t count,
                                      std::size_t components) const
{
  constexpr std::size_t first_type = 5120;
  const std::size_t code = member(format, "componentType");
  if (code < first_type || code > first_type + std::size_t(Number_type::FLOAT32))
    fail("an unknown type of numbers");
  const Number_type type = Number_type(code - first_type);
  const bool is_normalized = format.value("normalized", false);

  const Json& view = m_json.at("bufferViews").at(member(place, "bufferView"));
  const std::size_t size = components * size_of(type), offset = member(place, "byteOffset", 0),
                    stride = member(view, "byteStride", size);
  if (stride < size)
    fail("elements that overlap: a byteStride of " + counted(stride, "byte"));
  const std::string_view bytes = bytes_of(view);
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
        const double number = read_bytes<Number>(&bytes[offset + i * stride + j * sizeof(Number)]);
        result.push_back(is_normalized ? (std::max)(number / unit, -1.0) : number);
      }
  });
  return result;
}

} // namespace segment_mesh
