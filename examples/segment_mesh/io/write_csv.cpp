// SPDX-License-Identifier: GPL-3.0-or-later

// The .csv output: a line for each segment, after one of the names of its columns.
//
//   segment, faces, area, area_share, volume, volume_share, border_length, boundary_length,
//   centroid_x, centroid_y, centroid_z, extent_1, extent_2, extent_3, primitive, radius,
//   half_angle, error, neighbors
//
// They are those of `Segment_description`; lengths, areas and volumes in units of the mesh, half_angle in degrees. radius
// is empty but for a sphere or a cylinder, half_angle but for a cone; neighbors are separated by spaces. A value that
// is too large for a double is inf.

#include "io/Text_buffer.h"
#include "io/write_segmentation.h"
#include "segmentation/segment_json.h"

#include <CGAL/number_type_config.h>

namespace segment_mesh {

namespace {

using CGAL::Region_segmentation::Primitive_type;

void write_primitive(Text_buffer& text, const Fitted_primitive& primitive)
{
  text << "," << name_of(primitive.type) << ",";
  if (has_radius(primitive))
    text << primitive.radius;
  text << ",";
  if (primitive.type == Primitive_type::CONE)
    text << primitive.half_angle * 180 / CGAL_PI;
  text << "," << primitive.error;
}

} // namespace

void write_csv(std::ostream& out, const Result& result)
{
  Text_buffer text(out);
  text << "segment,faces,area,area_share,volume,volume_share,border_length,boundary_length,centroid_x,centroid_y,"
          "centroid_z,extent_1,extent_2,extent_3,primitive,radius,half_angle,error,neighbors\n";
  const std::vector<Segment_description> segments = result.details.segments();
  double area = 0;
  for (const Segment_description& s : segments)
    area += s.area;
  for (const Segment_description& s : segments) {
    text << s.segment << "," << s.number_of_faces << "," << s.area << "," << (area > 0 ? s.area / area : 0) << ","
         << s.volume << "," << s.volume_share << "," << s.border_length << "," << s.boundary_length << ","
         << s.centroid.x() << "," << s.centroid.y() << "," << s.centroid.z();
    for (double extent : s.extents)
      text << "," << extent;
    write_primitive(text, s.primitive);
    const char* separator = ",";
    for (const auto& neighbor : s.neighbors) {
      text << separator << neighbor.segment;
      separator = " ";
    }
    text << (s.neighbors.empty() ? ",\n" : "\n");
  }
}

} // namespace segment_mesh
