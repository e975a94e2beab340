// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/read_mesh.h"

#include "read/Text_scanner.h"
#include "read/errors.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/unordered_map.hpp>

#include <filesystem>
#include <system_error>
#include <utility>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

fs::path without_gz(const fs::path& file)
{
  return ending_of(file.string()) == "gz" ? file.parent_path() / file.stem() : file;
}

/// Of points with the same coordinates keeps the first; those that are kept stay in order.
void merge_equal_points(Polygon_soup& soup)
{
  std::vector<Point> points;
  std::vector<std::size_t> new_index;
  boost::unordered_map<Point, std::size_t> index_at;
  index_at.reserve(soup.points.size() / 4); // a vertex of triangles that share no points is given
                                            // six times
  for (const Point& p : soup.points) {
    const auto [place, is_new] = index_at.emplace(p, points.size());
    if (is_new)
      points.push_back(p);
    new_index.push_back(place->second);
  }
  soup.points = std::move(points);
  soup.polygons.renumber([&](std::size_t i) { return new_index[i]; });
}

} // namespace

std::string ending_of(const std::string& file)
{
  const std::string ending = boost::algorithm::to_lower_copy(fs::path(file).extension().string());
  return ending.empty() ? ending : ending.substr(1);
}

std::string list_of_endings(const std::vector<std::string>& endings)
{
  std::string list;
  for (std::size_t i = 0; i < endings.size(); ++i)
    list += (i == 0 ? "." : i + 1 < endings.size() ? ", ." : " or .") + endings[i];
  return list;
}

const std::vector<std::pair<std::string, Mesh_format>>& mesh_formats()
{
  static const std::vector<std::pair<std::string, Mesh_format>> formats = {
    {"off", Mesh_format::OFF},     {"obj", Mesh_format::OBJ},  {"ply", Mesh_format::PLY},
    {"stl", Mesh_format::STL},     {"glb", Mesh_format::GLTF}, {"gltf", Mesh_format::GLTF},
    {"3mf", Mesh_format::THREE_MF}};
  return formats;
}

std::string endings_of_meshes()
{
  std::vector<std::string> endings;
  for (const auto& format : mesh_formats())
    endings.push_back(format.first);
  return list_of_endings(endings);
}

Mesh_format mesh_format(const std::string& file)
{
  if (file == standard_input)
    throw Input_error(file, "the format of standard input is not known: --input-format");
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    throw Input_error(file, "is a folder; its meshes are named as " +
                              (fs::path(file) / "*.off").string());
  const std::string ending = ending_of(without_gz(file).string());
  for (const auto& [name, format] : mesh_formats())
    if (name == ending)
      return format;
  throw Input_error(file, "unknown extension " + in_quotes(ending.empty() ? "" : "." + ending) +
                            ", not " + endings_of_meshes());
}

std::string stem_of_input(const std::string& file)
{
  return file == standard_input ? "stdin" : without_gz(file).stem().string();
}

Input_mesh parse_mesh(const std::string& file, Mesh_format format, std::string_view bytes)
{
  const auto read = format == Mesh_format::OFF    ? read_off
                    : format == Mesh_format::OBJ  ? read_obj
                    : format == Mesh_format::PLY  ? read_ply
                    : format == Mesh_format::STL  ? read_stl
                    : format == Mesh_format::GLTF ? read_gltf
                                                  : read_3mf;
  Input_mesh input = read(file, bytes);
  if (input.soup.polygons.empty())
    throw Input_error(file,
                      input.soup.points.empty()
                        ? "no faces"
                        : "points, but no faces: a cloud, lines or strips are to be meshed first");
  input.properties.colors.finish(input.soup);
  input.properties.texture.finish(input.soup);
  if (format == Mesh_format::STL || format == Mesh_format::GLTF || format == Mesh_format::THREE_MF)
    merge_equal_points(input.soup);
  return input;
}

} // namespace segment_mesh
