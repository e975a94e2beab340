// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/write_mesh.h"

namespace segment_mesh {

bool can_write_glb()
{
  return false;
}

void write_glb(std::ostream&, const Labelled_mesh&) {}

} // namespace segment_mesh
