// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FIND_FACES_FROM_PATCHES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FIND_FACES_FROM_PATCHES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/part_faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/part_faces/fit_surface.h>
#include <CGAL/Region_segmentation/internal/part_faces/initial_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

inline constexpr Surface_kind kinds_of_surfaces[] = {Surface_kind::PLANE, Surface_kind::CYLINDER,
                                                     Surface_kind::CONE, Surface_kind::SPHERE,
                                                     Surface_kind::TORUS};

/// Fits a surface of a kind to points near `origin` with approximate normal `normal`, from the
/// three initial surfaces that are nearest to them, the nearest first; until one has a root mean
/// square distance below `stop`. Returns the smallest one.
class Surface_proposer
{
public:
  /// \param axis to which the normals are most orthogonal; 0 if not known
  Surface_proposer(const std::vector<Double_3>& points, const Double_3& origin,
                   const Double_3& normal, const Double_3& axis, double stop)
    : m_points(points)
    , m_axis(axis)
    , m_fitter(points, stop)
    , m_stop(stop)
    , m_origin(origin)
    , m_normal(normal)
    , m_paraboloid(osculating_paraboloid(points, origin, normal))
  {}

  double operator()(Surface_kind kind, Fitted_surface<>& best) const
  {
    constexpr std::size_t most_tried = 3;
    double least = 1e300;
    if (int(m_points.size()) < degrees_of_freedom(kind) + 2)
      return least;
    std::vector<std::pair<double, Fitted_surface<>>> initial; // with their distances to the points
    for (const Fitted_surface<>& s : initial_surfaces(kind))
      initial.push_back({m_fitter.root_mean_square(s), s});
    std::stable_sort(initial.begin(), initial.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    initial.resize((std::min)(initial.size(), most_tried));
    for (auto& candidate : initial) {
      const double error = m_fitter(candidate.second);
      if (error < least) {
        least = error;
        best = candidate.second;
      }
      if (least <= m_stop)
        break;
    }
    return least;
  }

private:
  std::vector<Fitted_surface<>> initial_surfaces(Surface_kind kind) const
  {
    const Osculating_paraboloid& o = m_paraboloid;
    std::vector<Fitted_surface<>> result;
    switch (kind) {
    case Surface_kind::PLANE:
      result.push_back(surface_of_kind(Surface_kind::PLANE, m_origin, m_normal));
      break;
    case Surface_kind::CYLINDER:
      result.push_back(initial_cylinder(o));
      if (squared_norm(m_axis) > 0)
        result.push_back(cylinder_along(m_axis, m_points, m_origin));
      break;
    case Surface_kind::SPHERE:
      result.push_back(initial_sphere(o));
      break;
    case Surface_kind::CONE:
      for (const double angle : {0.1, 0.5, -0.5, 1.0, -1.0})
        result.push_back(initial_cone(o, angle));
      break;
    case Surface_kind::TORUS:
      for (int meridian = 0; meridian < 2; ++meridian)
        for (const double angle : {0.0, 0.5, -0.5, 1.0, -1.0})
          if (std::fabs(o.curvature[meridian]) > 0.05 * std::fabs(o.curvature[0]))
            result.push_back(initial_torus(o, meridian, angle));
      break;
    default:
      break;
    }
    return result;
  }

  const std::vector<Double_3>& m_points;
  Double_3 m_axis;
  Surface_fitter m_fitter;
  double m_stop;
  Double_3 m_origin, m_normal;
  Osculating_paraboloid m_paraboloid;
};

/// Fits surfaces to patches of faces that are not found yet, and grows faces of them.
class Patch_seeding
{
public:
  using Index = Surface::Index;

  struct Options
  {
    std::size_t vertices; ///< of a patch
    /// Of the edges that a patch crosses, as a multiple of the longest one of the seed: so patches
    /// stay on narrow strips of long triangles.
    double least_length;
    /// Whether patches are tried only where they end at an edge or at a face that is found: in the
    /// midst of what is left, larger ones were.
    bool only_at_borders;
  };

  Patch_seeding(Face_search& search, const Options& options)
    : m_search(search)
    , m_surface(search.surface)
    , m_patch(search.patch)
    , m_grower(search.grower)
    , m_options(options)
  {}

