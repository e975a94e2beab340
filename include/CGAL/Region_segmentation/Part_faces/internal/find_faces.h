// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_curved_faces.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_face_roles.h>
#include <CGAL/Region_segmentation/Part_faces/internal/surface_evidence.h>
#include <CGAL/Region_segmentation/Part_faces/internal/vertex_error.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// By label: whether it is of a curved surface.
inline std::vector<std::uint8_t> curved_labels(const Face_search& search)
{
  std::vector<std::uint8_t> result;
  for (const Fitted_surface<>& s : search.surfaces)
    result.push_back(s.kind != Surface_kind::PLANE);
  return result;
}

/// By label: whether it is of a curved surface, and no vertex is inside its face.
inline std::vector<std::uint8_t> single_rows(const Face_search& search)
{
  using Index = Surface::Index;
  const Surface& surface = search.surface;
  std::vector<Index> last(surface.number_of_vertices(), Face_search::none); // label of a face
  std::vector<std::uint8_t> is_border(surface.number_of_vertices(), 0);
  std::vector<std::uint8_t> is_used(surface.number_of_vertices(), 0);
  for (Index f = 0; f < search.labels.size(); ++f)
    for (const Index v : surface.corners(f)) {
      is_border[v] |= is_used[v] && last[v] != search.labels[f];
      is_used[v] = 1;
      last[v] = search.labels[f];
    }
  std::vector<std::uint8_t> result = curved_labels(search);
  for (Index v = 0; v < last.size(); ++v)
    if (!is_border[v] && last[v] != Face_search::none)
      result[last[v]] = 0;
  return result;
}

/// The curvature of a surface of revolution at a point of it, along a direction of length 1 that is
/// tangent to it there; positive where it bends away from the normal of the faces.
inline double curvature_along(const Fitted_surface<>& s, const Double_3& p,
                              const Double_3& direction)
{
  const Meridian_point m = meridian_point(s, p);
  const Profile f = Surface_distance(s).profile(m.r, m.z);
  const double of_parallel = m.r > 0 ? f.by_r / m.r : 0,
               of_meridian = s.kind == Surface_kind::SPHERE  ? 1 / s.radius
                             : s.kind == Surface_kind::TORUS ? 1 / s.minor_radius
                                                             : 0;
  const double c = dot(direction, cross(s.direction, m.outward));
  return s.side * (c * c * of_parallel + (1 - c * c) * of_meridian);
}

/// Whether two curved surfaces have nearly the same curvature across the side from vertex v to w,
/// as two that osculate one freeform face have.
inline bool have_equal_curvature(const Surface& surface, const Fitted_surface<>& s,
                                 const Fitted_surface<>& t, Surface::Index v, Surface::Index w)
{
  constexpr double most = 0.3; // relative difference
  const Double_3 p = surface.point(v), side = surface.point(w) - p, middle = p + 0.5 * side,
                 across = cross(surface_normal(s, middle), side);
  const double length = norm(across);
  if (!(length > 0))
    return true;
  const double a = curvature_along(s, middle, (1 / length) * across),
               b = curvature_along(t, middle, (1 / length) * across);
  return std::fabs(a - b) <= most * (std::max)(std::fabs(a), std::fabs(b));
}

/// Which labels of `among` only osculate a freeform face, as .4 of their border tells: it goes on
/// smoothly to others of `among` of nearly the same curvature; or to facets that are not found and
/// not much larger, which leave the surface little by little, or are beside a single row of facets.
inline std::vector<std::uint8_t> osculating_labels(const Face_search& search,
                                                   const std::vector<std::uint8_t>& among)
{
  using Index = Surface::Index;
  constexpr double most = 0.4, much_larger = 8;
  const Tessellation& mesh = search.mesh;
  const std::vector<std::uint8_t> rows = single_rows(search);
  const auto goes_on = [&](Index f, Index g, Index v, Index w) {
    const Index label = search.labels[f];
    const Fitted_surface<>& s = search.surfaces[label];
    if (!mesh.is_smooth(f, g))
      return false;
    if (search.is_found(g))
      return among[search.labels[g]] &&
             have_equal_curvature(search.surface, s, search.surfaces[search.labels[g]], v, w);
    return !search.is_sure_plane(g) &&
           mesh.facet(mesh.facet_of(g)).area <= much_larger * mesh.facet(mesh.facet_of(f)).area &&
           (rows[label] || departs_gradually(mesh, s, g, v, w));
  };
  std::vector<double> share(among.size(), 0), all(among.size(), 0);
  for (Index f = 0; f < search.labels.size(); ++f)
    if (const Index label = search.labels[f]; search.is_found(f) && among[label])
      for_each_neighbor(search.surface, f, [&](Index g, Index v, Index w) {
        if (search.labels[g] == label)
          return;
        const double length = norm(search.surface.point(w) - search.surface.point(v));
        all[label] += length;
        share[label] += goes_on(f, g, v, w) ? length : 0;
      });
  std::vector<std::uint8_t> result(among.size());
  for (std::size_t label = 0; label < result.size(); ++label)
    result[label] = among[label] && share[label] > most * all[label];
  return result;
}

