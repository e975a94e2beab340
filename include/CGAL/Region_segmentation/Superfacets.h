// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_H

#include <CGAL/Region_segmentation/internal/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/Front_queue.h>
#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// makes regions of bounded size whose borders follow concave edges: each face belongs to the seed that
/// is nearest on the dual graph. A model of `RegionInitializer`. Feature edges are not looked at;
/// constrained edges are never crossed.
///
/// A step between two faces has the length \f$|c_i - c_j| / \sqrt{A} \, (1 + w \, \min(\delta^+, m))\f$,
/// \f$c\f$ the centroids, \f$A\f$ the area of the surface, \f$\delta^+\f$ the deviation of a concave edge
/// (0 of another one). The first seed is the face farthest from the centroid of the surface, each
/// further one the face farthest from all seeds so far; of several, the lower face. Every connected
/// piece gets a seed, if need be beyond the number. The regions can be split further: the face that is
/// farthest from its seed leaves first.
///
/// Complexity: O(F log F) in practice: a face is reached anew by a few seeds. Deterministic.
///
/// Source: farthest-point seeding, Gonzalez 1985; on meshes, Eldar et al. 1997.
class Superfacets
{
public:
  static constexpr Flat_mesh::Content content = Flat_mesh::Content::ANGLES_AND_POINTS;

  /// `number`: of regions, at least 1;
  /// `concave_weight` (w, 1/radian): how much longer a step across a concave edge is;
  /// `maximum_deviation` (m, radian): deviations above it count as this one
  explicit Superfacets(std::size_t number = 800, double concave_weight = 80,
                       double maximum_deviation = 0.6)
    : m_number(number), m_concave_weight(concave_weight), m_maximum_deviation(maximum_deviation)
  {}

  Region_labels operator()(const Flat_mesh& mesh, const Edge_marks& /* is_feature */) const
  {
    Region_labels regions;
    if (mesh.number_of_faces() == 0)
      return regions;
    const std::vector<internal::Vector_3> centroids = make_centroids(mesh);
    const double scale = 1 / std::sqrt(total_area(mesh));
    const internal::Dual_graph graph(mesh, [&](std::size_t f, std::size_t e) {
      const double way = norm(centroids[f] - centroids[mesh.higher_face(e)]);
      const double concavity =
        mesh.has_flag(e, Flat_mesh::CONCAVE) ? (std::min)(mesh.deviation(f, e), m_maximum_deviation) : 0;
      return way * scale * (1 + m_concave_weight * concavity);
    });
    return Seeding(graph, mesh.number_of_faces()).run(farthest_face(mesh, centroids), m_number);
  }

private:
  using Index = Flat_mesh::Index;
  static constexpr double unreached = (std::numeric_limits<double>::max)();

  static double total_area(const Flat_mesh& mesh)
  {
    double area = 0;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      area += mesh.area(f);
    return area > 0 ? area : 1; // all faces degenerate: any scale will do
  }

  static std::vector<internal::Vector_3> make_centroids(const Flat_mesh& mesh)
  {
    std::vector<internal::Vector_3> centroids(mesh.number_of_faces());
    for (std::size_t f = 0; f < centroids.size(); ++f)
      centroids[f] = mesh.centroid(f);
    return centroids;
  }

  static std::size_t farthest_face(const Flat_mesh& mesh,
                                   const std::vector<internal::Vector_3>& centroids)
  {
    // Relative to a point of the mesh, so that nothing cancels far from the origin.
    internal::Vector_3 center{};
    for (std::size_t f = 0; f < centroids.size(); ++f)
      center = center + mesh.area(f) * (centroids[f] - centroids[0]);
    center = centroids[0] + (1 / total_area(mesh)) * center;
    std::size_t farthest = 0;
    for (std::size_t f = 1; f < centroids.size(); ++f)
      if (squared_norm(centroids[f] - center) > squared_norm(centroids[farthest] - center))
        farthest = f;
    return farthest;
  }

  /// Seeds one after another; a new seed corrects the distances only where it is nearer.
  class Seeding
  {
  public:
    Seeding(const internal::Dual_graph& graph, std::size_t number_of_faces)
      : m_graph(graph)
      , m_reached(number_of_faces, Reached{unreached, 0, 0})
      , m_front(graph.mean_length() / slices_of_mean_step)
    {}