  void find(const Execution& execution)
  {
    m_search.clear_tried();
    const std::vector<Index> seeds = m_search.seeds();
    if (seeds.size() > many && !some_patch_fits(seeds))
      return;
    Step_counter progress(execution, seeds.size());
    for (const Index seed : seeds) {
      progress.advance();
      if (m_grown_in_vain > 16 * m_surface.number_of_faces() + 50000)
        return; // a bound of the time: 150 meshes grow at most 6 times their faces in vain
      if (!m_search.is_found(seed) && !m_search.is_tried[seed] && !find_from(seed))
        mark_patch();
    }
  }

private:
  /// Whether one of some patches from seeds of all sizes lies on a surface. If not, vertices are
  /// noisy, or the part is freeform: nothing would be found in much more time.
  bool some_patch_fits(const std::vector<Index>& seeds)
  {
    for (std::size_t i = 0; i < seeds.size(); i += seeds.size() / sampled) {
      if (m_search.is_tried[seeds[i]])
        continue;
      collect(seeds[i]);
      const Surface_proposer propose = proposer(seeds[i]);
      Fitted_surface<> s;
      for (const Surface_kind kind : kinds_of_surfaces)
        if (fits(propose, kind, s))
          return true;
      if (is_crowded())
        mark_patch();
    }
    return false;
  }

  bool find_from(Index seed)
  {
    collect(seed);
    if (m_options.only_at_borders && !is_at_border())
      return false;
    Fitted_surface<> best;
    std::vector<Index> best_faces;
    double best_area = 0;
    const Surface_proposer propose = proposer(seed);
    for (const Surface_kind kind : kinds_of_surfaces) {
      Fitted_surface<> s;
      if (!fits(propose, kind, s))
        continue;
      orient(s, seed);
      m_grower.grow(s, m_patch.faces(), [&](Index f) { return !m_search.is_found(f); });
      if (!is_face(s)) {
        m_grown_in_vain += m_grower.faces().size();
        mark_as_tried_if_many();
        continue;
      }
      if (m_grower.area() > 1.1 * best_area) {
        best = s;
        best_area = m_grower.area();
        best_faces = m_grower.faces();
      }
      if (m_search.is_exact())
        break;
    }
    if (best_area == 0)
      return false;
    m_search.add(best, best_faces);
    return true;
  }

  void collect(Index seed)
  {
    const double shortest = m_options.least_length * longest_edge(seed);
    m_patch.collect(
      m_search.neighbors, seed, m_options.vertices, [&](const Face_neighbors::Neighbor& n) {
        return !m_search.is_found(n.face) && m_surface.length(n.adjacency) >= shortest &&
               m_search.neighbors.may_be_smooth(n.adjacency) &&
               m_surface.area(n.face) < largest_area * m_surface.area(seed);
      });
  }

  Surface_proposer proposer(Index seed) const
  {
    return {m_patch.points(), m_surface.centroid(seed), mean_normal(), axis_of_normals(),
            (m_search.is_exact() ? 1e-2 : 0.1) * m_search.test.tolerance()};
  }

  bool fits(const Surface_proposer& propose, Surface_kind kind, Fitted_surface<>& s) const
  {
    const double tolerance = m_search.test.tolerance();
    return propose(kind, s) <= tolerance && largest_distance(s, m_patch.points()) <= tolerance;
  }

  /// Whether the faces share few vertices. Those of a manifold do not: only patches of fewer
  /// vertices than are wanted grow, so they have some three faces for each. Most patches of such
  /// faces are all of them: one is tried.
  bool is_crowded() const { return m_patch.faces().size() > 4 * m_options.vertices; }

  bool is_at_border() const
  {
    for (const Index f : m_patch.faces())
      for (const Face_neighbors::Neighbor& n : m_search.neighbors[f])
        if (m_search.is_found(n.face) || !m_search.neighbors.may_be_smooth(n.adjacency))
          return true;
    return false;
  }

  double longest_edge(Index face) const
  {
    double longest = 0;
    for (const Face_neighbors::Neighbor& n : m_search.neighbors[face])
      longest = (std::max)(longest, m_surface.length(n.adjacency));
    return longest;
  }

