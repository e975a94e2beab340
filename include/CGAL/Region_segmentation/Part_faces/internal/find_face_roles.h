// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACE_ROLES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACE_ROLES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <cmath>
#include <cstddef>
#include <set>
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

/// Calls `f(adjacency, v, w)` for the adjacencies across edges and seams, with the side from vertex
/// v to w of their lower faces.
template <typename F>
void for_each_shared_side(const Surface& surface, const F& f)
{
  for_each_side_of_surface(
    surface, [&](Surface::Index face, Surface::Index v, Surface::Index w, Surface::Index a) {
      if (a != Surface::none && surface.lower_face(a) == face)
        f(a, v, w);
    });
}

/// Whether the surfaces of two faces meet smoothly at a point of an adjacency: their normals, not
/// those of the facets, are nearly equal.
inline bool meet_smoothly(const Surface& surface, std::size_t adjacency, const Double_3& point,
                          const Fitted_surface<>& s, const Fitted_surface<>& t)
{
  constexpr double least_cosine = 0.966; // 15 degrees
  return dot(normal_at(s, point, surface.normal(surface.lower_face(adjacency))),
             normal_at(t, point, surface.normal(surface.higher_face(adjacency)))) > least_cosine;
}

/// A side of a face of the mesh at which two faces of a part meet.
struct Shared_side
{
  Surface::Index faces[2]; ///< of the part
  double length;
  Double_3 middle, along; ///< `along`: of length 1
  bool is_concave;        ///< by the facets
  bool is_smooth;         ///< their surfaces meet smoothly there
};

/// The sides between two faces that are not constrained.
inline std::vector<Shared_side> find_borders(const Surface& surface, const Partition& faces,
                                             const std::vector<Fitted_surface<>>& surfaces)
{
  std::vector<Shared_side> result;
  for_each_shared_side(surface, [&](Surface::Index a, Surface::Index v, Surface::Index w) {
    const Surface::Index i = faces[surface.lower_face(a)], j = faces[surface.higher_face(a)];
    if (i == j || surface.has_flag(a, Surface::CONSTRAINED))
      return;
    const Double_3 p = surface.point(v), d = surface.point(w) - p, middle = p + 0.5 * d;
    const double length = norm(d);
    result.push_back({{i, j},
                      surface.length(a),
                      middle,
                      length > 0 ? (1 / length) * d : d,
                      surface.has_flag(a, Surface::CONCAVE),
                      meet_smoothly(surface, a, middle, surfaces[i], surfaces[j])});
  });
  return result;
}

/// How much an edge runs along the path of the ball that rolls in a blend, in [0, 1]: along the
/// axis of a cylinder, around that of a torus, anywhere on a sphere or a freeform face. 0 on planes
/// and cones.
inline double alignment_with_rolling(const Fitted_surface<>& s, const Shared_side& side)
{
  const Double_3 around = cross(s.direction, side.middle - s.point);
  if (s.kind == Surface_kind::CYLINDER)
    return std::fabs(dot(side.along, s.direction));
  if (s.kind == Surface_kind::TORUS && norm(around) > 0)
    return std::fabs(dot(side.along, around)) / norm(around);
  return s.kind == Surface_kind::SPHERE || s.kind == Surface_kind::FREEFORM;
}

/// Which faces are blends, of two neighbors or more: most of their border along the path of a
/// rolling ball is smooth.
inline std::vector<Face_role> find_blends(const std::vector<Shared_side>& borders,
                                          const std::vector<Fitted_surface<>>& surfaces)
{
  constexpr double most = 0.6, least_alignment = 0.5;
  std::vector<double> smooth(surfaces.size(), 0); // beyond that share of the border
  std::vector<std::set<Surface::Index>> neighbors(surfaces.size());
  for (const Shared_side& side : borders)
    for (const int k : {0, 1}) {
      const Surface::Index part = side.faces[k];
      neighbors[part].insert(side.faces[1 - k]);
      if (const double aligned = alignment_with_rolling(surfaces[part], side);
          aligned > least_alignment)
        smooth[part] += aligned * side.length * (double(side.is_smooth) - most);
    }
  std::vector<Face_role> roles(surfaces.size(), Face_role::NONE);
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (smooth[i] > 0 && neighbors[i].size() > 1)
      roles[i] = Face_role::BLEND;
  return roles;
}

/// The roles of cylinders and cones that are no blends, and of blends. A convex wall is that of a
/// boss if one of its ends, where its border runs around its axis, is a foot: a concave edge, or a
/// concave blend; and another one is not.
inline std::vector<Face_role> find_walls(const std::vector<Shared_side>& borders,
                                         const std::vector<Fitted_surface<>>& surfaces)
{
  constexpr double most_along_axis = 0.5;
  constexpr unsigned foot = 1, head = 2;
  std::vector<Face_role> roles = find_blends(borders, surfaces);
  const auto is_wall = [&](std::size_t part) {
    const Surface_kind kind = surfaces[part].kind;
    return roles[part] == Face_role::NONE &&
           (kind == Surface_kind::CYLINDER || kind == Surface_kind::CONE);
  };
  std::vector<unsigned> ends(roles.size(), 0);
  for (const Shared_side& side : borders) {
    for (const int k : {0, 1}) {
      const Surface::Index part = side.faces[k], other = side.faces[1 - k];
      if (is_wall(part) && std::fabs(dot(side.along, surfaces[part].direction)) < most_along_axis) {
        const bool is_on_blend = roles[other] == Face_role::BLEND && surfaces[other].side < 0;
        ends[part] |= is_on_blend || (side.is_concave && !side.is_smooth) ? foot : head;
      }
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
  const std::vector<Shared_side> borders = find_borders(surface, faces, surfaces);
  const std::vector<Face_role> walls = find_walls(borders, surfaces);
  const auto bit = [](Face_role role) { return 1u << unsigned(role); };
  std::vector<unsigned> around(surfaces.size(), 0); // the bits of the roles of neighbors
  for (const Shared_side& side : borders) {
    around[side.faces[0]] |= bit(walls[side.faces[1]]);
    around[side.faces[1]] |= bit(walls[side.faces[0]]);
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

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACE_ROLES_H
