// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/procedural_models.h"

#include "models/articulated_figure.h"
#include "models/block_models.h"
#include "models/implicit_models.h"
#include "models/revolution_models.h"

namespace segment_mesh {

const std::vector<Model_recipe>& procedural_models()
{
  static const std::vector<Model_recipe> recipes = {{"articulated_figure", make_articulated_figure},
                                                    {"vase", make_vase},
                                                    {"goblet", make_goblet},
                                                    {"snowman", make_snowman},
                                                    {"shaft", make_shaft},
                                                    {"screwdriver", make_screwdriver},
                                                    {"table", make_table},
                                                    {"chair", make_chair},
                                                    {"bracket", make_bracket},
                                                    {"gear", make_gear},
                                                    {"mug", make_mug},
                                                    {"hammer", make_hammer},
                                                    {"octopus", make_octopus},
                                                    {"hand", make_hand},
                                                    {"quadruped", make_quadruped}};
  return recipes;
}

} // namespace segment_mesh
