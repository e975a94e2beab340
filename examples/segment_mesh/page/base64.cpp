// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/base64.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace segment_mesh {

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

} // namespace segment_mesh
