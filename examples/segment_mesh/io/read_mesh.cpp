// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_mesh.h"

#include "io/diagnose_input.h"
#include "io/errors.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

#include <algorithm>
#include <cmath>
#include <exception>

namespace segment_mesh {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool read_by_cgal(std::istream& in, Mesh_format format, std::vector<Kernel::Point_3>& points,
                  std::vector<Polygon_soup::Polygon>& polygons)
{
  const auto quietly = CGAL::parameters::verbose(false);
  switch (format) {
  case Mesh_format::OFF:
    return CGAL::IO::read_OFF(in, points, polygons, quietly);
  case Mesh_format::OBJ:
    return CGAL::IO::read_OBJ(in, points, polygons, quietly);
  case Mesh_format::PLY:
    return CGAL::IO::read_PLY(in, points, polygons, quietly);
  case Mesh_format::STL:
    return CGAL::IO::read_STL(in, points, polygons, quietly);
  }
  return false;
}

bool read_by_cgal(std::istream& in, Mesh_format format, Polygon_soup& soup)
{
  std::vector<Kernel::Point_3> points;
  const bool is_read = read_by_cgal(in, format, points, soup.polygons);
  soup.points.reserve(points.size());
  for (const Kernel::Point_3& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  return is_read;
}

/// What the diagnosis has made sure of, asked again of what CGAL has read.
bool is_usable(const Polygon_soup& soup)
{
  const auto is_usable_point = [](const Point& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  const auto is_usable_polygon = [&soup](const Polygon_soup::Polygon& polygon) {
    return polygon.size() >= 3 &&
           std::all_of(polygon.begin(), polygon.end(),
                       [&soup](std::size_t i) { return i < soup.points.size(); });
  };
  return !soup.polygons.empty() &&
         std::all_of(soup.points.begin(), soup.points.end(), is_usable_point) &&
         std::all_of(soup.polygons.begin(), soup.polygons.end(), is_usable_polygon);
}

} // namespace

Input_mesh read_mesh(const std::string& file)
{
  const Mesh_format format = mesh_format(file);
  const std::string text = diagnose_input(file, format, load_file(file));
  boost::iostreams::stream<boost::iostreams::array_source> in(text.data(), text.size());

  Polygon_soup soup;
  bool is_read = false;
  try {
    is_read = read_by_cgal(in, format, soup);
  } catch (const std::ios_base::failure&) {
  }
  if (!is_read || !is_usable(soup))
    throw Input_error(file, "CGAL cannot read this file");
  return make_input_mesh(file, std::move(soup));
}

} // namespace segment_mesh
