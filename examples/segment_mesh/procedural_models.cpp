// SPDX-License-Identifier: GPL-3.0-or-later

#include "procedural_models.h"

#include "articulated_figure.h"

namespace segment_mesh {

const std::vector<Model_recipe>& procedural_models()
{
  static const std::vector<Model_recipe> recipes = {
    {"articulated_figure", make_articulated_figure}};
  return recipes;
}

} // namespace segment_mesh