/// Drops curved surfaces that only osculate a freeform face, between others that do.
inline void drop_osculating_surfaces(Face_search& search)
{
  for (bool some = true; some;) {
    const std::vector<std::uint8_t> dropped = osculating_labels(
      search, osculating_labels(search, curved_labels(search)));
    some = false;
    for (Surface::Index f = 0; f < search.labels.size(); ++f)
      if (search.is_found(f) && dropped[search.labels[f]]) {
        search.labels[f] = Face_search::none;
        search.is_freeform[search.mesh.facet_of(f)] = 1;
        some = true;
      }
  }
}

/// Faces that are not found, in facets of which others are, go to the neighbor from whose surface
/// they deviate least, if they lie on it.
inline void join_rests_of_facets(Face_search& search)
{
  using Index = Surface::Index;
  constexpr double angle = 0.927; // 53 degrees, as long triangles across a fillet may have it
  const Tessellation& mesh = search.mesh;
  const auto is_rest = [&](Index f) {
    const auto faces = mesh.faces_of_facet(mesh.facet_of(f));
    return std::any_of(faces.begin(), faces.end(), [&](Index g) { return search.is_found(g); });
  };
  std::vector<std::pair<Index, Index>> joined; // faces and their labels
  do {
    joined.clear();
    for (Index f = 0; f < search.labels.size(); ++f) {
      if (search.is_found(f) || !is_rest(f))
        continue;
      double least = std::numeric_limits<double>::infinity();
      Index best = Face_search::none;
      for_each_neighbor(search.surface, f, [&](Index g, Index, Index) {
        if (!search.is_found(g))
          return;
        const Fitted_surface<>& s = search.surfaces[search.labels[g]];
        if (!has_vertices_on(mesh, s, f) || !has_normal_of(mesh, s, f, angle))
          return;
        const double deviation = deviation_of_face(search.surface, s, f);
        if (deviation < least) {
          least = deviation;
          best = search.labels[g];
        }
      });
      if (best != Face_search::none)
        joined.push_back({f, best});
    }
    for (const auto& [face, label] : joined)
      search.labels[face] = label;
  } while (!joined.empty());
}

/// The angle between neighboring facets of a freeform face is below 20 degrees.
inline constexpr double most_angle_of_freeform = 0.35;

/// Whether a facet goes on, as those of a freeform face do, to others that are not found and not
/// much smaller, at most of a tenth of its border.
inline bool stands_alone(const Face_search& search, Surface::Index facet)
{
  using Index = Surface::Index;
  constexpr double least_area = 0.2, most = 0.1;
  const Tessellation& mesh = search.mesh;
  double smooth = 0, all = 0;
  for (const Index f : mesh.faces_of_facet(facet))
    for_each_neighbor(search.surface, f, [&](Index g, Index v, Index w) {
      const Index other = mesh.facet_of(g);
      if (other == facet)
        return;
      const double length = norm(search.surface.point(w) - search.surface.point(v));
      all += length;
      if (!search.is_found(g) && mesh.has_normal(f) && mesh.has_normal(g) &&
          mesh.meet_within(most_angle_of_freeform, f, g) &&
          mesh.facet(other).area > least_area * mesh.facet(facet).area)
        smooth += length;
    });
  return smooth <= most * all;
}

