// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/read_mesh.h"

#include "read/load_bytes.h"

namespace segment_mesh {

Input_mesh read_mesh(const std::string& file, std::optional<Mesh_format> format)
{
  if (!format)
    format = mesh_format(file);
  Input_mesh input;
  const std::string bytes = load_bytes(file, input.remarks);
  input.soup = read_soup(file, *format, bytes, input.remarks);
  return input;
}

} // namespace segment_mesh
