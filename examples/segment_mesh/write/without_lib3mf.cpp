// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/write_mesh.h"

namespace segment_mesh {

bool can_write_3mf()
{
  return false;
}

void write_3mf(std::ostream&, const Labelled_mesh&) {}

} // namespace segment_mesh
