// SPDX-License-Identifier: GPL-3.0-or-later

// A model as XML, and two files that say so, in a ZIP archive. Source: "3D Manufacturing Format,
// Core Specification", https://3mf.io/specification. lib3mf 1, which Debian has, cuts coordinates
// off after six decimals.

#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>

#include <boost/algorithm/hex.hpp>

#include <minizip/zip.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

/// A file of a ZIP archive: its name and its content.
using Entry = std::pair<std::string, std::string>;

/// What `open_memstream()` has written.
struct Memory
{
  char* data = nullptr;
  std::size_t size = 0;

  ~Memory() { std::free(data); }
};

voidpf open_memory(voidpf memory, const void*, int)
{
  return open_memstream(&static_cast<Memory*>(memory)->data, &static_cast<Memory*>(memory)->size);
}

std::string zip_archive(const std::vector<Entry>& entries)
{
  Memory memory;
  zlib_filefunc64_def functions;
  fill_fopen64_filefunc(&functions);
  functions.zopen64_file = open_memory;
  functions.opaque = &memory;
  const zipFile zip = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
  zip_fileinfo info{};
  info.dosDate = 0x21 << 16; // in 1980, so that equal meshes give equal files
  constexpr int level = 6;   // that of gzip; 9 takes twice the time for some percent
  bool is_done = zip != nullptr;
  for (const auto& [name, content] : entries) {
    const int is_large = content.size() >= 0xffffffff;
    is_done = is_done && zipOpenNewFileInZip64(zip, name.c_str(), &info, nullptr, 0, nullptr, 0,
                                               nullptr, Z_DEFLATED, level, is_large) == ZIP_OK;
    constexpr std::size_t most = 1 << 30; // the size of a part is an unsigned int
    for (std::size_t i = 0; is_done && i < content.size(); i += most)
      is_done = zipWriteInFileInZip(zip, content.data() + i,
                                    unsigned((std::min)(most, content.size() - i))) == ZIP_OK;
    is_done = is_done && zipCloseFileInZip(zip) == ZIP_OK;
  }
  if (!zip || zipClose(zip, nullptr) != ZIP_OK || !is_done)
    throw std::runtime_error("a ZIP archive cannot be made");
  return {memory.data, memory.size};
}

constexpr const char* xml_start = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr const char*
  model_start = "<model unit=\"millimeter\" xml:lang=\"en-US\" "
                "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";

/// `attribute(t)` is that of triangle t, after those of the format.
template <typename Attribute>
void write_triangles(Text_buffer& text, const std::vector<Point>& points,
                     const Triangles& triangles, const Attribute& attribute)
{
  text << "<mesh>\n<vertices>\n";
  for (const Point& p : points)
    text << "<vertex x=\"" << p[0] << "\" y=\"" << p[1] << "\" z=\"" << p[2] << "\"/>\n";
  text << "</vertices>\n<triangles>\n";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    text << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\""
         << attribute(i) << "/>\n";
  }
  text << "</triangles>\n</mesh>\n";
}

/// An object with its material for each segment, and an item that shows it.
void write_model(std::ostream& out, const std::vector<Segment_triangles>& segments)
{
  constexpr std::size_t first_id = 2; // 1 is that of the materials
  Text_buffer text(out);
  text << xml_start << model_start << ">\n<resources>\n<basematerials id=\"1\">\n";
  for (const Segment_triangles& segment : segments)
    text << "<base name=\"" << segment.name << "\" displaycolor=\""
         << "#" << boost::algorithm::hex(std::string(segment.color.begin(), segment.color.end()))
         << "\"/>\n";
  text << "</basematerials>\n";
  for (std::size_t i = 0; i < segments.size(); ++i) {
    text << "<object id=\"" << first_id + i << "\" name=\"" << segments[i].name
         << "\" type=\"model\" pid=\"1\" pindex=\"" << i << "\">\n";
    write_triangles(text, segments[i].part.soup.points, segments[i].triangles,
                    [](std::size_t) { return ""; });
    text << "</object>\n";
  }
  text << "</resources>\n<build>\n";
  for (std::size_t i = 0; i < segments.size(); ++i)
    text << "<item objectid=\"" << first_id + i << "\"/>\n";
  text << "</build>\n</model>\n";
}

/// The code of PrusaSlicer, which Bambu Studio and OrcaSlicer read as `paint_color`, for a triangle
/// that is not divided: the bits 00, then two bits with the number of the extruder, from 1, or,
/// from 3 on, 11 and four bits with the number less 3. The hexadecimal digits of four bits each
/// come from the last to the first.
std::string paint_of_extruder(std::size_t extruder)
{
  constexpr const char* digits = "0123456789ABCDEF";
  if (extruder < 3)
    return {digits[4 * extruder]};
  return {digits[extruder - 3], 'C'};
}

void write_painted_model(std::ostream& out, const Labelled_mesh& mesh)
{
  constexpr std::size_t number_of_extruders = 15; // the most that the slicer knows
  const auto [triangles, face_of_triangle] = triangulate_faces(mesh.soup);
  Text_buffer text(out);
  text << xml_start << model_start
       << " xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\">\n"
          "<metadata name=\"slic3rpe:Version3mf\">1</metadata>\n"
          "<metadata name=\"slic3rpe:MmPaintingVersion\">1</metadata>\n"
          "<resources>\n<object id=\"1\" type=\"model\">\n";
  write_triangles(text, mesh.soup.points, triangles, [&, &faces = face_of_triangle](std::size_t t) {
    const std::size_t segment = mesh.segment_of_face[faces[t]];
    if (segment == RS::no_segment)
      return std::string();
    const std::string paint = paint_of_extruder(1 + segment % number_of_extruders);
    return " slic3rpe:mmu_segmentation=\"" + paint + "\" paint_color=\"" + paint + "\"";
  });
  text << "</object>\n</resources>\n<build>\n<item objectid=\"1\"/>\n</build>\n</model>\n";
}

void write_package(std::ostream& out, const std::string& model)
{
  const std::string start = xml_start, package = "http://schemas.openxmlformats.org/package/2006/",
                    name = "3D/3dmodel.model";
  out << zip_archive(
    {{"[Content_Types].xml",
      start + "<Types xmlns=\"" + package +
        "content-types\"><Default Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n"},
     {"_rels/.rels", start + "<Relationships xmlns=\"" + package +
                       "relationships\"><Relationship Id=\"model\" Target=\"/" + name +
                       "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
                       "</Relationships>\n"},
     {name, model}});
}

} // namespace

void write_3mf(std::ostream& out, const Labelled_mesh& mesh)
{
  std::ostringstream model;
  write_model(model, triangles_of_segments(mesh));
  write_package(out, model.str());
}

void write_painted_3mf(std::ostream& out, const Labelled_mesh& mesh)
{
  std::ostringstream model;
  write_painted_model(model, mesh);
  write_package(out, model.str());
}

} // namespace segment_mesh
