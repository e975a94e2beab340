// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/load_bytes.h"

#include "read/errors.h"
#include "read/read_mesh.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

void check_regular_file(const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    throw Input_error(file, "no such file");
  if (error)
    throw Input_error(file, error.message());
  if (fs::is_directory(status))
    throw Input_error(file, "is a directory");
  if (!fs::is_regular_file(status))
    throw Input_error(file, "is not a regular file");
}

struct Close_file
{
  void operator()(gzFile file) const { gzclose(file); }
};

} // namespace

std::string load_bytes(const std::string& file, std::size_t expected_size)
{
  const bool is_file = file != standard_input;
  if (is_file)
    check_regular_file(file);
  // It reads other files than those of gzip as they are.
  const std::unique_ptr<gzFile_s, Close_file> in(is_file ? gzopen(file.c_str(), "rb")
                                                         : gzdopen(fileno(stdin), "rb"));
  if (!in)
    throw Input_error(file, "cannot be opened: " + std::generic_category().message(errno));
  const std::size_t file_size = is_file ? std::size_t(fs::file_size(file)) : 0;
  std::string bytes(is_file ? file_size + 1 : harmless_size, '\0');
  std::size_t size = 0;
  for (int taken = 1; taken > 0; size += std::size_t((std::max)(taken, 0))) {
    if (size == bytes.size())
      bytes.resize(2 * size);
    taken = gzread(in.get(), &bytes[size],
                   unsigned((std::min)(bytes.size() - size, std::size_t(1) << 30)));
    if (is_file && size > (std::max)(expected_size, largest_inflation * file_size))
      throw Input_error(file, "is a gzip file that grows by more than " +
                                std::to_string(largest_inflation) + " times");
  }
  int status = Z_OK;
  gzerror(in.get(), &status);
  if (status == Z_ERRNO)
    throw Input_error(file, "cannot be read: " + std::generic_category().message(errno));
  if (status != Z_OK)
    throw Input_error(file, status == Z_BUF_ERROR ? "is a gzip file that is cut off"
                                                  : "is a damaged gzip file");
  if (size == 0)
    throw Input_error(file, "is empty");
  bytes.resize(size);
  return bytes;
}

} // namespace segment_mesh
