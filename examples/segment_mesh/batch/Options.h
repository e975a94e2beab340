// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OPTIONS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OPTIONS_H

#include "read/read_mesh.h"
#include "write/output_format.h"
#include "segmentation/Segmentation_settings.h"
#include "view/Viewpoint.h"
#include "view/segment_colors.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace segment_mesh {

enum class Verbosity { NORMAL, QUIET };

/// What the user asks for.
struct Options
{
  std::vector<std::string> inputs;
  std::optional<Mesh_format> input_format; ///< of all inputs; if empty, what their endings name
  bool is_demo = false;                    ///< the model that the program builds, instead of inputs
  std::vector<Output> outputs;
  std::vector<std::string> truths;
  Side_files side_files;
  Segmentation_settings settings;
  std::size_t number_of_threads = 0;      ///< 0: one for each core
  std::optional<Viewpoint> viewpoint;     ///< of pictures; if empty, the one that shows most
  Coloring coloring = Coloring::SEGMENTS; ///< of pictures and pages
  Verbosity verbosity = Verbosity::NORMAL;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_OPTIONS_H
