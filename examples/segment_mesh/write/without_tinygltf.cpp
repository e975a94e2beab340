// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/errors.h"
#include "read/read_soup.h"
#include "write/write_mesh.h"

namespace segment_mesh {

Polygon_soup read_gltf(const std::string& file, std::string_view, Remarks&)
{
  throw Input_error(
    file, "glTF needs tinygltf (Debian: libtinygltf-dev), and this program was built without it");
}

bool can_write_glb()
{
  return false;
}

void write_glb(std::ostream&, const Labelled_mesh&) {}

} // namespace segment_mesh