/// The facets that are not found and go on smoothly from one of them, over those that `is_left`.
template <typename IsLeft>
std::vector<Surface::Index> smooth_facets_around(const Face_search& search, Surface::Index facet,
                                                 std::vector<std::uint8_t>& is_reached,
                                                 const IsLeft& is_left)
{
  using Index = Surface::Index;
  const Tessellation& mesh = search.mesh;
  std::vector<Index> result{facet};
  is_reached[facet] = 1;
  for (std::size_t next = 0; next < result.size(); ++next)
    for (const Index f : mesh.faces_of_facet(result[next]))
      if (is_left(f) && mesh.has_normal(f))
        for_each_neighbor(search.surface, f, [&](Index g, Index, Index) {
          const Index other = mesh.facet_of(g);
          if (is_left(g) && !is_reached[other] && mesh.has_normal(g) &&
              mesh.meet_within(most_angle_of_freeform, f, g)) {
            is_reached[other] = 1;
            result.push_back(other);
          }
        });
  return result;
}

/// Which facets are planes of the part, of those that no curved face has: those of four and more
/// vertices that do not go on to others. Of the rest, what goes on smoothly is freeform, unless it
/// is of few facets.
inline std::vector<std::uint8_t> find_planes(const Face_search& search)
{
  using Index = Surface::Index;
  constexpr std::size_t fewest_vertices = 4, few_facets = 2;
  const Tessellation& mesh = search.mesh;
  std::vector<std::uint8_t> result(mesh.number_of_facets());
  for (Index i = 0; i < result.size(); ++i)
    result[i] = !search.is_freeform[i] && mesh.facet(i).number_of_vertices >= fewest_vertices &&
                stands_alone(search, i);
  const std::vector<std::uint8_t> alone = result;
  const auto is_left = [&](Index f) { return !search.is_found(f) && !alone[mesh.facet_of(f)]; };
  std::vector<std::uint8_t> is_reached(result.size(), 0);
  for (Index i = 0; i < result.size(); ++i) {
    if (is_reached[i] || alone[i])
      continue;
    const std::vector<Index> facets = smooth_facets_around(search, i, is_reached, is_left);
    const bool is_freeform = std::any_of(facets.begin(), facets.end(),
                                         [&](Index j) { return search.is_freeform[j] != 0; });
    if (facets.size() <= few_facets && !is_freeform)
      for (const Index j : facets)
        result[j] = 1;
  }
  return result;
}

/// Adds the facets that no curved face has and that are planes of the part.
inline void add_planes(Face_search& search)
{
  const std::vector<std::uint8_t> is_plane = find_planes(search);
  std::vector<Surface::Index> faces;
  for (std::size_t i = 0; i < is_plane.size(); ++i) {
    faces.clear();
    bool has_normal = false; // slivers alone are no plane
    if (is_plane[i])
      for (const Surface::Index f : search.mesh.faces_of_facet(i))
        if (!search.is_found(f)) {
          faces.push_back(f);
          has_normal = has_normal || search.mesh.has_normal(f);
        }
    if (has_normal)
      search.add(search.mesh.facet(i).plane, faces);
  }
}

/// The label of the surface, of those of a face and its neighbors, from which the face deviates
/// least.
inline Surface::Index nearest_label(const Face_search& search, Surface::Index face)
{
  using Index = Surface::Index;
  const Tessellation& mesh = search.mesh;
  const Index own = search.labels[face];
  const auto deviation = [&](Index label) {
    return deviation_of_face(search.surface, search.surfaces[label], face);
  };
  Index best = own;
  double least = std::numeric_limits<double>::infinity();
  bool is_inside = true;
  for_each_neighbor(search.surface, face,
                    [&](Index g, Index, Index) { is_inside &= search.labels[g] == own; });
  if (is_inside)
    return own;
  if (own != Face_search::none && has_vertices_on(mesh, search.surfaces[own], face))
    least = deviation(own);
  for_each_neighbor(search.surface, face, [&](Index g, Index, Index) {
    const Index label = search.labels[g];
    if (label == Face_search::none || label == own || label == best ||
        !has_vertices_on(mesh, search.surfaces[label], face) ||
        !has_normal_of(mesh, search.surfaces[label], face))
      return;
    if (const double d = deviation(label); d < 0.9 * least - 0.1 * mesh.sigma) {
      least = d;
      best = label;
    }
  });
  return best;
}

/// Faces at borders go to the neighboring surface from which they deviate least.
inline void compete_at_borders(Face_search& search)
{
  constexpr int rounds = 4;
  bool is_changed = true;
  for (int round = 0; round < rounds && is_changed; ++round) {
    is_changed = false;
    for (Surface::Index f = 0; f < search.labels.size(); ++f) {
      const Surface::Index best = nearest_label(search, f);
      is_changed = is_changed || best != search.labels[f];
      search.labels[f] = best;
    }
  }
}

