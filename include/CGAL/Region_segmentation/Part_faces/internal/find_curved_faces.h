// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_CURVED_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_CURVED_FACES_H

#include <CGAL/Region_segmentation/Part_faces/internal/Face_search.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Surface_proposer.h>
#include <CGAL/Region_segmentation/Part_faces/internal/surface_evidence.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Fits surfaces to patches of faces that are not found yet, and grows faces of them.
class Patch_seeding
{
public:
  using Index = Surface::Index;

  struct Options
  {
    std::size_t vertices;    ///< of a patch
    std::size_t share_tried; ///< one in so many faces of a patch without a surface is tried
    bool is_strip = false;   ///< whether patches cross edges in one direction alone, and those
                             ///< within facets: so they stay on a face of one row of facets
  };

  Patch_seeding(Face_search& search, const Options& options)
    : m_search(search)
    , m_mesh(search.mesh)
    , m_surface(search.surface)
    , m_patch(search.patch)
    , m_grower(search.grower)
    , m_options(options)
    , m_is_tried(search.surface.number_of_faces(), 0)
  {}

  void find(const Execution& execution)
  {
    const Partition components = smooth_components_left();
    std::vector<std::size_t> in_vain(components.number_of_parts(), 0); // patches since a face
    Step_counter progress(execution, m_surface.number_of_faces());
    for (const Index seed : m_mesh.faces_by_area()) {
      progress.advance();
      std::size_t& vain = in_vain[components[seed]];
      if (m_is_tried[seed] || !m_mesh.has_normal(seed) || !m_search.may_be_curved(seed) ||
          vain > most_in_vain)
        continue;
      for (const Double_3& direction : directions(seed)) {
        collect(seed, direction);
        if (find_from_patch()) {
          vain = 0;
          break;
        }
        ++vain;
        const std::size_t tried = (std::max)(m_patch.faces().size() / m_options.share_tried,
                                             std::size_t(1));
        for (std::size_t i = 0; i < tried; ++i)
          m_is_tried[m_patch.faces()[i]] = 1;
      }
    }
  }

private:
  /// The components of the faces that are left, of which two are connected where they go on
  /// smoothly.
  Partition smooth_components_left() const
  {
    return label_components(
      m_surface,
      [&](std::size_t a) {
        const Index f = m_surface.lower_face(a), g = m_surface.higher_face(a);
        return !m_surface.has_flag(a, Surface::barrier) && m_search.may_be_curved(f) &&
               m_search.may_be_curved(g) && m_mesh.is_smooth(f, g);
      },
      Execution());
  }

  bool find_from_patch()
  {
    constexpr std::size_t fewest_points = 6;
    if (m_patch.points().size() < fewest_points)
      return false;
    const std::vector<Oriented_piece> pieces = facets_of_patch();
    if (pieces.size() < 2)
      return false;
    const Surface_proposer propose(m_patch.points(), pieces, m_mesh.good_fit());
    const std::size_t fitted = (std::min)(m_patch.points().size(), Surface_proposer::most_points);
    Fitted_surface<> best;
    std::vector<Index> best_faces;
    double best_gain = 0;
    for (const Surface_kind kind : kinds_of_surfaces) {
      Fitted_surface<> s;
      const double largest = largest_error(fitted, kind);
      if (kind == Surface_kind::PLANE || propose(kind, largest, s) > largest ||
          largest_distance(s, m_patch.points()) > m_mesh.tolerance())
        continue;
      orient(s);
      m_grower.grow(s, m_patch, [&](Index f) { return !m_search.is_found(f); });
      const double gain = double(m_grower.points().size()) - degrees_of_freedom(kind);
      if (gain <= 1.1 * best_gain)
        continue;
      if (!is_face(s))
        mark_grown();
      else {
        best = s;
        best_gain = gain;
        best_faces = m_grower.faces();
      }
    }
    if (best_gain > 0)
      m_search.add(best, best_faces);
    return best_gain > 0;
  }

  /// Other seeds in a large set of faces that was grown in vain would grow it again.
  void mark_grown()
  {
    constexpr std::size_t much = 16;
    if (!m_options.is_strip && m_grower.faces().size() > much * m_patch.faces().size())
      for (const Index f : m_grower.faces())
        m_is_tried[f] = 1;
  }

  /// Facets of the patch, that of its first face first.
  std::vector<Oriented_piece> facets_of_patch() const
  {
    constexpr std::size_t most = 200;
    std::vector<Oriented_piece> result;
    auto facets = m_mesh.facets_of(m_patch.faces());
    std::iter_swap(facets.begin(), std::find_if(facets.begin(), facets.end(), [&](const auto& f) {
                     return f.first == m_mesh.facet_of(m_patch.faces()[0]);
                   }));
    const std::size_t step = (std::max)(facets.size() / most, std::size_t(1));
    for (std::size_t i = 0; i < facets.size(); i += step) {
      const Facet& facet = m_mesh.facet(facets[i].first);
      result.push_back({facet.center, facet.plane.direction, facets[i].second});
    }
    return result;
  }

