// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_JOIN_BY_CURVATURE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_JOIN_BY_CURVATURE_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/part_faces/Face_curvatures.h>
#include <CGAL/Region_segmentation/internal/part_faces/Face_search.h>
#include <CGAL/Region_segmentation/internal/part_faces/surface_evidence.h>
#include <CGAL/Region_segmentation/internal/support/components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Joins regions across the border where the curvature jumps least, while it jumps little.
///
/// The jump across a border is the sum of those across its edges, by length and with their signs,
/// so that errors cancel, as a share of their scale. The fewer faces a region has, the less is
/// known of its curvature: of n, the jump counts n / (n + 3).
class Curvature_joiner
{
public:
  using Index = Surface::Index;

  struct Border
  {
    double jump = 0, scale = 0;
    bool is_smooth = false; ///< at some edge

    void add(const Border& other, double sign)
    {
      jump += sign * other.jump;
      scale += other.scale;
      is_smooth = is_smooth || other.is_smooth;
    }
  };

  explicit Curvature_joiner(std::size_t regions)
    : m_regions(regions)
    , m_parents(regions)
  {
    std::iota(m_parents.begin(), m_parents.end(), Index(0));
  }

  /// Counts a face. Regions to which a surface is fitted are not joined to each other, and count
  /// many, since more is known of their curvature.
  void add_face(Index region, bool is_fitted)
  {
    m_regions[region].faces += is_fitted ? 100 : 1;
    m_regions[region].is_fitted = is_fitted;
  }

  /// Adds an edge between two regions; its jump is positive if the first is curved more.
  void add_edge(Index a, Index b, const Border& edge)
  {
    m_regions[a].borders[b].add(edge, 1);
    m_regions[b].borders[a].add(edge, -1);
  }

  void join()
  {
    constexpr double little = 0.65;
    for (Index a = 0; a < m_regions.size(); ++a)
      for (const auto& neighbor : m_regions[a].borders)
        if (a < neighbor.first)
          push(a, neighbor.first, neighbor.second);
    while (!m_queue.empty()) {
      const Candidate next = m_queue.top();
      m_queue.pop();
      const auto found = m_regions[next.a].borders.find(next.b);
      if (found != m_regions[next.a].borders.end() &&
          jump(next.a, next.b, found->second) == next.jump) {
        if (next.jump >= little)
          return;
        join(next.a, next.b);
      }
    }
  }

  /// Joins two current regions.
  void join(Index a, Index b)
  {
    if (m_regions[a].borders.size() < m_regions[b].borders.size())
      std::swap(a, b);
    Region &kept = m_regions[a], &removed = m_regions[b];
    m_parents[b] = a;
    // Borders between fitted regions were not queued.
    const std::size_t faces_before = kept.is_fitted ? 0 : kept.faces;
    kept.faces += removed.faces;
    kept.is_fitted = false;
    kept.is_joined = true;
    kept.borders.erase(b);
    removed.borders.erase(a);
    for (const auto& neighbor : removed.borders) {
      Region& other = m_regions[neighbor.first];
      other.borders.erase(b);
      Border& border = kept.borders[neighbor.first];
      border.add(neighbor.second, 1);
      other.borders[a].add(neighbor.second, -1);
      push(a, neighbor.first, border);
    }
    removed.borders.clear();
    for (const auto& neighbor : kept.borders)
      if (m_regions[neighbor.first].faces > faces_before) // else its jump is as before
        push(a, neighbor.first, neighbor.second);
  }

  /// The region that `region` belongs to now.
  Index current(Index region) { return root_in_forest(m_parents, region); }

  /// Whether a current region was joined with others.
  bool is_joined(Index region) const { return m_regions[region].is_joined; }
  bool is_fitted(Index region) const { return m_regions[region].is_fitted; }
  std::size_t faces(Index region) const { return m_regions[region].faces; }

private:
  struct Region
  {
    std::map<Index, Border> borders; // by neighbor
    std::size_t faces = 0;           // a fitted one counts as many
    bool is_fitted = false, is_joined = false;
  };

  struct Candidate
  {
    double jump;
    Index a, b;
    bool operator<(const Candidate& c) const
    {
      return std::tie(jump, a, b) > std::tie(c.jump, c.a, c.b);
    }
  };

  double jump(Index a, Index b, const Border& border) const
  {
    constexpr double uncertain = 3; // faces
    const double n = double((std::min)(m_regions[a].faces, m_regions[b].faces));
    return border.scale > 0 ? std::fabs(border.jump) / border.scale * (n / (n + uncertain)) : 0;
  }

  void push(Index a, Index b, const Border& border)
  {
    if (border.is_smooth && !(m_regions[a].is_fitted && m_regions[b].is_fitted))
      m_queue.push({jump(a, b, border), (std::min)(a, b), (std::max)(a, b)});
  }

