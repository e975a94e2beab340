// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Labelled_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <utility>

namespace segment_mesh {

namespace {

void make_unique(std::vector<std::size_t>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::size_t place_of(std::size_t number, const std::vector<std::size_t>& sorted)
{
  return std::size_t(std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
}

} // namespace

std::string singular(Set_kind kind)
{
  const std::string name = set_kind_names[std::size_t(kind)];
  return name.substr(0, name.size() - 1);
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
  return fs::absolute(fs::path(from) / name)
    .lexically_proximate(fs::absolute(fs::path(to) / "."))
    .generic_string();
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
  part.properties.library = properties.library;
  std::vector<std::size_t> points, texture_points;
  for (std::size_t f : faces) {
    const Polygon_soup::Polygon& polygon = mesh.soup.polygons[f];
    part.soup.polygons.push_back(polygon);
    points.insert(points.end(), polygon.begin(), polygon.end());
    const std::size_t first = std::size_t(polygon.begin() - mesh.soup.polygons.corners().data());
    if (!properties.texture_corners.empty())
      for (std::size_t i = first; i < first + polygon.size(); ++i)
        part.properties.texture_corners.push_back(properties.texture_corners[i]);
  }
  for (Set_kind kind : properties.kinds()) {
    part.properties.of(kind).names = properties.of(kind).names;
    for (std::size_t f : faces)
      part.properties.of(kind).set_of_face.push_back(properties.of(kind).set_of_face[f]);
  }
  make_unique(points);
  for (std::size_t i : points) {
    part.soup.points.push_back(mesh.soup.points[i]);
    if (!properties.colors.empty())
      part.properties.colors.push_back(properties.colors[i]);
  }
  part.soup.polygons.renumber([&](std::size_t i) { return place_of(i, points); });
  for (Polygons::Index i : part.properties.texture_corners)
    if (i != Mesh_properties::no_texture)
      texture_points.push_back(i);
  make_unique(texture_points);
  for (std::size_t i : texture_points)
    part.properties.texture_points.push_back(properties.texture_points[i]);
  for (Polygons::Index& i : part.properties.texture_corners)
    if (i != Mesh_properties::no_texture)
      i = Polygons::Index(place_of(i, texture_points));
  return part;
}

void add_triangles(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon,
                   Triangles& triangles)
{
  const auto first = std::ptrdiff_t(triangles.size());
  triangulate_polygon(soup.points, polygon, triangles);
  triangles.erase(
    std::remove_if(triangles.begin() + first, triangles.end(),
                   [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
    triangles.end());
}

std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh)
{
  std::vector<Segment_triangles> result;
  const auto faces = faces_of_segments(mesh.segment_of_face);
  for (std::size_t segment = 0; segment + 1 < faces.size(); ++segment) {
    Segment_triangles triangles{
      mesh.name(segment), segment_color(segment), extract_faces(mesh, faces[segment]), {}, {}};
    const Polygon_soup& soup = triangles.part.soup;
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
      add_triangles(soup, soup.polygons[f], triangles.triangles);
      triangles.face_of_triangle.resize(triangles.triangles.size(), f);
    }
    if (!triangles.triangles.empty())
      result.push_back(std::move(triangles));
  }
  return result;
}

} // namespace segment_mesh
