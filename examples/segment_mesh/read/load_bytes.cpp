// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/load_bytes.h"

#include "read/Mesh_format.h"
#include "read/errors.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
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

std::string load_file(const std::string& file)
{
  check_regular_file(file);
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in)
    throw Input_error(file, "cannot be opened: " + std::generic_category().message(errno));
  std::string bytes(std::size_t(in.tellg()), '\0');
  in.seekg(0);
  errno = 0; // the end of the file, which is an error here, leaves it alone
  if (!in.read(bytes.data(), std::streamsize(bytes.size())))
    throw Input_error(file, errno == 0
                              ? "was cut off while it was read: " + std::to_string(in.gcount()) +
                                  " of " + std::to_string(bytes.size()) + " bytes"
                              : "cannot be read: " + std::generic_category().message(errno));
  return bytes;
}

std::string load_standard_input()
{
  constexpr std::size_t block_size = std::size_t(1) << 20;
  std::string bytes;
  std::size_t size = 0;
  do {
    bytes.resize(size + block_size);
    size += std::fread(&bytes[size], 1, block_size, stdin);
  } while (size == bytes.size());
  if (std::ferror(stdin))
    throw Input_error(standard_input, "cannot be read: " + std::generic_category().message(errno));
  bytes.resize(size);
  return bytes;
}

} // namespace

std::string load_bytes(const std::string& file, Remarks& remarks, std::size_t expected_size)
{
  std::string bytes = file == standard_input ? load_standard_input() : load_file(file);
  if (is_gzip(bytes))
    bytes = inflate(file, bytes, remarks, expected_size);
  if (bytes.empty())
    throw Input_error(file, "is empty");
  return bytes;
}

} // namespace segment_mesh
