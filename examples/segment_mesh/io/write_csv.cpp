// SPDX-License-Identifier: GPL-3.0-or-later

// The .csv output: a line for each segment, after one of the names of its columns.
//
//   segment, faces, area, area_share, volume, volume_share, border_length, boundary_length,
//   centroid_x, centroid_y, centroid_z, extent_1, extent_2, extent_3, primitive, radius,
//   half_angle, error, neighbors
//
// They are those of `Segment_description`; lengths, areas and volumes in units of the mesh,
// half_angle in degrees. radius is empty but for a sphere or a cylinder, half_angle but for a cone;
// neighbors are separated by spaces. A value that is too large for a double is empty.

#include "io/Text_buffer.h"
#include "io/write_segmentation.h"
#include "segmentation/segment_json.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <limits>
#include <vector>

namespace segment_mesh {

namespace {

using CGAL::Region_segmentation::Primitive_type;

/// After a comma.
void write_value(Text_buffer& text, double value)
{
  text << ",";
  if (std::isfinite(value))
    text << value;
}

void write_primitive(Text_buffer& text, const Fitted_primitive& primitive)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  text << "," << name_of(primitive.type);
  write_value(text, has_radius(primitive) ? primitive.radius : none);
  write_value(text,
              primitive.type == Primitive_type::CONE ? primitive.half_angle * 180 / CGAL_PI : none);
  write_value(text, primitive.error);
}

/// Of the segments: by the areas of regions, whose unit is so that none is too large.
std::vector<double> area_shares(const Result& result)
{
  std::vector<double> shares(result.segmentation.number_of_segments);
  double area = 0;
  for (const Region& region : result.details.regions()) {
    shares[region.segment] += region.area;
    area += region.area;
  }
  for (double& share : shares)
    share = area > 0 ? share / area : 0;
  return shares;
}

} // namespace

void write_csv(std::ostream& out, const Result& result)
{
  Text_buffer text(out);
  text << "segment,faces,area,area_share,volume,volume_share,border_length,boundary_length,"
          "centroid_x,centroid_y,"
          "centroid_z,extent_1,extent_2,extent_3,primitive,radius,half_angle,error,neighbors\n";
  const std::vector<double> shares = area_shares(result);
  for (const Segment_description& s : result.details.segments()) {
    text << s.segment << "," << s.number_of_faces;
    for (double value :
         {s.area, shares[s.segment], s.volume, s.volume_share, s.border_length, s.boundary_length,
          s.centroid.x(), s.centroid.y(), s.centroid.z(), s.extents[0], s.extents[1], s.extents[2]})
      write_value(text, value);
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
