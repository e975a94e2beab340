// SPDX-License-Identifier: GPL-3.0-or-later

// A model as XML, and two files that say so, in a ZIP archive. Source: "3D Manufacturing Format,
// Core Specification", https://3mf.io/specification. lib3mf 1, which Debian has, cuts coordinates
// off after six decimals.

#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <zip.h>

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

std::string zip_archive(const std::vector<Entry>& entries)
{
  zip_error_t error;
  zip_source_t* memory = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_t* zip = memory ? zip_open_from_source(memory, ZIP_TRUNCATE, &error) : nullptr;
  if (!zip)
    throw std::runtime_error("a ZIP archive cannot be made");
  zip_source_keep(memory); // after the end of the archive, too
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> keeper(memory, zip_source_free);
  constexpr zip_uint16_t first_date = 0x21; // in 1980, so that equal meshes give equal files
  bool is_done = true;
  for (const auto& [name, content] : entries) {
    zip_source_t* source = zip_source_buffer(zip, content.data(), content.size(), 0);
    const zip_int64_t index = zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    is_done = is_done && index >= 0 &&
              zip_file_set_dostime(zip, zip_uint64_t(index), 0, first_date, 0) == 0;
  }
  if (!is_done || zip_close(zip) != 0) {
    zip_discard(zip);
    throw std::runtime_error("a ZIP archive cannot be made");
  }
  std::string result;
  zip_stat_t size;
  if (zip_source_stat(memory, &size) == 0 && zip_source_open(memory) == 0) {
    result.resize(size.size);
    result.resize(std::size_t(zip_source_read(memory, result.data(), size.size)));
    zip_source_close(memory);
  }
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
