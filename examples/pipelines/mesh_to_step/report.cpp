// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include "holes.h"
#include "step_text.h"

#include <nlohmann/json.hpp>

#include <map>
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

Json json_of(const Relation_of_faces& r, const Part_faces& faces)
{
  Json result{{"relation", r.name}, {"faces", {face_name(faces, r.first)}}};
  if (r.second != r.first)
    result["faces"].push_back(face_name(faces, r.second));
  if (r.is_round_number())
    result.update({{"from", r.from}, {"to", r.to}});
  return result;
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

std::string hole_name(std::size_t hole)
{
  return "hole_" + std::to_string(hole);
}

/// Holes of one number `axis` have a common axis.
Json json_of(const Hole& hole, const Part_faces& faces)
{
  const auto& wall = faces[hole.walls.front()];
  Json result{{"diameter", hole.diameter},
              {"depth", hole.depth},
              {"is_blind", hole.is_blind},
              {"axis", wall.first_on_axis},
              {"point", json_of_coordinates(wall.surface.point)},
              {"direction", json_of_coordinates(wall.surface.direction)}};
  for (const std::size_t face : hole.walls)
    result["faces"].push_back(face_name(faces, face));
  for (const auto& [diameter, depth] : hole.counterbores)
    result["counterbores"].push_back({{"diameter", diameter}, {"depth", depth}});
  for (const auto& [diameter, angle] : hole.countersinks)
    result["countersinks"].push_back({{"diameter", diameter}, {"angle", angle}});
  if (hole.tip_angle)
    result["tip_angle"] = *hole.tip_angle;
  return result;
}

Json json_of(const Hole_pattern& pattern)
{
  Json result{{"pattern", pattern.center ? "circle" : "grid"}};
  if (pattern.center)
    result.update(
      {{"center", json_of_coordinates(*pattern.center)}, {"diameter", pattern.diameter}});
  else
    result.update({{"numbers", {pattern.columns, pattern.rows}},
                   {"pitches", {pattern.column_pitch, pattern.row_pitch}}});
  for (const std::size_t hole : pattern.holes)
    result["holes"].push_back(hole_name(hole));
  return result;
}

void add_holes(Json& report, const Part_faces& faces)
{
  report["holes"] = report["patterns"] = Json::array();
  const std::vector<Hole> holes = find_holes(faces);
  for (std::size_t i = 0; i < holes.size(); ++i) {
    report["holes"].push_back({{"name", hole_name(i)}});
    report["holes"].back().update(json_of(holes[i], faces));
  }
  for (const Hole_pattern& pattern : find_patterns(faces, holes))
    report["patterns"].push_back(json_of(pattern));
}

/// The faces that round edges and corners, by radius.
Json fillets(const Part_faces& faces)
{
  constexpr double equal = 1e-4;
  std::multimap<double, std::string> names;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Fitted_surface& s = faces[i].surface;
    const double radius = s.kind == RS::Surface_kind::TORUS ? s.minor_radius : s.radius;
    if (faces[i].role == RS::Face_role::BLEND && radius > 0)
      names.emplace(radius, face_name(faces, i));
  }
  Json result = Json::array();
  for (const auto& [radius, name] : names) {
    if (result.empty() || radius > (1 + equal) * double(result.back()["radius"]))
      result.push_back({{"radius", radius}});
    result.back()["faces"].push_back(name);
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
              {"volume", certificate.volume},
              {"area", certificate.area},
              {"gap", certificate.gap}};
  result["bodies"] = Json::array();
  for (const Measured_body& body : certificate.bodies)
    result["bodies"].push_back({{"name", body_name(result["bodies"].size())},
                                {"volume", body.volume},
                                {"area", body.area},
                                {"faces", body.face_names}});
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
  for (const Relation_of_faces& r : log.relations)
    result["relations"].push_back(json_of(r, faces));
  add_holes(result, faces);
  result["fillets"] = fillets(faces);
  return result.dump(1) + '\n';
}

} // namespace mesh_to_step
