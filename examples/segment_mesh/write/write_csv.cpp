// SPDX-License-Identifier: GPL-3.0-or-later

// The .csv output: a line for each segment, after one of the names of its columns.
//
//   segment, faces, area, area_share, volume, volume_share, border_length, boundary_length,
//   centroid_x, centroid_y, centroid_z, extent_1, extent_2, extent_3, primitive, radius,
//   half_angle, error, neighbors, point_x, point_y, point_z, direction_x, direction_y, direction_z,
//   minor_radius, lowest, highest, concave, role, same_surface, same_axis, smooth_neighbors
//
// They are those of `Segment_description`; lengths, areas and volumes in units of the mesh,
// half_angle in degrees. radius is empty but for a sphere, cylinder or torus, half_angle but for a
// cone; neighbors are separated by spaces, -1 stands for faces of no segment. A value that is too
// large for a double is empty.
// Of the method smooth-faces, unless faces were merged: primitive and what belongs to it are those
// of `Fitted_surface`, the point of a cone its apex, error the largest distance of a vertex;
// lowest and highest the ends of a cylinder, cone or torus along direction from point; concave 1 or
// 0; role none, blend, hole or boss; same_surface and same_axis the first segment on the same
// surface, with the same axis; smooth_neighbors those of the neighbors that it meets smoothly.

#include "write/Text_buffer.h"
#include "write/write_segmentation.h"
#include "segmentation/segment_json.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <limits>
#include <vector>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// After a comma.
void write_value(Text_buffer& text, double value)
{
  text << ",";
  if (std::isfinite(value))
    text << value;
}

void write_primitive(Text_buffer& text, const Segment_description& segment)
{
  const RS::Fitted_surface<Kernel> s = surface_of(segment);
  text << "," << name_of(s.kind);
  write_value(text, has_radius(s) ? s.radius : none);
  write_value(text, s.kind == RS::Surface_kind::CONE ? s.angle * 180 / CGAL_PI : none);
  write_value(text, s.kind == RS::Surface_kind::FREEFORM ? none : error_of(segment));
}

void write_numbers(Text_buffer& text, const std::vector<std::size_t>& numbers)
{
  const char* separator = ",";
  for (std::size_t number : numbers) {
    text << separator << std::int64_t(number);
    separator = " ";
  }
  if (numbers.empty())
    text << ",";
}

/// The place of a surface, and what is known of faces of machine parts.
void write_face(Text_buffer& text, const Segment_description& segment)
{
  const RS::Fitted_surface<Kernel> s = surface_of(segment);
  const bool has_point = s.kind != RS::Surface_kind::FREEFORM,
             has_direction = has_point && s.kind != RS::Surface_kind::SPHERE;
  for (double x : {s.point.x(), s.point.y(), s.point.z()})
    write_value(text, has_point ? x : none);
  for (double x : {s.direction.x(), s.direction.y(), s.direction.z()})
    write_value(text, has_direction ? x : none);
  write_value(text, s.kind == RS::Surface_kind::TORUS ? s.minor_radius : none);
  for (double z : {s.lowest, s.highest})
    write_value(text, segment.face && s.has_axis() ? z : none);
  if (!segment.face)
    text << ",,,,";
  else
    text << "," << (s.side < 0 ? 1 : 0) << "," << name_of(segment.face->role) << ","
         << segment.face->same_surface << "," << segment.face->same_axis;
  write_numbers(text, segment.smooth_neighbors.value_or(std::vector<std::size_t>()));
}

/// Of the segments: by the areas of regions, whose unit is so that none is too large.
std::vector<double> area_shares(const Result& result)
{
  std::vector<double> shares(result.segmentation.number_of_segments);
  double area = 0;
  for (const Region& region : result.details.regions()) {
    if (region.segment != RS::no_segment)
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
          "centroid_z,extent_1,extent_2,extent_3,primitive,radius,half_angle,error,neighbors,"
          "point_x,point_y,point_z,direction_x,direction_y,direction_z,minor_radius,lowest,highest,"
          "concave,role,same_surface,same_axis,smooth_neighbors\n";
  const std::vector<double> shares = area_shares(result);
  for (const Segment_description& s : result.details.segments()) {
    text << s.segment << "," << s.number_of_faces;
    for (double value :
         {s.area, shares[s.segment], s.volume, s.volume_share, s.border_length, s.boundary_length,
          s.centroid.x(), s.centroid.y(), s.centroid.z(), s.extents[0], s.extents[1], s.extents[2]})
      write_value(text, value);
    write_primitive(text, s);
    std::vector<std::size_t> neighbors;
    for (const auto& neighbor : s.neighbors)
      neighbors.push_back(neighbor.segment);
    write_numbers(text, neighbors);
    write_face(text, s);
    text << "\n";
  }
}

} // namespace segment_mesh
