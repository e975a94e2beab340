// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_mesh.h"

#include "io/load_bytes.h"

#include <iterator>
#include <utility>

namespace segment_mesh {

Input_mesh read_mesh(const std::string& file, std::optional<Mesh_format> format)
{
  if (!format)
    format = mesh_format(file);
  Remarks remarks;
  Polygon_soup soup = read_soup(file, *format, load_bytes(file), remarks);
  Input_mesh input = make_input_mesh(file, std::move(soup));
  input.remarks.insert(input.remarks.begin(), std::make_move_iterator(remarks.begin()),
                       std::make_move_iterator(remarks.end()));
  return input;
}

} // namespace segment_mesh
