// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Mesh_format.h"

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/file_endings.h"

#include <filesystem>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

fs::path without_gz(const fs::path& file)
{
  return is_compressed(file.string()) ? file.parent_path() / file.stem() : file;
}

} // namespace

const std::vector<std::pair<std::string, Mesh_format>>& mesh_formats()
{
  static const std::vector<std::pair<std::string, Mesh_format>> formats = {
    {"off", Mesh_format::OFF}, {"obj", Mesh_format::OBJ},  {"ply", Mesh_format::PLY},
    {"stl", Mesh_format::STL}, {"glb", Mesh_format::GLTF}, {"gltf", Mesh_format::GLTF}};
  return formats;
}

std::string endings_of_meshes()
{
  std::vector<std::string> endings;
  for (const auto& format : mesh_formats())
    endings.push_back(format.first);
  return list_of_endings(endings);
}

Mesh_format mesh_format(const std::string& file)
{
  if (file == standard_input)
    throw Input_error(file, "the format of standard input is not known: --input-format");
  const std::string ending = ending_of(without_gz(file).string());
  for (const auto& [name, format] : mesh_formats())
    if (name == ending)
      return format;
  throw Input_error(file, "unknown extension " + in_quotes(ending.empty() ? "" : "." + ending) +
                            ", not " + endings_of_meshes());
}

bool is_compressed(const std::string& file)
{
  return ending_of(file) == "gz";
}

std::string stem_of_input(const std::string& file)
{
  return file == standard_input ? "stdin" : without_gz(file).stem().string();
}

} // namespace segment_mesh