  /// The directions of strips: of the edges of the seed. Without strips one, which is 0.
  std::vector<Double_3> directions(Index seed) const
  {
    constexpr std::size_t most = 4;
    std::vector<Double_3> result;
    if (m_options.is_strip)
      for (const Index f : m_mesh.faces_of_facet(m_mesh.facet_of(seed)))
        for_each_neighbor(m_surface, f, [&](Index g, Index v, Index w) {
          if (m_mesh.facet_of(g) != m_mesh.facet_of(f) && !m_search.is_found(g) &&
              m_mesh.is_smooth(f, g) && result.size() < most)
            result.push_back(direction_of_side(v, w));
        });
    else
      result.push_back({0, 0, 0});
    return result;
  }

  Double_3 direction_of_side(Index v, Index w) const
  {
    const Double_3 d = m_surface.point(w) - m_surface.point(v);
    return norm(d) > 0 ? (1 / norm(d)) * d : d;
  }

  /// \param direction of a strip: edges that are crossed are within 37 degrees of those crossed
  ///        before
  void collect(Index seed, const Double_3& direction)
  {
    constexpr double cosine = 0.8, largest_area = 8;
    const Index first = m_mesh.facet_of(seed);
    std::vector<Double_3> crossed{direction}; // by face of a strip
    collect_patch(m_patch, m_surface, seed, m_options.vertices,
                  [&](std::size_t i, Index g, Index v, Index w) {
                    const Index f = m_patch.faces()[i], facet = m_mesh.facet_of(g);
                    if (m_search.is_found(g) || !m_mesh.is_smooth(f, g) ||
                        (facet != first &&
                         (m_search.is_sure[facet] ||
                          m_mesh.facet(facet).area > largest_area * m_mesh.facet(first).area)))
                      return false;
                    if (!m_options.is_strip)
                      return true;
                    const bool is_coplanar = facet == m_mesh.facet_of(f);
                    const Double_3 along = direction_of_side(v, w);
                    if (!is_coplanar && std::fabs(dot(along, crossed[i])) < cosine)
                      return false;
                    crossed.push_back(is_coplanar ? crossed[i] : along);
                    return true;
                  });
  }

  /// The largest root mean square distance of n points without a systematic error from the surface
  /// that is fitted to them.
  double largest_error(std::size_t n, Surface_kind kind) const
  {
    constexpr double most = 1.5, of_chance = 1.5;
    const double points = double(n), freedom = (std::max)(1.0, points - degrees_of_freedom(kind));
    return most * m_mesh.sigma * std::sqrt(freedom / points) * (1 + of_chance / std::sqrt(freedom));
  }

  void orient(Fitted_surface<>& s) const
  {
    double sum = 0;
    s.side = 1;
    for (const Index f : m_patch.faces())
      sum += m_surface.area(f) * dot(m_surface.normal(f), surface_normal(s, m_surface.centroid(f)));
    s.side = sum < 0 ? -1 : 1;
  }

  /// Whether what was grown is a face, and not only osculated or crossed by its surface.
  bool is_face(const Fitted_surface<>& s) const
  {
    constexpr double most_gradual = 0.1;
    const std::vector<Double_3>& points = m_grower.points();
    return m_grower.faces().size() > 1 &&
           Surface_fitter(points, 0).root_mean_square(s) <= largest_error(points.size(), s.kind) &&
           is_evident(m_mesh, m_grower, s) &&
           gradual_border(m_mesh, m_grower, s, [&](Index f) { return !m_search.is_found(f); }) <=
             most_gradual;
  }

  /// After as many patches without a face, what goes on smoothly is taken to be freeform.
  static constexpr std::size_t most_in_vain = 200;

  Face_search& m_search;
  const Tessellation& m_mesh;
  const Surface& m_surface;
  Face_set& m_patch;
  Face_grower& m_grower;
  Options m_options;
  std::vector<std::uint8_t> m_is_tried; // by face: no seed
};

/// Larger patches first: they tell surfaces apart that small ones do not.
inline void find_curved_faces(Face_search& search, const Execution& execution)
{
  constexpr std::size_t all = std::size_t(-1);
  const Patch_seeding::Options phases[] = {{all, 1}, {80, 4}, {24, 4}, {12, 2}, {8, 2, true}};
  double done = 0;
  for (const Patch_seeding::Options& phase : phases) {
    Patch_seeding(search, phase).find(execution.step(done, done + 0.2));
    done += 0.2;
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_FIND_CURVED_FACES_H