  Double_3 mean_normal() const
  {
    Double_3 sum{0, 0, 0};
    for (const Index f : m_patch.faces())
      sum = sum + m_surface.area(f) * m_surface.normal(f);
    const double length = norm(sum);
    return length > 0 ? (1 / length) * sum : Double_3{0, 0, 1};
  }

  /// The direction to which the normals of the patch are most orthogonal.
  Double_3 axis_of_normals() const
  {
    Symmetric_3 sum;
    for (const Index f : m_patch.faces())
      sum.add_square(m_surface.area(f), m_surface.normal(f));
    return eigenvectors(sum)[0];
  }

  void orient(Fitted_surface<>& s, Index seed) const
  {
    s.side = 1;
    if (dot(surface_normal(s, m_surface.centroid(seed)), m_surface.normal(seed)) < 0) {
      if (s.kind == Surface_kind::PLANE)
        s.direction = -1.0 * s.direction;
      else
        s.side = -1;
    }
  }

  /// Whether what was grown is a face, and not only osculated or crossed by its surface.
  bool is_face(const Fitted_surface<>& s) const
  {
    const std::size_t points = m_grower.points().size();
    if (int(points) < degrees_of_freedom(s.kind) + 2 ||
        m_grower.faces().size() < m_patch.faces().size() * 3 / 4)
      return false;
    if (s.kind == Surface_kind::PLANE ? points < fewest_points_of_plane : is_chain_of_planes())
      return false;
    // Faces that cross a crease lie on many surfaces, with vertices of the faces beside it alone.
    return m_search.is_exact()
             ? m_grower.gradual_border(s) <= 0.1
             : int(m_search.number_of_new_vertices(m_grower.faces())) >= degrees_of_freedom(s.kind);
  }

  /// Whether the faces are two planes, or three of several triangles each, such as chamfers, rather
  /// than facets of a curved face; or mostly one plane, with the first facets of the fillets beside
  /// it.
  bool is_chain_of_planes() const
  {
    if (m_grower.share_of_largest_facet() > 0.6)
      return true;
    const std::size_t facets = m_grower.number_of_facets();
    const bool are_few = facets <= 2 || (facets == 3 && m_grower.faces().size() > 2 * facets);
    return are_few && !m_grower.is_tangent_to_neighbors();
  }

  /// Seeds in a large set of faces that was grown in vain, or from a crowded patch, would grow it
  /// again: so the time of all growing stays near linear.
  void mark_as_tried_if_many()
  {
    if (is_crowded() || m_grower.faces().size() > 4 * m_patch.faces().size())
      for (const Index f : m_grower.faces())
        m_search.is_tried[f] = 1;
  }

  /// The innermost faces of a patch that fits no surface are not tried again, nor any of a crowded
  /// one.
  void mark_patch()
  {
    const std::size_t share = is_crowded() ? 1 : m_options.vertices > 12 ? 4 : 2;
    const std::size_t number = (std::max)(m_patch.faces().size() / share, std::size_t(1));
    for (std::size_t i = 0; i < number; ++i)
      m_search.is_tried[m_patch.faces()[i]] = 1;
  }

  static constexpr double largest_area = 8; // of a face of a patch, as a multiple of that of the
                                            // seed
  static constexpr std::size_t fewest_points_of_plane = 8;
  static constexpr std::size_t many = 5000, sampled = 500; // seeds

  Face_search& m_search;
  const Surface& m_surface;
  Face_set& m_patch;
  Face_grower& m_grower;
  Options m_options;
  std::size_t m_grown_in_vain = 0; // faces
};

/// Larger patches first: they tell surfaces apart that small ones do not.
inline void find_faces_from_patches(Face_search& search, const Execution& execution)
{
  const std::vector<Patch_seeding::Options> of_exact = {{24, 0, false},
                                                        {12, 0, true},
                                                        {8, 0.5, true}},
                                            of_noisy = {
                                              {80, 0, false}, {40, 0, false}, {20, 0, false}};
  const std::vector<Patch_seeding::Options>& phases = search.is_exact() ? of_exact : of_noisy;
  for (std::size_t i = 0; i < phases.size(); ++i)
    Patch_seeding(search, phases[i])
      .find(
        execution.step(double(i) / double(phases.size()), double(i + 1) / double(phases.size())));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_FIND_FACES_FROM_PATCHES_H
