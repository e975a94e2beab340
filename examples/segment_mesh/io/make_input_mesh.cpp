// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Face_matching.h"
#include "io/Text_scanner.h"
#include "io/errors.h"
#include "io/read_mesh.h"
#include "io/repair_soup.h"
#include "soup/is_oriented_manifold.h"

#include <numeric>

namespace segment_mesh {

namespace {

constexpr std::size_t none = std::size_t(-1);

/// Leaves out the points that no face uses, if there are any; the others keep their order. Fills
/// `point_of_mesh_point`.
void take_used_points(Input_mesh& input)
{
  const Polygon_soup& soup = input.soup;
  std::vector<std::size_t> new_index(soup.points.size(), none);
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    for (std::size_t i : polygon)
      new_index[i] = 0;
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    if (new_index[i] == none)
      continue;
    new_index[i] = input.point_of_mesh_point.size();
    input.point_of_mesh_point.push_back(i);
  }
  if (input.point_of_mesh_point.size() == soup.points.size())
    return;
  Polygon_soup& used = input.other_soup.emplace();
  for (std::size_t i : input.point_of_mesh_point)
    used.points.push_back(soup.points[i]);
  used.polygons = soup.polygons;
  for (Polygon_soup::Polygon& polygon : used.polygons)
    for (std::size_t& i : polygon)
      i = new_index[i];
}

void repair(const std::string& name, Input_mesh& input)
{
  Polygon_soup& repaired = input.other_soup.emplace(input.soup);
  const Repair repair = repair_soup(repaired);
  if (repaired.polygons.empty())
    throw Input_error(name, "no faces are left of " + counted(input.soup.polygons.size(), "face") +
                              " after repair");
  if (!is_oriented_manifold(repaired))
    throw Input_error(name, "is not an oriented 2-manifold, and cannot be repaired");
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
  if (!is_oriented_manifold(input.soup)) {
    repair(name, input);
    return input;
  }
  take_used_points(input);
  input.mesh_face_of_face.resize(input.soup.polygons.size());
  std::iota(input.mesh_face_of_face.begin(), input.mesh_face_of_face.end(), std::size_t(0));
  return input;
}

} // namespace segment_mesh
