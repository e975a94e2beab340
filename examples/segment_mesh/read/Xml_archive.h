// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_XML_ARCHIVE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_XML_ARCHIVE_H

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace segment_mesh {

/// The start of an element, and the end of the one of this name that has no end yet. Views are
/// valid during the call.
class Xml_element
{
public:
  /// `name`: the namespace, a blank and the name, or a name alone. `attributes`: such names and
  /// values in turn, and a null pointer; null at the end of an element
  Xml_element(std::string_view name, const char* const* attributes)
    : m_name(name)
    , m_attributes(attributes)
  {}

  bool is_start() const { return m_attributes != nullptr; }
  std::string_view name() const { return without_namespace(m_name); }
  std::string_view name_space() const
  {
    return m_name.substr(0, m_name.size() - (std::min)(m_name.size(), name().size() + 1));
  }

  /// The attribute of this name in any namespace, if there is one.
  std::optional<std::string_view> find(std::string_view name) const;
  /// \throws Value_error if there is none
  std::string_view at(std::string_view name) const;

private:
  static std::string_view without_namespace(std::string_view name)
  {
    return name.substr(name.rfind(' ') + 1);
  }

  std::string_view m_name;
  const char* const* m_attributes;
};

/// Files of XML in a ZIP archive, by minizip and expat.
class Xml_archive
{
public:
  /// The bytes must live as long as the archive. \throws Input_error if they are none
  Xml_archive(const std::string& file, std::string_view bytes);

  bool has(const std::string& entry) const;

  /// Calls `take` with each start and end of an element. Where `take` throws `Value_error`, this
  /// throws `Input_error` with entry and line, as for what is no XML. Refuses documents that
  /// declare entities, and archives that grow by more than `largest_inflation`.
  void read(const std::string& entry, const std::function<void(const Xml_element&)>& take);

private:
  struct Close
  {
    void operator()(void* archive) const;
  };

  /// The file of this name, whole, since minizip has one file open at a time.
  std::string inflated(const std::string& entry);

  std::string m_file;
  std::unique_ptr<void, Close> m_zip;              // of minizip
  std::size_t m_most_bytes, m_number_of_bytes = 0; // of what is read
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_XML_ARCHIVE_H
