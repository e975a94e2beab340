// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_FARTHEST_POINT_SEEDING_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_FARTHEST_POINT_SEEDING_H

#include <CGAL/Region_segmentation/Graph/internal/Dual_graph.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Farthest-point seeding on a dual graph: every connected component gets a seed, then seeds are
/// placed one after another, each at the face farthest from all seeds so far, of several at the
/// lower one; a new seed updates the distances only where it is nearer. The region of a seed is the
/// faces that are nearest to it, and is connected.
///
/// The faces are those of a mesh, or patches.
class Farthest_point_seeding
{
  using Index = Dual_graph::Index;

public:
  explicit Farthest_point_seeding(Dual_graph graph)
    : m_graph(std::move(graph))
    , m_reached(m_graph.number_of_faces(), Reached{unreached, 0})
  {}

  /// Places `number` seeds, or more if there are more components, or fewer if all faces are seeds.
  /// `remoteness`: by face; each component gets its first seed where it is highest, of several at
  /// the lower face, and components in this order
  /// \pre there are faces
  void run(const std::vector<double>& remoteness, std::size_t number, const Execution& execution)
  {
    Step_counter seeds(execution, number);
    seed_components(remoteness, seeds);
    m_number_of_components = m_seeds.size();
    // Distances only shrink, so a former one is an upper bound.
    const auto is_nearer = [](const Entry& a, const Entry& b) {
      return a.first != b.first ? a.first < b.first : a.second > b.second;
    };
    std::priority_queue<Entry, std::vector<Entry>, decltype(is_nearer)> farthest(is_nearer);
    for (Index f = 0; f < m_reached.size(); ++f)
      farthest.push({m_reached[f].distance, f});
    while (m_seeds.size() < number) {
      const auto [bound, face] = farthest.top();
      if (const double distance = m_reached[face].distance; distance < bound) {
        farthest.pop();
        farthest.push({distance, face});
        continue;
      }
      if (bound <= 0)
        break;
      grow_from(face);
      seeds.advance();
    }
  }

  /// Places given seeds, all at once, beside those so far: of several seeds at the same distance a
  /// face belongs to one placed earlier, else to that of the neighbor that was nearer to its own,
  /// of these the lower one.
  void add(const std::vector<Index>& seeds)
  {
    for (const Index seed : seeds)
      place(seed);
    grow();
  }

  /// The seeds in the order in which they were placed by `run()`, those of the components first.
  const std::vector<Index>& seeds() const { return m_seeds; }
  std::size_t number_of_components() const { return m_number_of_components; }

  /// The faces that are reached from each seed.
  Partition regions() const
  {
    Lowest_root_forest forest(m_reached.size());
    for (Index f = 0; f < m_reached.size(); ++f)
      forest.unite(f, m_reached[f].predecessor);
    return forest.take_partition();
  }

private:
  /// What is known of a face, stored together, since faces are accessed at random.
  struct Reached
  {
    double distance;
    Index predecessor; // that of a seed is the seed
  };
  using Entry = std::pair<double, Index>; // distance, face

  void seed_components(const std::vector<double>& remoteness, Step_counter& seeds)
  {
    grow_from(
      std::size_t(std::max_element(remoteness.begin(), remoteness.end()) - remoteness.begin()));
    std::vector<Index> others; // faces that the first seed does not reach
    for (std::size_t f = 0; f < m_reached.size(); ++f)
      if (m_reached[f].distance == unreached)
        others.push_back(Index(f));
    const auto order = sorted_indices(others.size(), [&](Index i, Index j) {
      const double r = remoteness[others[i]], s = remoteness[others[j]];
      return r != s ? r > s : i < j;
    });
    for (const Index i : order)
      if (const Index f = others[i]; m_reached[f].distance == unreached) {
        grow_from(f);
        seeds.advance();
      }
  }

  void grow_from(std::size_t seed)
  {
    place(seed);
    grow();
  }

  void place(std::size_t seed)
  {
    m_reached[seed] = {0, Index(seed)};
    m_seeds.push_back(Index(seed));
    m_front.push(make_float_key(0, Index(seed)));
  }

  /// The front is ordered by distances rounded to float. This cannot change a distance, since a
  /// face whose distance shrinks is pushed again.
  void grow()
  {
    while (!m_front.empty()) {
      const Float_key top = m_front.top();
      m_front.pop();
      const Index face = index_of(top);
      const double distance = m_reached[face].distance;
      if (top != make_float_key(float(distance), face))
        continue;
      for (const auto& step : m_graph.steps(face)) {
        const double longer = distance + double(step.length);
        Reached& next = m_reached[step.face];
        if (longer < next.distance) {
          next = {longer, face};
          m_front.push(make_float_key(float(longer), step.face));
        }
      }
    }
  }

  static constexpr double unreached = (std::numeric_limits<double>::max)();

  Dual_graph m_graph;
  Large_array<Reached> m_reached;
  // The rounded distances of the faces from which steps are to be made.
  std::priority_queue<Float_key, std::vector<Float_key>, std::greater<Float_key>> m_front;
  std::vector<Index> m_seeds; // faces
  std::size_t m_number_of_components = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_FARTHEST_POINT_SEEDING_H
