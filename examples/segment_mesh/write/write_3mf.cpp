// SPDX-License-Identifier: GPL-3.0-or-later

// A model as XML, and two files that say so, in a ZIP archive. Source: "3D Manufacturing Format,
// Core Specification", https://3mf.io/specification. lib3mf 1, which Debian has, cuts coordinates
// off after six decimals.

#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <archive.h>
#include <archive_entry.h>

#include <memory>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

/// A file of a ZIP archive: its name and its content.
using Entry = std::pair<std::string, std::string>;

/// Appends to the `std::string` that `text` points to.
la_ssize_t append(archive*, void* text, const void* bytes, std::size_t size)
{
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), size);
  return la_ssize_t(size);
}

std::string zip_archive(const std::vector<Entry>& entries)
{
  std::string result;
  const std::unique_ptr<archive, int (*)(archive*)> zip(archive_write_new(), archive_write_free);
  const auto check = [&zip](long code) {
    if (code < 0)
      throw std::runtime_error(archive_error_string(zip.get()));
  };
  check(archive_write_set_format_zip(zip.get()));
  check(archive_write_open(zip.get(), &result, nullptr, append, nullptr));
  for (const auto& [name, content] : entries) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                         archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), 0, 0); // equal inputs give equal files
    archive_entry_set_size(entry.get(), la_int64_t(content.size()));
    check(archive_write_header(zip.get(), entry.get()));
    check(archive_write_data(zip.get(), content.data(), content.size()));
  }
  check(archive_write_close(zip.get()));
  return result;
}

std::string hexadecimal(const Color& color)
{
  std::string result = "#";
  for (std::uint8_t channel : color)
    for (int digit : {channel / 16, channel % 16})
      result += "0123456789ABCDEF"[digit];
  return result;
}

/// An object with its material for each segment, and an item that shows it.
void write_model(std::ostream& out, const std::vector<Segment_triangles>& segments)
{
  constexpr std::size_t first_id = 2; // 1 is that of the materials
  Text_buffer text(out);
  text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<model unit=\"millimeter\" xml:lang=\"en-US\" "
          "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
          "<resources>\n<basematerials id=\"1\">\n";
  for (const Segment_triangles& segment : segments)
    text << "<base name=\"" << segment.name << "\" displaycolor=\"" << hexadecimal(segment.color)
         << "\"/>\n";
  text << "</basematerials>\n";
  for (std::size_t i = 0; i < segments.size(); ++i) {
    text << "<object id=\"" << first_id + i << "\" name=\"" << segments[i].name
         << "\" type=\"model\" pid=\"1\" pindex=\"" << i << "\">\n<mesh>\n<vertices>\n";
    for (const Point& p : segments[i].points)
      text << "<vertex x=\"" << p[0] << "\" y=\"" << p[1] << "\" z=\"" << p[2] << "\"/>\n";
    text << "</vertices>\n<triangles>\n";
    for (const auto& t : segments[i].triangles)
      text << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"/>\n";
    text << "</triangles>\n</mesh>\n</object>\n";
  }
  text << "</resources>\n<build>\n";
  for (std::size_t i = 0; i < segments.size(); ++i)
    text << "<item objectid=\"" << first_id + i << "\"/>\n";
  text << "</build>\n</model>\n";
}

} // namespace

void write_3mf(std::ostream& out, const Labelled_mesh& mesh)
{
  const std::string start = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n",
                    package = "http://schemas.openxmlformats.org/package/2006/",
                    model = "3D/3dmodel.model";
  std::ostringstream text;
  write_model(text, triangles_of_segments(mesh));
  out << zip_archive(
    {{"[Content_Types].xml",
      start + "<Types xmlns=\"" + package +
        "content-types\"><Default Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n"},
     {"_rels/.rels", start + "<Relationships xmlns=\"" + package +
                       "relationships\"><Relationship Id=\"model\" Target=\"/" + model +
                       "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
                       "</Relationships>\n"},
     {model, text.str()}});
}

} // namespace segment_mesh