    Region_labels run(std::size_t first_seed, std::size_t number)
    {
      grow_from(first_seed);
      for (std::size_t f = 0; f < m_reached.size(); f += faces_per_bound)
        m_bounds.push_back(farthest_in_block(f));
      std::make_heap(m_bounds.begin(), m_bounds.end(), is_nearer);
      while (true) {
        const std::size_t seed = farthest();
        const double distance = m_reached[seed].distance;
        if (distance <= 0 || (m_number_of_seeds >= number && distance != unreached))
          break;
        grow_from(seed);
      }
      return number_by_first_face();
    }

  private:
    /// What is known of a face, side by side: it is met at random places.
    struct Reached
    {
      double distance;
      Index seed, predecessor;
    };
    using Entry = std::pair<double, Index>; // distance, face

    /// The farthest of all, the lower face of several, as the last of a heap's order.
    static bool is_nearer(const Entry& a, const Entry& b)
    {
      return a.first != b.first ? a.first < b.first : a.second > b.second;
    }

    /// Of the block of faces that `face` is in.
    Entry farthest_in_block(std::size_t face) const
    {
      const std::size_t first = face - face % faces_per_bound;
      const std::size_t last = (std::min)(first + faces_per_bound, m_reached.size());
      std::size_t farthest = first;
      for (std::size_t f = first + 1; f < last; ++f)
        if (m_reached[f].distance > m_reached[farthest].distance)
          farthest = f;
      return {m_reached[farthest].distance, Index(farthest)};
    }

    /// Distances only shrink, so what once was the farthest face of a block is an upper bound: it is
    /// corrected when it comes up.
    std::size_t farthest()
    {
      while (m_bounds.front().first != m_reached[m_bounds.front().second].distance) {
        std::pop_heap(m_bounds.begin(), m_bounds.end(), is_nearer);
        m_bounds.back() = farthest_in_block(m_bounds.back().second);
        std::push_heap(m_bounds.begin(), m_bounds.end(), is_nearer);
      }
      return m_bounds.front().second;
    }

    /// The front is ordered by distances rounded to float. That cannot change a result, since a face whose
    /// distance shrinks is pushed again.
    void grow_from(std::size_t seed)
    {
      const Index label = Index(m_number_of_seeds++);
      m_reached[seed] = {0, label, Index(seed)};
      m_front.push(internal::make_float_key(0, Index(seed)));
      while (!m_front.empty()) {
        const internal::Float_key top = m_front.pop();
        const Index face = internal::index_of(top);
        const double distance = m_reached[face].distance;
        if (top != internal::make_float_key(float(distance), face))
          continue;
        for (const auto& step : m_graph.steps(face)) {
          const double longer = distance + double(step.length);
          Reached& next = m_reached[step.face];
          if (longer < next.distance) {
            next = {longer, label, face};
            m_front.push(internal::make_float_key(float(longer), step.face));
            m_graph.prefetch_steps(step.face);
          }
        }
      }
    }

    Region_labels number_by_first_face() const
    {
      constexpr Index none = (std::numeric_limits<Index>::max)();
      std::vector<Index> id_of(m_number_of_seeds, none);
      Region_labels regions;
      regions.of_face.reserve(m_reached.size());
      regions.predecessor.reserve(m_reached.size());
      regions.lateness.reserve(m_reached.size());
      for (const Reached& r : m_reached) {
        if (id_of[r.seed] == none)
          id_of[r.seed] = Index(regions.number_of_regions++);
        regions.of_face.push_back(id_of[r.seed]);
        regions.predecessor.push_back(r.predecessor);
        regions.lateness.push_back(r.distance);
      }
      return regions;
    }

    static constexpr std::size_t faces_per_bound = 64;
    static constexpr double slices_of_mean_step = 100; // by trial; across flat edges steps are far shorter

    const internal::Dual_graph& m_graph;
    internal::Large_array<Reached> m_reached;
    std::vector<Entry> m_bounds; // a block of faces each
    internal::Front_queue m_front;
    std::size_t m_number_of_seeds = 0;
  };

  std::size_t m_number;
  double m_concave_weight, m_maximum_deviation;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_H
