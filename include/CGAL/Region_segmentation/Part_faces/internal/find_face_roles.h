// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACE_ROLES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACE_ROLES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_neighbors.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The normal of the surface of a face at a point; of a freeform one, that of a facet.
inline Double_3 normal_at(const Fitted_surface<>& s, const Double_3& point,
                          const Double_3& of_facet)
{
  return s.kind == Surface_kind::FREEFORM ? of_facet : surface_normal(s, point);
}

/// Whether the surfaces of two faces meet smoothly at an adjacency: their normals, not those of the
/// facets, are nearly equal.
inline bool meet_smoothly(const Surface& surface, std::size_t adjacency, const Fitted_surface<>& s,
                          const Fitted_surface<>& t)
{
  constexpr double least_cosine = 0.966; // 15 degrees
  const std::size_t f = surface.lower_face(adjacency), g = surface.higher_face(adjacency);
  const Double_3 middle = Shared_side(surface, f, g).middle;
  return !surface.has_flag(adjacency, Surface::LINK) &&
         dot(normal_at(s, middle, surface.normal(f)), normal_at(t, middle, surface.normal(g))) >
           least_cosine;
}

/// How much an edge runs along the path of the ball that rolls in a blend, in [0, 1]: along the
/// axis of a cylinder, around that of a torus, anywhere on a sphere or a freeform face. 0 on planes
/// and cones.
inline double alignment_with_rolling(const Fitted_surface<>& s, const Shared_side& side)
{
  switch (s.kind) {
  case Surface_kind::CYLINDER:
    return std::fabs(dot(side.along, s.direction));
  case Surface_kind::TORUS: {
    const Double_3 around = cross(s.direction, side.middle - s.point);
    return norm(around) > 0 ? std::fabs(dot(side.along, around)) / norm(around) : 0;
  }
  case Surface_kind::SPHERE:
  case Surface_kind::FREEFORM:
    return 1;
  default:
    return 0;
  }
}

/// Which faces are blends: most of their border along the path of a rolling ball is smooth.
inline std::vector<Face_role> find_blends(const Surface& surface, const Partition& faces,
                                          const std::vector<Fitted_surface<>>& surfaces)
{
  constexpr double most = 0.6;
  std::vector<double> smooth(surfaces.size(), 0), all(surfaces.size(), 0);
  for_each_border(surface, faces, [&](std::size_t a, std::size_t i, std::size_t j) {
    const Shared_side side(surface, surface.lower_face(a), surface.higher_face(a));
    const bool is_smooth = meet_smoothly(surface, a, surfaces[i], surfaces[j]);
    for (const std::size_t part : {i, j}) {
      const double length = surface.length(a) * alignment_with_rolling(surfaces[part], side);
      all[part] += length;
      smooth[part] += is_smooth ? length : 0;
    }
  });
  std::vector<Face_role> roles(surfaces.size(), Face_role::NONE);
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (smooth[i] > most * all[i])
      roles[i] = Face_role::BLEND;
  return roles;
}

/// The roles of cylinders and cones that are no blends, and of blends. A convex wall is that of a
/// boss if one of its ends, where its border runs around its axis, is a foot: a concave edge, or a
/// concave blend; and another one is not.
inline std::vector<Face_role> find_walls(const Surface& surface, const Partition& faces,
                                         const std::vector<Fitted_surface<>>& surfaces)
{
  constexpr double most_along_axis = 0.5;
  constexpr unsigned foot = 1, head = 2;
  std::vector<Face_role> roles = find_blends(surface, faces, surfaces);
  const auto is_wall = [&](std::size_t part) {
    const Surface_kind kind = surfaces[part].kind;
    return roles[part] == Face_role::NONE &&
           (kind == Surface_kind::CYLINDER || kind == Surface_kind::CONE);
  };
  std::vector<unsigned> ends(roles.size(), 0);
  for_each_border(surface, faces, [&](std::size_t a, std::size_t i, std::size_t j) {
    const bool is_concave_edge = surface.has_flag(a, Surface::CONCAVE) &&
                                 !meet_smoothly(surface, a, surfaces[i], surfaces[j]);
    const Double_3 along = Shared_side(surface, surface.lower_face(a), surface.higher_face(a))
                             .along;
    for (const auto& [part, other] : {std::pair(i, j), std::pair(j, i)})
      if (is_wall(part) && std::fabs(dot(along, surfaces[part].direction)) < most_along_axis) {
        const bool is_on_blend = roles[other] == Face_role::BLEND && surfaces[other].side < 0;
        ends[part] |= is_concave_edge || is_on_blend ? foot : head;
      }
  });
  for (std::size_t part = 0; part < roles.size(); ++part)
    if (is_wall(part))
      roles[part] = surfaces[part].side < 0       ? Face_role::HOLE
                    : ends[part] == (foot | head) ? Face_role::BOSS
                                                  : Face_role::NONE;
  return roles;
}

/// The roles of faces: those of `find_walls()`, and planes that border on the walls of holes, or of
/// bosses, alone.
inline std::vector<Face_role> find_face_roles(const Surface& surface, const Partition& faces,
                                              const std::vector<Fitted_surface<>>& surfaces)
{
  const std::vector<Face_role> walls = find_walls(surface, faces, surfaces);
  const auto bit = [](Face_role role) { return 1u << unsigned(role); };
  std::vector<unsigned> around(surfaces.size(), 0); // the bits of the roles of neighbors
  for_each_border(surface, faces, [&](std::size_t, std::size_t i, std::size_t j) {
    around[i] |= bit(walls[j]);
    around[j] |= bit(walls[i]);
  });
  std::vector<Face_role> result = walls;
  for (std::size_t i = 0; i < result.size(); ++i)
    for (const Face_role role : {Face_role::HOLE, Face_role::BOSS})
      if (surfaces[i].kind == Surface_kind::PLANE && around[i] == bit(role))
        result[i] = role;
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACE_ROLES_H