/// The pairs of labels of faces that meet smoothly, each once, in order.
inline std::vector<std::pair<Surface::Index, Surface::Index>>
smooth_neighbors(const Face_search& search)
{
  using Index = Surface::Index;
  std::vector<std::pair<Index, Index>> pairs;
  for (Index f = 0; f < search.labels.size(); ++f)
    for_each_neighbor(search.surface, f, [&](Index g, Index, Index) {
      const Index i = search.labels[f], j = search.labels[g];
      if (i != Face_search::none && j != Face_search::none && i < j && search.mesh.is_smooth(f, g))
        pairs.push_back({i, j});
    });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Merges neighbors of which all vertices are on one surface: that of the larger one, or one that
/// is fitted to both.
class Equal_surfaces
{
public:
  using Index = Surface::Index;

  explicit Equal_surfaces(Face_search& search)
    : m_search(search)
    , m_mesh(search.mesh)
    , m_faces(search.surfaces.size())
    , m_now(search.surfaces.size())
    , m_points(search.surface)
  {
    std::iota(m_now.begin(), m_now.end(), Index(0));
    for (Index f = 0; f < search.labels.size(); ++f)
      if (search.is_found(f))
        m_faces[search.labels[f]].push_back(f);
  }

  void merge()
  {
    for (const auto& pair : smooth_neighbors(m_search)) {
      Index i = root_in_forest(m_now, pair.first), j = root_in_forest(m_now, pair.second);
      if (i == j)
        continue;
      if (m_faces[i].size() < m_faces[j].size())
        std::swap(i, j);
      if (can_merge(i, j)) {
        m_now[j] = i;
        m_faces[i].insert(m_faces[i].end(), m_faces[j].begin(), m_faces[j].end());
        m_faces[j].clear();
      }
    }
    for (Index& label : m_search.labels)
      if (label != Face_search::none)
        label = root_in_forest(m_now, label);
  }

private:
  /// Whether the faces of label j lie on a surface of the kind of label i with those of i, which
  /// then is the surface of i.
  bool can_merge(Index i, Index j)
  {
    constexpr std::size_t many_vertices = 6;
    const Surface_kind kind = m_search.surfaces[i].kind, other = m_search.surfaces[j].kind;
    if (kind == Surface_kind::PLANE && other != Surface_kind::PLANE)
      return false;
    if (other == Surface_kind::PLANE && kind != Surface_kind::PLANE &&
        m_mesh.facet(m_mesh.facet_of(m_faces[j][0])).number_of_vertices >= many_vertices)
      return false;
    Fitted_surface<> s = m_search.surfaces[i];
    if (!has_all(s, j)) {
      m_points.clear();
      for (const Index label : {i, j})
        for (const Index f : m_faces[label])
          m_points.add(f);
      const std::vector<Double_3> sample = evenly_spread(m_points.points(), most_fitted_points);
      if (!std::isfinite(Surface_fitter(sample, m_mesh.good_fit())(s, 8)) || !has_all(s, i) ||
          !has_all(s, j))
        return false;
    }
    if (is_flat_beside(s, i, j))
      return false;
    m_search.surfaces[i] = s;
    return true;
  }

  bool has_all(const Fitted_surface<>& s, Index label) const
  {
    return std::all_of(m_faces[label].begin(), m_faces[label].end(), [&](Index f) {
      return has_vertices_on(m_mesh, s, f) && has_normal_of(m_mesh, s, f);
    });
  }

  /// Whether a facet of label j deviates much more from a surface than those of label i.
  bool is_flat_beside(const Fitted_surface<>& s, Index i, Index j) const
  {
    constexpr double much = 1.5;
    const auto largest = [&](Index label) {
      double result = 0;
      for (const Index f : m_faces[label])
        result = (std::max)(result, deviation_of_facet(m_mesh, s, f));
      return result;
    };
    return largest(j) > (std::max)(much * largest(i), m_mesh.tolerance());
  }

  Face_search& m_search;
  const Tessellation& m_mesh;
  std::vector<std::vector<Index>> m_faces; // by label
  std::vector<Index> m_now;                // the labels that labels become
  Face_set m_points;
};

/// Gives faces without normals beside faces of other labels alone that of those on whose surface
/// their vertices lie best.
inline void label_thin_faces(Face_search& search)
{
  using Index = Surface::Index;
  constexpr int rounds = 8;
  bool is_changed = true;
  for (int round = 0; round < rounds && is_changed; ++round) {
    is_changed = false;
    for (Index f = 0; f < search.labels.size(); ++f) {
      if (search.mesh.has_normal(f))
        continue;
      bool is_alone = true;
      double least = std::numeric_limits<double>::infinity();
      Index best = search.labels[f];
      for_each_neighbor(search.surface, f, [&](Index g, Index, Index) {
        const Index label = search.labels[g];
        is_alone = is_alone && !(search.is_found(f) && label == search.labels[f]);
        if (label == Face_search::none)
          return;
        const Surface_distance distance(search.surfaces[label]);
        double largest = 0;
        for (const Index v : search.surface.corners(f))
          largest = (std::max)(largest, std::fabs(distance(search.surface.point(v))));
        if (largest < least - 0.1 * search.mesh.sigma) {
          least = largest;
          best = label;
        }
      });
      if (is_alone && best != search.labels[f]) {
        search.labels[f] = best;
        is_changed = true;
      }
    }
  }
}

/// Makes each connected component of a label a face of its own, and those of what was not found
/// freeform faces, which end where the mesh does not go on smoothly.
inline void separate_components(Face_search& search, const Execution& execution)
{
  const Surface& surface = search.surface;
  const Partition components = label_components(
    surface,
    [&](std::size_t a) {
      const Surface::Index f = surface.lower_face(a), g = surface.higher_face(a),
                           label = search.labels[f];
      return label == search.labels[g] && !surface.has_flag(a, Surface::barrier) &&
             (label != Face_search::none || search.mesh.is_smooth(f, g));
    },
    execution);
  std::vector<Fitted_surface<>> surfaces(components.number_of_parts());
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    if (search.is_found(f))
      surfaces[components[f]] = search.surfaces[search.labels[f]];
  search.labels.assign(components.begin(), components.end());
  search.surfaces = std::move(surfaces);
}

/// The label of each face of the mesh, see `find_surface_faces()`.
inline void find_labels(Face_search& search, const Execution& execution)
{
  find_curved_faces(search, execution.step(0, 0.8));
  Equal_surfaces(search).merge();
  drop_osculating_surfaces(search);
  join_rests_of_facets(search);
  add_planes(search);
  compete_at_borders(search);
  label_thin_faces(search);
  Equal_surfaces(search).merge();
  separate_components(search, execution.step(0.8, 1));
}

/// Fits the surface of each face of the part to all its vertices. Faces of the mesh that are not on
/// it, as those that cross a crease, do not count.
inline void fit_surfaces(const Tessellation& mesh, Surface_faces& faces)
{
  const Grouped_items<Surface::Index> by_part(faces.surfaces.size(), [&](const auto& add) {
    for (Surface::Index f = 0; f < faces.partition.size(); ++f)
      add(faces.partition[f], f);
  });
  Face_set members(mesh.surface);
  for (std::size_t part = 0; part < faces.surfaces.size(); ++part) {
    Fitted_surface<>& s = faces.surfaces[part];
    if (s.kind == Surface_kind::FREEFORM)
      continue;
    members.clear();
    for (const Surface::Index f : by_part[part])
      if (has_vertices_on(mesh, s, f))
        members.add(f);
    const std::vector<Double_3> sample = evenly_spread(members.points(), most_fitted_points);
    Fitted_surface<> fitted = s;
    if (int(sample.size()) > degrees_of_freedom(s.kind) &&
        std::isfinite(Surface_fitter(sample, 0)(fitted, 8)) &&
        largest_distance(fitted, members.points()) <= mesh.tolerance())
      s = fitted;
    measure(s, members.points());
  }
}

/// See `find_surface_faces()`. `tolerance`: in units of the surface
inline Surface_faces find_faces(const Surface& surface, double tolerance,
                                const Execution& execution)
{
  const Tessellation mesh(surface, tolerance > 0 ? tolerance / Tessellation::interval
                                                 : vertex_error(surface));
  Face_search search(mesh);
  find_labels(search, execution);
  Surface_faces result;
  result.partition = Partition::from_labels(search.labels);
  result.surfaces = std::move(search.surfaces);
  result.tolerance = mesh.tolerance();
  fit_surfaces(mesh, result);
  result.roles = find_face_roles(surface, result.partition, result.surfaces);
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_H
