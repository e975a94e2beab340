// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace mesh_to_step {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Face_errors& e)
{
  return {{"vertices", e.of_vertices}, {"face", e.of_surface}, {"edges", e.of_edges}};
}

template <typename Vector>
Json json_of_coordinates(const Vector& v)
{
  return {v.x(), v.y(), v.z()};
}

/// The parameters that a surface of its kind has.
void add_surface(Json& face, const Fitted_surface& s)
{
  using Kind = RS::Surface_kind;
  if (s.kind == Kind::FREEFORM)
    return;
  face["point"] = json_of_coordinates(s.point);
  if (s.kind != Kind::SPHERE)
    face["direction"] = json_of_coordinates(s.direction);
  if (s.kind != Kind::PLANE)
    face["radius"] = s.radius;
  if (s.kind == Kind::CONE)
    face["angle"] = s.angle;
  if (s.kind == Kind::TORUS)
    face["minor_radius"] = s.minor_radius;
}

/// Whether a face that borders on no other one is the bottom of a hole, which is the wall and the
/// other walls and steps that it leads to along the axis.
bool is_blind(const Part_faces& faces, std::size_t wall)
{
  std::vector<std::size_t> walk{wall};
  for (std::size_t i = 0; i < walk.size(); ++i)
    for (const auto& neighbor : faces[walk[i]].neighbors) {
      const auto& face = faces[neighbor.face];
      if (face.neighbors.size() == 1)
        return true;
      const bool leads_on = face.role == RS::Face_role::HOLE &&
                            (face.surface.kind == RS::Surface_kind::PLANE ||
                             face.first_on_axis == faces[wall].first_on_axis);
      if (leads_on && std::find(walk.begin(), walk.end(), neighbor.face) == walk.end())
        walk.push_back(neighbor.face);
    }
  return false;
}

/// The cylinders that are walls of holes; those of one number `axis` have a common axis.
Json holes(const Part_faces& faces)
{
  Json result = Json::array();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Fitted_surface& s = faces[i].surface;
    if (faces[i].role == RS::Face_role::HOLE && s.kind == RS::Surface_kind::CYLINDER)
      result.push_back({{"face", face_name(faces, i)},
                        {"diameter", 2 * s.radius},
                        {"depth", s.highest - s.lowest},
                        {"is_blind", is_blind(faces, i)},
                        {"axis", faces[i].first_on_axis}});
  }
  return result;
}

/// The faces that round edges and corners, with their radii.
Json fillets(const Part_faces& faces)
{
  Json result = Json::array();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Fitted_surface& s = faces[i].surface;
    const double radius = s.kind == RS::Surface_kind::TORUS ? s.minor_radius : s.radius;
    if (faces[i].role == RS::Face_role::BLEND && radius > 0)
      result.push_back({{"face", face_name(faces, i)}, {"radius", radius}});
  }
  return result;
}

} // namespace

std::string face_name(const Part_faces& faces, std::size_t face)
{
  const char* const kinds[] = {"plane", "cylinder", "cone", "sphere", "torus", "freeform"};
  return kinds[int(faces[face].surface.kind)] + ("_" + std::to_string(face));
}

std::string report(const Part_faces& faces, const Design_log& log, const Solid& solid,
                   const Certificate& certificate, bool is_right)
{
  Json result{{"is_right", is_right},
              {"solids", certificate.number_of_solids},
              {"volume", certificate.volume},
              {"area", certificate.area},
              {"gap", certificate.gap}};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Json face{{"name", face_name(faces, i)}};
    if (!certificate.faces.empty())
      face["errors"] = json_of(certificate.faces[i]);
    add_surface(face, faces[i].surface);
    if (!log.as_found.empty())
      add_surface(face["as_found"], log.as_found[i]);
    face["is_facets"] = solid.faces_as_facets.count(i) > 0;
    result["faces"].push_back(face);
  }
  result["relations"] = Json::array();
  for (const auto& [name, first, second] : log.relations)
    result["relations"].push_back(
      {{"relation", name}, {"faces", {face_name(faces, first), face_name(faces, second)}}});
  result["holes"] = holes(faces);
  result["fillets"] = fillets(faces);
  return result.dump(1) + '\n';
}

} // namespace mesh_to_step
