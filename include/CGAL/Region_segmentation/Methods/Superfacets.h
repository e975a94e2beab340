// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SUPERFACETS_H
#define CGAL_REGION_SEGMENTATION_METHODS_SUPERFACETS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/regions/Front_queue.h>
#include <CGAL/Region_segmentation/internal/regions/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// makes regions of bounded size whose borders follow concave edges: each face belongs to the nearest
/// seed on the dual graph. A model of `RegionInitializer`. Constrained edges are never crossed.
///
/// A step between two faces has the length \f$|c_i - c_j| / \sqrt{A} \, (1 + w \, \min(\delta^+, m))\f$,
/// \f$c\f$ the centroids, \f$A\f$ the area of the surface, \f$\delta^+\f$ the deviation of a concave edge (0 of another
/// one). The first seed is the face farthest from the centroid of the surface, each further one the face farthest from
/// all seeds so far; of several, the lower face. Every connected component gets a seed, even if this exceeds the
/// number. Regions are connected.
///
/// The regions can be split further: the face farthest from its seed is separated first, with the faces that were
/// reached through it.
///
/// Complexity: O(F log F) in practice: a face is reached by a few seeds. Deterministic.
///
/// Source: farthest-point seeding, Gonzalez 1985; on meshes, Eldar et al. 1997.
class Superfacets
{
public:
  static constexpr Mesh_data required_mesh_data = Mesh_data::CENTROIDS | Mesh_data::SURFACE_AREA;

  std::size_t number;       ///< of regions, at least 1
  double concave_weight;    ///< w, 1/radian, at least 0: the lengthening of steps across concave edges
  double maximum_deviation; ///< m, radian, at least 0: deviations above it count as this one

  explicit Superfacets(std::size_t number_ = 800, double concave_weight_ = 80, double maximum_deviation_ = 0.6)
    : number(number_), concave_weight(concave_weight_), maximum_deviation(maximum_deviation_)
  {}

  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  Partition operator()(const Flat_mesh& mesh,
                       const Execution<ConcurrencyTag>& execution = Execution<ConcurrencyTag>()) const
  {
    return mesh.number_of_faces() == 0 ? Partition() : seed(mesh, execution).regions();
  }

  /// The partition into `number_of_segments` that splits the regions of this mesh further. Takes the time of making
  /// the regions, and O(F log F).
  /// \pre `number_of_segments` is at least the number of regions
  template <typename ConcurrencyTag = CGAL::Sequential_tag>
  Partition split(const Flat_mesh& mesh, std::size_t number_of_segments,
                  const Execution<ConcurrencyTag>& execution = Execution<ConcurrencyTag>()) const
  {
    return mesh.number_of_faces() == 0 ? Partition() : seed(mesh, execution).split_regions(number_of_segments);
  }

private:
  using Index = Flat_mesh::Index;
  static constexpr double unreached = (std::numeric_limits<double>::max)();

  static std::size_t farthest_face(const Flat_mesh& mesh)
  {
    // Relative to a point of the mesh, to avoid cancellation far from the origin.
    const Double_3 origin = mesh.centroid(0);
    Double_3 center{};
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      center = center + mesh.area(f) * (mesh.centroid(f) - origin);
    center = origin + (1 / (mesh.surface_area() > 0 ? mesh.surface_area() : 1)) * center;
    std::size_t farthest = 0;
    for (std::size_t f = 1; f < mesh.number_of_faces(); ++f)
      if (squared_norm(mesh.centroid(f) - center) > squared_norm(mesh.centroid(farthest) - center))
        farthest = f;
    return farthest;
  }

  /// Seeds are placed one after another; a new seed updates the distances only where it is nearer.
  template <typename ConcurrencyTag>
  class Seeding
  {
  public:
    Seeding(internal::Dual_graph graph, std::size_t number_of_faces, const Execution<ConcurrencyTag>& execution)
      : m_execution(execution)
      , m_graph(std::move(graph))
      , m_reached(number_of_faces, Reached{unreached, 0, 0})
      , m_front(m_graph.mean_length() / slices_of_mean_step)
    {}

    void run(std::size_t first_seed, std::size_t number)
    {
      m_number_wanted = number;
      grow_from(first_seed);
      for (std::size_t f = 0; f < m_reached.size(); f += faces_per_bound)
        m_bounds.push_back(farthest_in_block(f));
      std::make_heap(m_bounds.begin(), m_bounds.end(), is_nearer);
      internal::Step_counter<ConcurrencyTag> seeds(m_execution, number);
      while (true) {
        const std::size_t seed = farthest();
        const double distance = m_reached[seed].distance;
        if (distance <= 0 || (m_number_of_seeds >= number && distance != unreached))
          break;
        grow_from(seed);
        seeds.advance();
      }
    }

