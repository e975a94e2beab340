// SPDX-License-Identifier: GPL-3.0-or-later

// A model as XML, and two files that say so, in a ZIP archive. Sources: "3D Manufacturing Format,
// Core Specification", https://3mf.io/specification; "APPNOTE.TXT, .ZIP File Format Specification",
// PKWARE. lib3mf 1, which Debian has, cuts coordinates off after six decimals.

#include "read/little_endian.h"
#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <boost/crc.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace segment_mesh {

namespace {

class Zip_archive
{
public:
  void add(const std::string& name, const std::string& content)
  {
    boost::crc_32_type crc;
    crc.process_bytes(content.data(), content.size());
    const std::string data = deflated(content);
    std::string header; // what a file has before it, and once more in the directory
    for (const unsigned value :
         {20u /* version 2.0 */, 0u, 8u /* deflated */, 0u, 0x21u /* 1980 */})
      append_little_endian(header, std::uint16_t(value));
    append_little_endian(header, std::uint32_t(crc.checksum()));
    append_size(header, data.size());
    append_size(header, content.size());
    append_little_endian(header, std::uint16_t(name.size()));
    append_little_endian(header, std::uint16_t(0));

    m_directory += "PK\1\2";
    append_little_endian(m_directory, std::uint16_t(20));
    m_directory += header + std::string(10, '\0');
    append_size(m_directory, m_files.size());
    m_directory += name;
    m_files += "PK\3\4" + header + name + data;
    ++m_number_of_files;
  }

  void write(std::ostream& out) const
  {
    std::string end = "PK\5\6" + std::string(4, '\0');
    append_little_endian(end, m_number_of_files);
    append_little_endian(end, m_number_of_files);
    append_size(end, m_directory.size());
    append_size(end, m_files.size());
    out << m_files << m_directory << end << std::string(2, '\0');
  }

private:
  static std::string deflated(const std::string& content)
  {
    boost::iostreams::zlib_params parameters;
    parameters.noheader = true;
    std::string result;
    boost::iostreams::filtering_ostream out;
    out.push(boost::iostreams::zlib_compressor(parameters));
    out.push(boost::iostreams::back_inserter(result));
    out << content;
    out.reset(); // it is complete
    return result;
  }

  static void append_size(std::string& bytes, std::size_t size)
  {
    if (size > (std::numeric_limits<std::uint32_t>::max)())
      throw std::length_error("a .3mf file has at most 4 GB");
    append_little_endian(bytes, std::uint32_t(size));
  }

  std::string m_files, m_directory;
  std::uint16_t m_number_of_files = 0;
};

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
  Zip_archive archive;
  archive.add(
    "[Content_Types].xml",
    start + "<Types xmlns=\"" + package +
      "content-types\"><Default Extension=\"rels\" "
      "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
      "<Default Extension=\"model\" "
      "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n");
  archive.add("_rels/.rels",
              start + "<Relationships xmlns=\"" + package +
                "relationships\"><Relationship Id=\"model\" Target=\"/" + model +
                "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
                "</Relationships>\n");
  std::ostringstream text;
  write_model(text, triangles_of_segments(mesh));
  archive.add(model, text.str());
  archive.write(out);
}

} // namespace segment_mesh
