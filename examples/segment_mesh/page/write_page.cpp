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

#include <ostream>

namespace segment_mesh {

namespace embedded {
extern const char* const segment_mesh_html; // by make_page.cmake
} // namespace embedded

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
  const std::string page = embedded::segment_mesh_html, content_place = "{{CONTENT}}",
                    arrays_place = "{{ARRAYS}}";
  const std::size_t at_content = page.find(content_place),
                    after = at_content + content_place.size(),
                    at_arrays = page.find(arrays_place, after);
  out << page.substr(0, at_content) << json << page.substr(after, at_arrays - after) << arrays
      << page.substr(at_arrays + arrays_place.size());
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