    Partition regions() const
    {
      std::vector<Index> id_of(m_number_of_seeds, Index(none)), region_of;
      Index number = 0;
      region_of.reserve(m_reached.size());
      for (const Reached& r : m_reached) {
        if (id_of[r.seed] == none)
          id_of[r.seed] = number++;
        region_of.push_back(id_of[r.seed]);
      }
      return Partition(std::move(region_of), number);
    }

    /// The faces that were reached last are separated, each with those that were reached through it.
    Partition split_regions(std::size_t number_of_segments) const
    {
      std::vector<Index> order(m_reached.size());
      std::iota(order.begin(), order.end(), Index(0));
      std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return m_reached[a].distance != m_reached[b].distance ? m_reached[a].distance < m_reached[b].distance : a < b;
      });
      std::size_t to_join = order.size() - (std::min)(number_of_segments, order.size());
      internal::Lowest_root_forest forest(order.size());
      for (Index f : order)
        if (to_join > 0 && m_reached[f].predecessor != f) {
          forest.unite(f, m_reached[f].predecessor);
          --to_join;
        }
      return forest.take_partition();
    }

  private:
    /// All data of a face, stored together, since faces are accessed at random.
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

    /// Distances only shrink, so a former farthest face of a block is an upper bound: it is updated
    /// when it is popped.
    std::size_t farthest()
    {
      while (m_bounds.front().first != m_reached[m_bounds.front().second].distance) {
        std::pop_heap(m_bounds.begin(), m_bounds.end(), is_nearer);
        m_bounds.back() = farthest_in_block(m_bounds.back().second);
        std::push_heap(m_bounds.begin(), m_bounds.end(), is_nearer);
      }
      return m_bounds.front().second;
    }

    /// The front is ordered by distances rounded to float. This cannot change a result, since a face whose distance
    /// shrinks is pushed again.
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
        report_now_and_then();
        for (const auto& step : m_graph.steps(face)) {
          const double longer = distance + double(step.length);
          Reached& next = m_reached[step.face];
          // A face follows its predecessor to another seed even if rounding hides that it is nearer: so regions are
          // connected.
          if (longer < next.distance || (next.predecessor == face && next.seed != label)) {
            next = {longer, label, face};
            m_front.push(internal::make_float_key(float(longer), step.face));
            m_graph.prefetch_steps(step.face);
          }
        }
      }
    }

    void report_now_and_then()
    {
      constexpr std::size_t faces_per_report = 1 << 16;
      if (++m_number_of_visits % faces_per_report == 0)
        m_execution.report((std::min)(1.0, double(m_number_of_seeds) / double(m_number_wanted)));
    }

    static constexpr Index none = (std::numeric_limits<Index>::max)();
    static constexpr std::size_t faces_per_bound = 64;
    static constexpr double slices_of_mean_step = 100; // tuned empirically; across flat edges steps are far shorter

    const Execution<ConcurrencyTag>& m_execution;
    internal::Dual_graph m_graph;
    internal::Large_array<Reached> m_reached;
    std::vector<Entry> m_bounds; // a block of faces each
    internal::Front_queue m_front;
    std::size_t m_number_of_seeds = 0, m_number_wanted = 1, m_number_of_visits = 0;
  };

  template <typename ConcurrencyTag>
  Seeding<ConcurrencyTag> seed(const Flat_mesh& mesh, const Execution<ConcurrencyTag>& execution) const
  {
    CGAL_precondition_msg(number >= 1 && concave_weight >= 0 && maximum_deviation >= 0,
                          "Superfacets: number is at least 1, concave_weight and maximum_deviation at least 0");
    const double scale = 1 / mesh.relative_unit();
    internal::Dual_graph graph(mesh, [&](std::size_t f, std::size_t e) {
      const double distance = norm(mesh.centroid(f) - mesh.centroid(mesh.higher_face(e)));
      const double concavity =
        mesh.has_flag(e, Flat_mesh::CONCAVE) ? (std::min)(mesh.deviation(f, e), maximum_deviation) : 0;
      return distance * scale * (1 + concave_weight * concavity);
    });
    Seeding<ConcurrencyTag> seeding(std::move(graph), mesh.number_of_faces(), execution);
    seeding.run(farthest_face(mesh), number);
    return seeding;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SUPERFACETS_H
