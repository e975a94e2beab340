// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_FROM_PATCHES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_FROM_PATCHES_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/initial_surfaces.h>
#include <CGAL/Region_segmentation/Part_faces/internal/surface_evidence.h>
#include <CGAL/Region_segmentation/Support/Execution.h>

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

/// Fits surfaces of all kinds to a patch of faces: from the initial surfaces of a kind that are
/// nearest to its vertices, the nearest first, until one has a root mean square distance below
/// `stop`.
class Surface_proposer
{
public:
  Surface_proposer(const Surface& surface, const Face_neighbors& neighbors, const Face_set& patch,
                   double stop)
    : m_points(evenly_spread(patch.points(), most_points))
    , m_fitter(m_points, stop)
    , m_stop(stop)
    , m_origin(surface.centroid(patch.faces()[0]))
    , m_line(axis_line(
        m_points, evenly_spread(vertex_normals(surface, neighbors, patch), most_points), m_origin))
  {
    Symmetric_3 squares, around_mean;
    Double_3 sum{0, 0, 0};
    double area = 0;
    for (const Surface::Index f : patch.faces()) {
      squares.add_square(surface.area(f), surface.normal(f));
      sum = sum + surface.area(f) * surface.normal(f);
      area += surface.area(f);
    }
    around_mean = squares;
    around_mean.add_square(-1 / area, sum);
    m_normal = norm(sum) > 0 ? (1 / norm(sum)) * sum : surface.normal(patch.faces()[0]);
    m_orthogonal = eigenvectors(squares)[0];
    m_equal_angles = eigenvectors(around_mean)[0];
    m_paraboloid = osculating_paraboloid(m_points, m_origin, m_normal);
  }

  double operator()(Surface_kind kind, Fitted_surface<>& best) const
  {
    constexpr std::size_t most_tried = 3;
    double least = 1e300;
    if (int(m_points.size()) <= degrees_of_freedom(kind))
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
    std::vector<Fitted_surface<>> result;
    switch (kind) {
    case Surface_kind::PLANE:
      return {surface_of_kind(Surface_kind::PLANE, m_origin, m_normal)};
    case Surface_kind::CYLINDER:
      for (const Double_3& axis : {m_orthogonal, m_equal_angles, m_line.direction})
        result.push_back(cylinder_along(axis, m_points, m_origin));
      return result;
    case Surface_kind::CONE:
      for (const Double_3& axis : {m_equal_angles, m_line.direction, m_orthogonal})
        result.push_back(cone_along(axis, m_points, m_origin));
      return result;
    case Surface_kind::SPHERE:
      return {sphere_with_axis(m_line.direction, m_points, m_origin)};
    default:
      result.push_back(torus_around(m_line, m_points));
      for (int meridian = 0; meridian < 2; ++meridian)
        for (const double angle : {0.0, 0.5, -0.5, 1.0, -1.0})
          if (std::fabs(m_paraboloid.curvature[meridian]) >
              0.05 * std::fabs(m_paraboloid.curvature[0]))
            result.push_back(initial_torus(m_paraboloid, meridian, angle));
      return result;
    }
  }

  static constexpr std::size_t most_points = 80;

  std::vector<Double_3> m_points;
  Surface_fitter m_fitter;
  double m_stop;
  Double_3 m_origin, m_normal;
  Osculating_paraboloid m_paraboloid;    ///< where vertices are noisy, it tells more
  Axis_line m_line;                      ///< that the normals meet
  Double_3 m_orthogonal, m_equal_angles; ///< to the normals, with the normals
};

/// As the number of vertices of a patch: all faces that go on smoothly.
inline constexpr std::size_t all_vertices = std::size_t(-1);

void find_whole_beside(Face_search& search, std::vector<Surface::Index> faces);

/// Fits surfaces to patches of faces that are not found yet, and grows faces of them.
class Patch_seeding
{
public:
  using Index = Surface::Index;

