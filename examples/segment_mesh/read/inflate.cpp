// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/inflate.h"

#include "read/Text_scanner.h"
#include "read/errors.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>

namespace segment_mesh {

namespace {

constexpr std::size_t usual_inflation = 4; // of a text
constexpr int gzip_format = 16;            // zlib's flag, to be added to the size of the window

struct End_of_stream
{
  void operator()(z_stream* stream) const { inflateEnd(stream); }
};

uInt bounded(std::size_t size)
{
  return uInt((std::min)(size, std::size_t((std::numeric_limits<uInt>::max)())));
}

} // namespace

bool is_gzip(std::string_view bytes)
{
  return bytes.substr(0, 2) == "\x1f\x8b";
}

std::string inflate(const std::string& file, std::string_view bytes, Remarks& remarks,
                    std::size_t expected_size)
{
  z_stream stream{};
  if (inflateInit2(&stream, gzip_format + MAX_WBITS) != Z_OK)
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, End_of_stream> end(&stream);

  std::string result;
  std::size_t size = 0, taken = 0;
  int status = Z_OK;
  while (status != Z_STREAM_END || taken < bytes.size()) {
    if (status == Z_STREAM_END) {
      if (!is_gzip(bytes.substr(taken))) {
        if (bytes.find_first_not_of('\0', taken) != std::string_view::npos)
          remarks.push_back(bytes_not_read(file, bytes.size() - taken) +
                            " after the end of the gzip data");
        break;
      }
      inflateReset(&stream);
    }
    if (size == result.size())
      result.resize(size + (std::max)(size, usual_inflation * bytes.size()));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));
    stream.avail_in = bounded(bytes.size() - taken);
    stream.next_out = reinterpret_cast<Bytef*>(&result[size]);
    stream.avail_out = bounded(result.size() - size);
    const uInt in = stream.avail_in, out = stream.avail_out;
    status = ::inflate(&stream, Z_NO_FLUSH);
    taken += in - stream.avail_in;
    size += out - stream.avail_out;
    if (status == Z_BUF_ERROR) // no progress, although there is room for output
      throw Input_error(file, "is a gzip file that is cut off");
    if (status != Z_OK && status != Z_STREAM_END)
      throw Input_error(file, "is a damaged gzip file");
    if (size > (std::max)(expected_size, largest_inflation * bytes.size()))
      throw Input_error(file, "is a gzip file that grows by more than " +
                                std::to_string(largest_inflation) + " times");
  }
  result.resize(size);
  return result;
}

} // namespace segment_mesh
