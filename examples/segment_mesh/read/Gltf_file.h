// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_GLTF_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_GLTF_FILE_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace segment_mesh {

/// Whether an extension of glTF is of materials and their textures alone.
bool is_of_gltf_materials(const std::string& extension);

/// "the extension 'NAME', which is not read", and what to do about it.
std::string gltf_extension_not_read(const std::string& extension);

/// Whether the numbers are indices of some of `size` elements.
bool are_below(const std::vector<double>& indices, std::size_t size);

/// The JSON of a glTF file with its buffers, and the numbers that are in them.
class Gltf_file
{
public:
  using Json = nlohmann::json;

  /// `bytes`: of the file, text or binary, as long as this lives
  Gltf_file(const std::string& file, std::string_view bytes);

  /// Reads text and buffers. \throws Input_error and `Json::exception`
  void open();

  const std::string& name() const { return m_file; }
  const Json& json() const { return m_json; }
  const std::vector<std::string>& buffers() const { return m_buffers; }

  /// \throws Input_error with what was read last
  [[noreturn]] void fail(const std::string& cause) const;

  /// An element of a list of the file, which messages name from now on; or nothing of it.
  const Json& element(const char* list, std::size_t i);
  void leave_element() { m_place.clear(); }

  std::size_t index(const Json& value, const char* name) const;
  /// A member of an object.
  std::size_t member(const Json& object, const char* name) const;
  std::size_t member(const Json& object, const char* name, std::size_t otherwise) const;
  /// A member that is a list; an empty one where it is missing.
  static Json list(const Json& object, const char* name);

  /// The numbers of an accessor, `size` of them for each element.
  std::vector<double> values(const Json& accessor_index, const char* type, std::size_t size);

private:
  void split(std::string_view bytes);
  void parse();
  void read_header();
  void decompress_views();
  std::string load(const std::string& uri, std::size_t size) const;
  std::string_view bytes_of(const Json& view) const;
  std::vector<double> stored(const Json& place, const Json& format, std::size_t count,
                             std::size_t components) const;

  /// Many nodes may show one mesh, as of a screw; what is repeated more often was made to exhaust
  /// the memory.
  static constexpr std::size_t most_numbers_per_byte = 30;

  const std::string& m_file;
  std::size_t m_most_numbers, m_number_of_numbers = 0; // of coordinates and indices
  std::string_view m_text, m_binary;
  Json m_json;
  std::string m_place; // in messages: what is read, with a colon
  std::string m_hint;  // on data that are not there
  std::vector<std::string> m_buffers;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_GLTF_FILE_H
