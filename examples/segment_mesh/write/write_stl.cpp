// SPDX-License-Identifier: GPL-3.0-or-later

#include "soup/vector_algebra.h"
#include "write/Text_buffer.h"
#include "write/write_mesh.h"

#include <ostream>
#include <vector>

namespace segment_mesh {

void write_stl(std::ostream& out, const Labelled_mesh& mesh)
{
  Text_buffer text(out);
  for (const Segment_triangles& segment : triangles_of_segments(mesh)) {
    text << "solid " << segment.name << "\n";
    for (const auto& t : segment.triangles) {
      const std::vector<Point>& points = segment.part.soup.points;
      const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
      write_numbers(text, "facet normal ", unit_vector(cross_product(minus(b, a), minus(c, a))));
      text << "\nouter loop";
      for (const Point& corner : {a, b, c})
        write_numbers(text, "\nvertex ", corner);
      text << "\nendloop\nendfacet\n";
    }
    text << "endsolid " << segment.name << "\n";
  }
}

} // namespace segment_mesh
