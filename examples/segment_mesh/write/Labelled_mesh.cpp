// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Labelled_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

namespace segment_mesh {

namespace {

/// Of the corners of some faces.
template <typename Value>
Corner_values<Value> extract_values(const Corner_values<Value>& all, const Polygons& polygons,
                                    const std::vector<std::size_t>& faces)
{
  Corner_values<Value> result;
  if (all.empty())
    return result;
  std::map<Polygons::Index, Polygons::Index> new_place = {{all.none, all.none}};
  for (std::size_t f : faces)
    for (std::size_t i = 0, first = polygons.first_corner(f); i < polygons[f].size(); ++i) {
      const Polygons::Index old = all.of_corner[first + i];
      const auto [place, is_new] = new_place.emplace(old, Polygons::Index(result.values.size()));
      if (is_new)
        result.values.push_back(all.values[old]);
      result.of_corner.push_back(place->second);
    }
  return result;
}

} // namespace

std::string singular(Set_kind kind)
{
  const std::string name = set_kind_names[std::size_t(kind)];
  return name.substr(0, name.size() - (name.back() == 's'));
}

std::vector<Mesh_properties::Rgb> colors_of_points(const Labelled_mesh& mesh)
{
  const auto& colors = mesh.properties.colors;
  return colors.empty() ? std::vector<Mesh_properties::Rgb>()
                        : colors.of_points(mesh.soup, Mesh_properties::white);
}

Color bytes_of(const Mesh_properties::Rgb& color)
{
  Color bytes;
  std::transform(color.begin(), color.end(), bytes.begin(), [](float channel) {
    return std::uint8_t(std::lround(255 * (std::max)(0.f, (std::min)(channel, 1.f))));
  });
  return bytes;
}

std::string relative_name(const std::string& from, const std::string& name, const std::string& to)
{
  namespace fs = std::filesystem;
  const auto absolute = [](const std::string& folder) {
    return fs::weakly_canonical(fs::absolute(fs::path(folder) / "."));
  };
  return (absolute(from) / name).lexically_proximate(absolute(to)).generic_string();
}

std::vector<std::vector<std::size_t>>
faces_of_segments(const std::vector<std::size_t>& segment_of_face)
{
  std::size_t number_of_segments = 0;
  for (std::size_t label : segment_of_face)
    number_of_segments = (std::max)(number_of_segments, label + 1); // no_segment and 1 are 0
  std::vector<std::vector<std::size_t>> faces(number_of_segments + 1);
  for (std::size_t f = 0; f < segment_of_face.size(); ++f)
    faces[(std::min)(segment_of_face[f], number_of_segments)].push_back(f);
  return faces;
}

Mesh_part extract_faces(const Labelled_mesh& mesh, const std::vector<std::size_t>& faces)
{
  const Mesh_properties& properties = mesh.properties;
  Mesh_part part;
  std::vector<std::size_t> points;
  for (std::size_t f : faces) {
    const Polygon_soup::Polygon& polygon = mesh.soup.polygons[f];
    part.soup.polygons.push_back(polygon);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (std::size_t i : points)
    part.soup.points.push_back(mesh.soup.points[i]);
  part.soup.polygons.renumber([&](std::size_t i) {
    return std::lower_bound(points.begin(), points.end(), i) - points.begin();
  });

  part.properties.library = properties.library;
  part.properties.colors = extract_values(properties.colors, mesh.soup.polygons, faces);
  part.properties.texture = extract_values(properties.texture, mesh.soup.polygons, faces);
  for (Set_kind kind : properties.kinds()) {
    part.properties.of(kind).names = properties.of(kind).names;
    for (std::size_t f : faces)
      part.properties.of(kind).set_of_face.push_back(properties.of(kind).set_of_face[f]);
  }
  return part;
}

Face_triangles triangulate_faces(const Polygon_soup& soup)
{
  Face_triangles result;
  Triangles& triangles = result.triangles;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const auto first = std::ptrdiff_t(triangles.size());
    triangulate_polygon(soup.points, soup.polygons[f], triangles);
    triangles.erase(
      std::remove_if(triangles.begin() + first, triangles.end(),
                     [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
      triangles.end());
    result.face_of_triangle.resize(triangles.size(), f);
  }
  return result;
}

std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh)
{
  std::vector<Segment_triangles> result;
  const auto faces = faces_of_segments(mesh.segment_of_face);
  for (std::size_t segment = 0; segment + 1 < faces.size(); ++segment) {
    Mesh_part part = extract_faces(mesh, faces[segment]);
    Face_triangles triangles = triangulate_faces(part.soup);
    if (!triangles.triangles.empty())
      result.push_back(
        {std::move(triangles), mesh.name(segment), segment_color(segment), std::move(part)});
  }
  return result;
}

} // namespace segment_mesh
