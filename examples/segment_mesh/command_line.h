// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COMMAND_LINE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COMMAND_LINE_H

#include "Segmentation_settings.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace segment_mesh {

enum class Verbosity { NORMAL, QUIET };

/// What the user asks for.
struct Options
{
  std::vector<std::string> inputs; ///< none: the first of the procedural models
  std::vector<std::string> outputs;
  std::vector<std::string> truths;
  Segmentation_settings settings; ///< all but `detail`
  std::size_t number_of_threads = 0; ///< 0: one for each core
  Verbosity verbosity = Verbosity::NORMAL;
};

/// Parses the command line. Empty after `--help` and `--version`, which it prints.
/// \throws Usage_error
std::optional<Options> parse_command_line(int argc, const char* const* argv);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COMMAND_LINE_H
