// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/file_endings.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>

namespace segment_mesh {

std::string ending_of(const std::string& file)
{
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return ending.empty() ? ending : ending.substr(1);
}

std::string list_of_endings(const std::vector<std::string>& endings)
{
  std::string list;
  for (std::size_t i = 0; i < endings.size(); ++i)
    list += (i == 0 ? "." : i + 1 < endings.size() ? ", ." : " or .") + endings[i];
  return list;
}

} // namespace segment_mesh
