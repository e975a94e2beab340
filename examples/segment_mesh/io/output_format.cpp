// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/output_format.h"

#include "io/errors.h"

#include <cctype>
#include <filesystem>
#include <iterator>

namespace segment_mesh {

Output_format output_format(const std::string& file)
{
  // In the order of Output_format.
  constexpr const char* endings[] = {".seg", ".ply", ".off", ".obj", ".json", ".png"};
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  for (std::size_t i = 0; i < std::size(endings); ++i)
    if (ending == endings[i])
      return Output_format(i);
  throw Usage_error(file + ": unknown ending of an output, not .seg, .ply, .off, .obj, .json or .png");
}

bool needs_details(Output_format format)
{
  return format == Output_format::OBJ || format == Output_format::JSON ||
         format == Output_format::PNG;
}

} // namespace segment_mesh
