// SPDX-License-Identifier: GPL-3.0-or-later

#include "report.h"

#include <nlohmann/json.hpp>

namespace mesh_to_step {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Face_errors& e)
{
  return {{"vertices", e.of_vertices}, {"face", e.of_surface}, {"edges", e.of_edges}};
}

} // namespace

std::string face_name(const Part_faces& faces, std::size_t face)
{
  const char* const kinds[] = {"plane", "cylinder", "cone", "sphere", "torus", "freeform"};
  return kinds[int(faces[face].surface.kind)] + ("_" + std::to_string(face));
}

std::string report(const Part_faces& faces, const Solid& solid, const Certificate& certificate,
                   bool is_right)
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
    face["is_facets"] = solid.faces_as_facets.count(i) > 0;
    result["faces"].push_back(face);
  }
  return result.dump(1) + '\n';
}

} // namespace mesh_to_step
