// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/read_soup.h"

namespace segment_mesh {

Polygon_soup read_soup(const std::string& file, Mesh_format format, std::string_view bytes,
                       Remarks& remarks)
{
  switch (format) {
  case Mesh_format::OFF:
    return read_off(file, bytes, remarks);
  case Mesh_format::OBJ:
    return read_obj(file, bytes, remarks);
  case Mesh_format::PLY:
    return read_ply(file, bytes, remarks);
  case Mesh_format::STL:
    return read_stl(file, bytes, remarks);
  case Mesh_format::GLTF:
    return read_gltf(file, bytes, remarks);
  }
  return {};
}

} // namespace segment_mesh
