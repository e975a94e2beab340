// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <cstddef>
#include <ostream>

namespace segment_mesh {

void write_off(std::ostream& out, const Labelled_mesh& mesh)
{
  Text_buffer text(out);
  text << "OFF\n" << mesh.soup.points.size() << " " << mesh.soup.polygons.size() << " 0\n";
  for (const Point& p : mesh.soup.points) {
    write_numbers(text, "", p);
    text << "\n";
  }
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    text << mesh.soup.polygons[f].size();
    write_numbers(text, " ", mesh.soup.polygons[f]);
    write_numbers(text, " ", segment_color(mesh.segment_of_face[f]));
    text << "\n";
  }
}

} // namespace segment_mesh
