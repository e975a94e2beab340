// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_FACE_ROLES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_FACE_ROLES_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segments/Fitted_surface.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The side that two faces share, from one vertex to another; of several, one of them. `along` is 0
/// if they share no vertices. Linear time in the corners of the face that has fewer.
struct Shared_side
{
  Double_3 middle{0, 0, 0}, along{0, 0, 0};

  Shared_side(const Surface& surface, std::size_t face, std::size_t other)
  {
    if (surface.number_of_corners(face) > surface.number_of_corners(other))
      std::swap(face, other);
    const std::size_t n = surface.number_of_corners(face);
    double least = none;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t p = surface.corner(face, i), q = surface.corner(face, (i + 1) % n);
      const double distance = (std::max)(this->distance(surface, p, other),
                                         this->distance(surface, q, other));
      if (distance < least) {
        least = distance;
        set(surface.point(p), surface.point(q));
      }
    }
    if (least == none)
      middle = 0.5 * (surface.centroid(face) + surface.centroid(other));
  }

private:
  static constexpr std::size_t many = 64; // corners, among which a vertex is not searched
  static constexpr double none = (std::numeric_limits<double>::max)();

  /// 0 for a vertex of a face, else none; that from its plane where the face has many corners.
  static double distance(const Surface& surface, std::size_t vertex, std::size_t face)
  {
    const std::size_t n = surface.number_of_corners(face);
    if (n > many)
      return std::fabs(
        dot(surface.normal(face), surface.point(vertex) - surface.point(surface.corner(face, 0))));
    for (std::size_t i = 0; i < n; ++i)
      if (surface.corner(face, i) == vertex)
        return 0;
    return none;
  }

  void set(const Double_3& from, const Double_3& to)
  {
    const Double_3 d = to - from;
    middle = 0.5 * (from + to);
    along = norm(d) > 0 ? (1 / norm(d)) * d : d;
  }
};

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
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const std::size_t f = surface.lower_face(a), g = surface.higher_face(a);
    if (faces[f] == faces[g] || surface.has_flag(a, Surface::LINK))
      continue;
    const Shared_side side(surface, f, g);
    const bool is_smooth = meet_smoothly(surface, a, surfaces[faces[f]], surfaces[faces[g]]);
    for (const std::size_t part : {faces[f], faces[g]}) {
      const double length = surface.length(a) * alignment_with_rolling(surfaces[part], side);
      all[part] += length;
      smooth[part] += is_smooth ? length : 0;
    }
  }
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
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const std::size_t f = surface.lower_face(a), g = surface.higher_face(a);
    if (faces[f] == faces[g] || surface.has_flag(a, Surface::LINK))
      continue;
    const bool is_concave_edge = surface.has_flag(a, Surface::CONCAVE) &&
                                 !meet_smoothly(surface, a, surfaces[faces[f]], surfaces[faces[g]]);
    const Double_3 along = Shared_side(surface, f, g).along;
    for (const auto& [part, other] : {std::pair(faces[f], faces[g]), std::pair(faces[g], faces[f])})
      if (is_wall(part) && std::fabs(dot(along, surfaces[part].direction)) < most_along_axis) {
        const bool is_on_blend = roles[other] == Face_role::BLEND && surfaces[other].side < 0;
        ends[part] |= is_concave_edge || is_on_blend ? foot : head;
      }
  }
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
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const std::size_t i = faces[surface.lower_face(a)], j = faces[surface.higher_face(a)];
    if (i == j || surface.has_flag(a, Surface::LINK))
      continue;
    around[i] |= bit(walls[j]);
    around[j] |= bit(walls[i]);
  }
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

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FIND_FACE_ROLES_H