  struct Options
  {
    std::size_t vertices; ///< of a patch
    /// Whether patches are strips: they cross edges in one direction alone, and those between
    /// coplanar faces. So they stay on a face of one row of facets.
    bool is_strip = false;
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
    const Partition components = smooth_components_left(m_search, Execution());
    std::vector<std::size_t> in_vain(components.number_of_parts(), 0); // patches since a face
    const std::vector<Index> seeds = m_search.seeds();
    Step_counter progress(execution, seeds.size());
    for (const Index seed : seeds) {
      progress.advance();
      std::size_t& tried = in_vain[components[seed]];
      if (m_search.is_found(seed) || m_search.is_tried[seed] || tried > most_in_vain)
        continue;
      for (const Double_3& direction : directions(seed)) {
        collect(seed, direction);
        if (find_from_patch(seed)) {
          tried = 0;
          find_whole_beside(m_search, m_found);
          break;
        }
        ++tried;
        mark_patch();
      }
    }
  }

  /// Whether all faces that go on smoothly from the seed are a face, unless they have more vertices
  /// than a patch.
  bool find_whole(Index seed)
  {
    collect(seed, {0, 0, 0});
    return m_patch.points().size() < m_options.vertices && find_from_patch(seed);
  }
  const std::vector<Index>& found() const { return m_found; }

private:
  bool find_from_patch(Index seed)
  {
    if (m_patch.points().size() < fewest_points)
      return false;
    Fitted_surface<> best;
    std::vector<Index> best_faces;
    double best_area = 0;
    const Surface_proposer propose = proposer();
    for (const Surface_kind kind : kinds_of_surfaces) {
      Fitted_surface<> s;
      if (!fits(propose, kind, s))
        continue;
      orient(s, seed);
      m_grower.grow(s, m_patch.faces(), [&](Index f) { return !m_search.is_found(f); });
      if (!is_face(s))
        mark_grown();
      else if (m_grower.area() > 1.1 * best_area) {
        best = s;
        best_area = m_grower.area();
        best_faces = m_grower.faces();
      }
      if (m_search.is_exact && best_area > 0)
        break;
    }
    if (best_area == 0)
      return false;
    m_search.add(best, best_faces);
    m_found = std::move(best_faces);
    return true;
  }

  /// The directions of strips: of the edges of the seed. Without strips one, which is 0.
  std::vector<Double_3> directions(Index seed) const
  {
    std::vector<Double_3> result;
    if (m_options.is_strip)
      for (const Face_neighbors::Neighbor& n : m_search.neighbors[seed])
        if (may_cross(seed, n) && !m_search.neighbors.is_coplanar(n.adjacency))
          result.push_back(Shared_side(m_surface, seed, n.face).along);
    return result.empty() ? std::vector<Double_3>{{0, 0, 0}} : result;
  }

  bool may_cross(Index seed, const Face_neighbors::Neighbor& n) const
  {
    return !m_search.is_found(n.face) && m_search.neighbors.is_smooth(n.adjacency) &&
           m_surface.area(n.face) < largest_area * m_surface.area(seed);
  }

  /// \param direction of a strip: edges that are crossed are within 37 degrees of those crossed
  ///        before
  void collect(Index seed, const Double_3& direction)
  {
    constexpr double cosine = 0.8;
    std::vector<Double_3> crossed{direction}; // by face of a strip
    const auto crosses = [&](std::size_t i, const Face_neighbors::Neighbor& n) {
      if (!may_cross(seed, n) || !m_options.is_strip)
        return may_cross(seed, n);
      const Double_3 along = Shared_side(m_surface, m_patch.faces()[i], n.face).along;
      const bool is_coplanar = m_search.neighbors.is_coplanar(n.adjacency);
      if (!is_coplanar && std::fabs(dot(along, crossed[i])) < cosine)
        return false;
      crossed.push_back(is_coplanar ? crossed[i] : along);
      return true;
    };
    m_patch.collect(m_search.neighbors, seed, m_options.vertices, crosses);
  }

  Surface_proposer proposer() const
  {
    return {m_surface, m_search.neighbors, m_patch, m_search.goal()};
  }

