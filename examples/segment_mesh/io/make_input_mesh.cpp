// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Face_matching.h"
#include "io/Text_scanner.h"
#include "io/errors.h"
#include "io/read_mesh.h"
#include "io/repair_soup.h"
#include "soup/link_corners.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace segment_mesh {

namespace {

/// Leaves out the points that no face uses, if there are any; the others keep their order. Fills
/// `point_of_mesh_point`.
void take_used_points(Input_mesh& input)
{
  const Polygon_soup& soup = input.soup;
  std::vector<char> is_used(soup.points.size());
  for (const std::size_t i : soup.polygons.corners())
    is_used[i] = true;
  const std::size_t number_of_used = std::size_t(std::count(is_used.begin(), is_used.end(), true));
  input.point_of_mesh_point.reserve(number_of_used);
  for (std::size_t i = 0; i < is_used.size(); ++i)
    if (is_used[i])
      input.point_of_mesh_point.push_back(i);
  if (number_of_used == soup.points.size())
    return;
  Polygon_soup& used = input.other_soup.emplace();
  std::vector<std::size_t> new_index(soup.points.size());
  for (std::size_t i : input.point_of_mesh_point) {
    new_index[i] = used.points.size();
    used.points.push_back(soup.points[i]);
  }
  used.polygons = soup.polygons;
  used.polygons.renumber([&](std::size_t i) { return new_index[i]; });
}

void repair(const std::string& name, Input_mesh& input)
{
  Polygon_soup& repaired = input.other_soup.emplace(input.soup);
  const Repair repair = repair_soup(repaired);
  if (repaired.polygons.empty())
    throw Input_error(name, "no faces are left of " + counted(input.soup.polygons.size(), "face") +
                              " after repair");
  std::optional<Corner_links> links = link_corners(repaired);
  if (!links)
    throw Input_error(name, "is not an oriented 2-manifold, and cannot be repaired");
  input.links = std::move(*links);
  Face_matching matching = match_faces(input.soup, repaired);
  input.mesh_face_of_face = std::move(matching.mesh_face_of_face);
  input.point_of_mesh_point = std::move(matching.point_of_mesh_point);
  input.remarks.push_back(one_line(name + ": not an oriented 2-manifold, repaired: " +
                                   counted(matching.number_of_dropped_faces, "face") +
                                   " dropped, " + std::to_string(repair.turned_faces) +
                                   " turned, " + counted(repair.merged_points, "point") +
                                   " merged, " + std::to_string(repair.split_points) + " added"));
}

} // namespace

Input_mesh make_input_mesh(const std::string& name, Polygon_soup soup)
{
  Input_mesh input;
  input.soup = std::move(soup);
  std::optional<Corner_links> links = link_corners(input.soup);
  if (!links) {
    repair(name, input);
    return input;
  }
  input.links = std::move(*links);
  take_used_points(input);
  input.mesh_face_of_face.resize(input.soup.polygons.size());
  std::iota(input.mesh_face_of_face.begin(), input.mesh_face_of_face.end(), std::size_t(0));
  return input;
}

} // namespace segment_mesh
