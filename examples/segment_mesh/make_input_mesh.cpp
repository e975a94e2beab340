// SPDX-License-Identifier: GPL-3.0-or-later

#include "Face_matching.h"
#include "Text_scanner.h"
#include "errors.h"
#include "is_oriented_manifold.h"
#include "read_mesh.h"
#include "repair_soup.h"

#include <numeric>

namespace segment_mesh {

namespace {

constexpr std::size_t none = std::size_t(-1);

/// Leaves out the points that no face uses; the others keep their order. Fills
/// `point_of_mesh_point`.
void take_used_points(const Polygon_soup& soup, Input_mesh& input)
{
  std::vector<std::size_t> new_index(soup.points.size(), none);
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    for (std::size_t i : polygon)
      new_index[i] = 0;
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    if (new_index[i] == none)
      continue;
    new_index[i] = input.mesh_soup.points.size();
    input.mesh_soup.points.push_back(soup.points[i]);
    input.point_of_mesh_point.push_back(i);
  }
  input.mesh_soup.polygons = soup.polygons;
  for (Polygon_soup::Polygon& polygon : input.mesh_soup.polygons)
    for (std::size_t& i : polygon)
      i = new_index[i];
}

void repair(const std::string& name, Input_mesh& input)
{
  input.mesh_soup = input.soup;
  const Repair repair = repair_soup(input.mesh_soup);
  if (input.mesh_soup.polygons.empty())
    throw Input_error(name, "no faces are left of " + counted(input.soup.polygons.size(), "face") +
                              " after repair");
  if (!is_oriented_manifold(input.mesh_soup))
    throw Input_error(name, "is not an oriented 2-manifold, and cannot be repaired");
  Face_matching matching = match_faces(input.soup, input.mesh_soup);
  input.mesh_face_of_face = std::move(matching.mesh_face_of_face);
  input.point_of_mesh_point = std::move(matching.point_of_mesh_point);
  input.remarks.push_back(one_line(name + ": not an oriented 2-manifold, repaired: " +
                                   counted(matching.number_of_dropped_faces, "face") +
                                   " dropped, " + std::to_string(repair.turned_faces) +
                                   " turned, " + counted(repair.split_points, "point") + " added"));
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
  take_used_points(input.soup, input);
  input.mesh_face_of_face.resize(input.soup.polygons.size());
  std::iota(input.mesh_face_of_face.begin(), input.mesh_face_of_face.end(), std::size_t(0));
  return input;
}

} // namespace segment_mesh
