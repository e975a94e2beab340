// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FORMAT_HELP_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FORMAT_HELP_H

#include <string>

namespace CLI {
class App;
}

namespace segment_mesh {

/// A few lines for somebody who gave no arguments.
std::string short_help();

/// All options in their groups, in lines of at most 80 columns.
std::string format_help(const CLI::App& app);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FORMAT_HELP_H
