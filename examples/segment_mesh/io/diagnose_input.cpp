// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/diagnose_input.h"

#include "io/Text_scanner.h"
#include "io/errors.h"

#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

Mesh_format mesh_format(const std::string& file)
{
  std::string ending = fs::path(file).extension().string();
  for (char& c : ending)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".off")
    return Mesh_format::OFF;
  if (ending == ".obj")
    return Mesh_format::OBJ;
  if (ending == ".ply")
    return Mesh_format::PLY;
  if (ending == ".stl")
    return Mesh_format::STL;
  throw Input_error(file, "unknown ending " + in_quotes(ending) + ", not .off, .obj, .ply or .stl");
}

std::string load_file(const std::string& file)
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
  if (bytes.empty())
    throw Input_error(file, "is empty");
  return bytes;
}

std::string diagnose_input(const std::string& file, Mesh_format format, std::string bytes)
{
  switch (format) {
  case Mesh_format::OFF:
    return diagnose_off(file, std::move(bytes));
  case Mesh_format::OBJ:
    return diagnose_obj(file, bytes);
  case Mesh_format::PLY:
    return diagnose_ply(file, bytes);
  case Mesh_format::STL:
    return diagnose_stl(file, std::move(bytes));
  }
  return bytes;
}

} // namespace segment_mesh