  std::vector<Region> m_regions;
  std::vector<Index> m_parents;
  std::priority_queue<Candidate> m_queue;
};

/// Joins single faces that no edge joins smoothly to others, such as those of folds, to the larger
/// freeform region with the longest common edge, and then those beside them.
inline void join_single_faces(const Face_search& search, const std::vector<Surface::Index>& regions,
                              Curvature_joiner& joiner)
{
  using Index = Surface::Index;
  const auto is_single = [&](Index f) {
    return regions[f] != Face_search::none && joiner.faces(joiner.current(regions[f])) == 1;
  };
  std::vector<std::pair<Index, Index>> joined;
  do {
    joined.clear();
    for (Index f = 0; f < regions.size(); ++f) {
      if (!is_single(f))
        continue;
      double longest = 0;
      Index neighbor = f;
      for (const Face_neighbors::Neighbor& n : search.neighbors[f])
        if (regions[n.face] != Face_search::none && !is_single(n.face) &&
            !joiner.is_fitted(joiner.current(regions[n.face])) &&
            search.surface.length(n.adjacency) > longest) {
          longest = search.surface.length(n.adjacency);
          neighbor = n.face;
        }
      if (neighbor != f)
        joined.push_back({regions[f], regions[neighbor]});
    }
    for (const auto& pair : joined)
      joiner.join(joiner.current(pair.first), joiner.current(pair.second));
  } while (!joined.empty());
}

/// The faces of the mesh that `join_by_curvature()` joins: regions of one face where no surface was
/// found, of all faces of a label elsewhere; none on surfaces of strong evidence.
struct Free_regions
{
  using Index = Surface::Index;

  std::vector<Evidence> evidence;    ///< by label
  std::vector<std::uint8_t> is_free; ///< by face
  std::vector<Index> of_faces;       ///< or none
  std::vector<Index> label_of_region;

  explicit Free_regions(const Face_search& search)
    : evidence(evidence_of_surfaces(search))
    , is_free(search.labels.size())
    , of_faces(search.labels.size(), Face_search::none)
  {
    std::vector<Index> of_label(search.surfaces.size(), Face_search::none);
    for (Index f = 0; f < is_free.size(); ++f) {
      const Index label = search.labels[f];
      is_free[f] = evidence[label] != Evidence::STRONG;
      if (!is_free[f])
        continue;
      if (search.surfaces[label].kind == Surface_kind::FREEFORM ||
          of_label[label] == Face_search::none) {
        of_label[label] = Index(label_of_region.size());
        label_of_region.push_back(label);
      }
      of_faces[f] = of_label[label];
    }
  }
};

/// Adds faces and edges of free regions.
inline void fill(Curvature_joiner& joiner, const Face_search& search, const Free_regions& regions)
{
  using Index = Surface::Index;
  for (Index f = 0; f < search.labels.size(); ++f)
    if (regions.is_free[f])
      joiner.add_face(regions.of_faces[f], regions.evidence[search.labels[f]] == Evidence::WEAK);
  const Face_curvatures curvatures(search, regions.is_free);
  for_each_border(search.surface, regions.of_faces, [&](std::size_t a, Index i, Index j) {
    if (i == Face_search::none || j == Face_search::none)
      return;
    const double length = search.surface.length(a);
    Curvature_joiner::Border edge{length, length, search.neighbors.may_be_smooth(a)};
    if (edge.is_smooth) {
      const Face_curvatures::Jump jump = curvatures(a);
      edge.jump = length * jump.difference / jump.scale;
    }
    joiner.add_edge(i, j, edge);
  });
}

/// Divides what fits no surface into freeform faces, at the borders across which its curvature
/// jumps, as between a fillet and a wall. Surfaces of weak evidence become places of freeform faces
/// beside them if the curvature does not jump there.
inline void join_by_curvature(Face_search& search)
{
  using Index = Surface::Index;
  const Free_regions regions(search);
  Curvature_joiner joiner(regions.label_of_region.size());
  fill(joiner, search, regions);
  joiner.join();
  join_single_faces(search, regions.of_faces, joiner);

  std::vector<Index> labels(regions.label_of_region.size(), Face_search::none); // by region
  for (Index f = 0; f < search.labels.size(); ++f)
    if (regions.is_free[f]) {
      const Index region = joiner.current(regions.of_faces[f]);
      if (labels[region] == Face_search::none) {
        labels[region] = Index(search.surfaces.size());
        const Fitted_surface<> own = search.surfaces[regions.label_of_region[region]];
        search.surfaces.push_back(joiner.is_joined(region) ? Fitted_surface<>() : own);
      }
      search.labels[f] = labels[region];
    }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PART_FACES_JOIN_BY_CURVATURE_H
