// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COMMAND_LINE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COMMAND_LINE_H

#include "batch/plan_jobs.h"

#include <optional>

namespace segment_mesh {

/// Parses the command line. Empty where that is done with a text that it prints: help, the version.
/// \throws Usage_error
std::optional<Options> parse_command_line(int argc, const char* const* argv);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_COMMAND_LINE_H