  bool fits(const Surface_proposer& propose, Surface_kind kind, Fitted_surface<>& s) const
  {
    const double tolerance = m_search.test.tolerance();
    return propose(kind, s) <= tolerance && largest_distance(s, m_patch.points()) <= tolerance;
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
    if (int(points) <= degrees_of_freedom(s.kind))
      return false;
    if (s.kind == Surface_kind::PLANE ? points < fewest_points_of_plane : !has_evidence(s))
      return false;
    // Faces that cross a crease lie on many surfaces, with vertices of the faces beside it alone.
    return m_search.is_exact
             ? m_grower.gradual_border(s) <= 0.1
             : int(m_search.number_of_new_vertices(m_grower.faces())) >= degrees_of_freedom(s.kind);
  }

  /// Whether the faces are more than planes beside each other, or mostly one plane, with the first
  /// facets of the fillets beside it.
  bool has_evidence(const Fitted_surface<>& s) const
  {
    return m_grower.share_of_largest_facet() <= 0.6 &&
           (!m_search.is_exact ||
            is_evident(m_surface, m_search.neighbors, m_grower, s, m_search.test.tolerance()));
  }

  /// Other seeds in a large set of faces that was grown in vain would grow it again.
  void mark_grown()
  {
    if (!m_options.is_strip && m_grower.faces().size() > 4 * m_patch.faces().size())
      for (const Index f : m_grower.faces())
        m_search.is_tried[f] = 1;
  }

  /// The innermost faces of a patch that fits no surface are not tried again.
  void mark_patch()
  {
    const std::size_t share = m_options.vertices == all_vertices ? 1
                              : m_options.vertices > 12          ? 4
                                                                 : 2;
    const std::size_t number = (std::max)(m_patch.faces().size() / share, std::size_t(1));
    for (std::size_t i = 0; i < number; ++i)
      m_search.is_tried[m_patch.faces()[i]] = 1;
  }

  static constexpr double largest_area = 8; // of a face of a patch, as a multiple of that of the
                                            // seed
  static constexpr std::size_t fewest_points = 6, fewest_points_of_plane = 8;
  /// After as many patches, what goes on smoothly is taken to be freeform.
  static constexpr std::size_t most_in_vain = 1000;

  Face_search& m_search;
  const Surface& m_surface;
  Face_set& m_patch;
  Face_grower& m_grower;
  Options m_options;
  std::vector<Index> m_found;
};

/// What goes on smoothly beside faces that were just found may be a face as a whole, now that it
/// ends at them.
inline void find_whole_beside(Face_search& search, std::vector<Surface::Index> faces)
{
  constexpr std::size_t most = 2000; // vertices
  if (!search.is_exact)
    return;
  search.is_tried_whole.clear();
  while (!faces.empty()) {
    const Surface::Index f = faces.back();
    faces.pop_back();
    for (const Face_neighbors::Neighbor& n : search.neighbors[f])
      if (!search.is_found(n.face) && search.neighbors.is_smooth(n.adjacency) &&
          !search.is_tried_whole.has(n.face)) {
        Patch_seeding seeding(search, {most});
        if (seeding.find_whole(n.face))
          faces.insert(faces.end(), seeding.found().begin(), seeding.found().end());
        else
          for (const Surface::Index g : search.patch.faces())
            search.is_tried_whole.mark(g);
      }
  }
}

/// Larger patches first: they tell surfaces apart that small ones do not.
inline void find_faces_from_patches(Face_search& search, const Execution& execution)
{
  const std::vector<Patch_seeding::Options> of_exact = {{all_vertices}, {24}, {12}, {8, true}},
                                            of_noisy = {{80}, {40}, {20}};
  const std::vector<Patch_seeding::Options>& phases = search.is_exact ? of_exact : of_noisy;
  const double n = double(phases.size());
  for (std::size_t i = 0; i < phases.size(); ++i)
    Patch_seeding(search, phases[i]).find(execution.step(double(i) / n, double(i + 1) / n));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_FACES_FROM_PATCHES_H
