// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/page.h"

#ifdef SEGMENT_MESH_HAS_PAGES

#include <boost/algorithm/string/replace.hpp>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/iostreams/compose.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include <map>
#include <ostream>

namespace segment_mesh {

/// \name The parts of a page: files of this folder, and of three.js
/// @{
namespace embedded {
extern const char* const page_html;
extern const char* const page_css;
extern const char* const mesh_view_js;
extern const char* const merge_tree_js;
extern const char* const page_js;
extern const char* const read_arrays_js;
extern const char* const show_saved_js;
extern const char* const three_min_js;
extern const char* const TrackballControls_js;
extern const char* const GLTFExporter_js;
} // namespace embedded
/// @}

namespace {

/// Bytes in the standard alphabet with padding (RFC 4648, section 4).
std::string base64(const std::string& bytes)
{
  namespace iterators = boost::archive::iterators;
  using Encoder = iterators::base64_from_binary<
    iterators::transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  std::string padded = bytes;
  padded.append(padding, '\0'); // transform_width would read beyond the end
  std::string text(Encoder(padded.cbegin()), Encoder(padded.cend()));
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

std::string compressed(const std::string& bytes)
{
  std::string result;
  boost::iostreams::filtering_ostream out(boost::iostreams::gzip_compressor() |
                                          boost::iostreams::back_inserter(result));
  out.write(bytes.data(), std::streamsize(bytes.size()));
  out.reset();
  return result;
}

} // namespace

bool can_write_pages()
{
  return true;
}

void write_page(std::ostream& out, const Page_content& content)
{
  Page_data data = page_data(content);
  data.content["coloring"] = content.coloring == Coloring::KINDS ? "kinds" : "segments";
  data.content["shapes"] = shapes_json(content);
  // JSON inside of a script element must not end it.
  const std::string json = boost::replace_all_copy(text_of(data.content), "<", "\\u003c"),
                    arrays = base64(compressed(data.arrays));
  // Only a page that has the library is live.
  const std::map<std::string, std::string> parts = {{"STYLE", embedded::page_css},
                                                    {"LIVE", ""},
                                                    {"ENGINE", ""},
                                                    {"CONTENT", json},
                                                    {"ARRAYS", arrays},
                                                    {"THREE", embedded::three_min_js},
                                                    {"CONTROLS", embedded::TrackballControls_js},
                                                    {"EXPORTER", embedded::GLTFExporter_js},
                                                    {"READ_ARRAYS", embedded::read_arrays_js},
                                                    {"MERGE_TREE", embedded::merge_tree_js},
                                                    {"MESH_VIEW", embedded::mesh_view_js},
                                                    {"PAGE", embedded::page_js},
                                                    {"START", embedded::show_saved_js}};
  // A part takes the place of {{NAME}}.
  const std::string page = embedded::page_html;
  std::size_t at = 0;
  for (std::size_t start = page.find("{{"); start != std::string::npos;
       start = page.find("{{", at)) {
    const std::size_t end = page.find("}}", start);
    out << page.substr(at, start - at) << parts.at(page.substr(start + 2, end - start - 2));
    at = end + 2;
  }
  out << page.substr(at);
}

} // namespace segment_mesh

#else // built without three.js

namespace segment_mesh {

bool can_write_pages()
{
  return false;
}

void write_page(std::ostream&, const Page_content&) {}

} // namespace segment_mesh

#endif // SEGMENT_MESH_HAS_PAGES
