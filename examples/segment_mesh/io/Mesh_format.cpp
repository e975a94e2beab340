// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Mesh_format.h"

#include "io/Text_scanner.h"
#include "io/errors.h"

#include <cctype>
#include <filesystem>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

/// In lower case.
std::string ending_of(const fs::path& file)
{
  std::string ending = file.extension().string();
  for (char& c : ending)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

fs::path without_gz(const fs::path& file)
{
  return is_compressed(file.string()) ? file.parent_path() / file.stem() : file;
}

} // namespace

Mesh_format mesh_format(const std::string& file)
{
  if (file == standard_input)
    throw Input_error(file, "the format of standard input is not known: --input-format");
  const std::string ending = ending_of(without_gz(file));
  if (ending == ".off")
    return Mesh_format::OFF;
  if (ending == ".obj")
    return Mesh_format::OBJ;
  if (ending == ".ply")
    return Mesh_format::PLY;
  if (ending == ".stl")
    return Mesh_format::STL;
  if (ending == ".glb" || ending == ".gltf")
    return Mesh_format::GLTF;
  throw Input_error(file, "unknown extension " + in_quotes(ending) +
                            ", not .off, .obj, .ply, .stl, .glb or .gltf");
}

bool is_compressed(const std::string& file)
{
  return ending_of(file) == ".gz";
}

std::string stem_of_input(const std::string& file)
{
  return file == standard_input ? "stdin" : without_gz(file).stem().string();
}

} // namespace segment_mesh
