// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H

#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Superfacets/Border_cost.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds short paths that open every component of every segment to a disc, by a tree and a cotree.
/// Trees of shortest paths grow from all borders, and from the first vertex of each closed
/// component. A spanning tree of the faces crosses edges that are in none of these trees; edges
/// with the longest way to the border, on both sides, come first. The edges that it does not cross
/// are the seams, without paths that end inside a segment. They are 2 g + b - 1 arcs for genus g
/// and b > 0 border loops, and 2 g loops for b = 0. A sphere is opened along a shortest path to the
/// farthest vertex.
///
/// Source: Erickson and Whittlesey 2005; with borders, Erickson and Har-Peled 2004.
class Seam_finder
{
  using Index = Segmented_halfedges::Index;

public:
  /// `cost(halfedge)`: the cost of a seam along a halfedge
  template <typename Cost>
  Seam_finder(const Segmented_halfedges& mesh, const Cost& cost)
    : m_mesh(mesh)
    , m_costs(mesh.size())
    , m_is_seam(mesh.size(), false)
    , m_is_border(mesh.number_of_vertices, false)
    , m_distances(mesh.number_of_vertices, infinity)
    , m_tree(mesh.number_of_vertices, Index(mesh.none))
  {
    for (Index h = 0; h < mesh.size(); ++h)
      if (mesh.is_on_border(h))
        m_is_border[mesh.source[h]] = m_is_border[mesh.target(h)] = true;
      else if (is_one_of_two(h))
        m_costs[h] = m_costs[mesh.opposite[h]] = cost(h);
    m_leaving = Grouped_items<Index>(mesh.number_of_vertices, [&](const auto& add) {
      for (Index h = 0; h < mesh.size(); ++h)
        if (mesh.has_segment(h) && !mesh.is_on_border(h))
          add(mesh.source[h], h);
    });
  }

  /// A halfedge of each seam edge.
  std::vector<Index> find()
  {
    std::vector<Index> vertices;
    for (Index v = 0; v < m_is_border.size(); ++v)
      if (m_is_border[v])
        vertices.push_back(v);
    grow_tree(vertices);
    std::vector<std::vector<Index>> closed_components; // their vertices
    for (Index v = 0; v < m_distances.size(); ++v)
      if (m_distances[v] == infinity && !m_leaving[v].empty())
        closed_components.push_back(grow_tree({v}));
    leave_uncrossed();
    for (Index v = 0; v < m_is_border.size(); ++v)
      prune(v);
    for (const std::vector<Index>& component : closed_components)
      if (std::all_of(component.begin(), component.end(),
                      [&](Index v) { return seams_at(v).empty(); })) // a sphere
        for (Index v = component.back(); v != component.front(); v = m_mesh.source[m_tree[v]])
          set_seam(m_tree[v], true);
    std::vector<Index> seams;
    for (Index h = 0; h < m_mesh.size(); ++h)
      if (m_is_seam[h] && h < m_mesh.opposite[h])
        seams.push_back(h);
    return seams;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Whether a halfedge stands for its edge, which is inside a segment.
  bool is_one_of_two(Index h) const
  {
    return m_mesh.has_segment(h) && !m_mesh.is_on_border(h) && h < m_mesh.opposite[h];
  }

  void set_seam(Index h, bool is_seam) { m_is_seam[h] = m_is_seam[m_mesh.opposite[h]] = is_seam; }

  /// Returns the vertices in the order of their distances.
  std::vector<Index> grow_tree(const std::vector<Index>& sources)
  {
    std::vector<Index> order;
    find_shortest_paths(
      sources, m_distances,
      [&](Index v) {
        order.push_back(v);
        return true;
      },
      [&](Index v, const auto& enter) {
        for (Index h : m_leaving[v])
          if (const Index w = m_mesh.target(h); !m_is_border[w] && enter(w, m_costs[h]))
            m_tree[w] = h;
      });
    return order;
  }

  /// Makes seams of all edges but those that the spanning tree of the faces crosses.
  void leave_uncrossed()
  {
    std::vector<Index> candidates;
    std::vector<double> lengths(m_mesh.size());
    for (Index h = 0; h < m_mesh.size(); ++h)
      if (is_one_of_two(h)) {
        set_seam(h, true);
        lengths[h] = m_distances[m_mesh.source[h]] + m_costs[h] + m_distances[m_mesh.target(h)];
        if (m_tree[m_mesh.target(h)] != h && m_tree[m_mesh.source[h]] != m_mesh.opposite[h])
          candidates.push_back(h);
      }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](Index a, Index b) { return lengths[a] > lengths[b]; });
    Lowest_root_forest faces(m_mesh.number_of_faces());
    for (Index h : candidates)
      set_seam(h, !faces.unite(m_mesh.face[h], m_mesh.face[m_mesh.opposite[h]]));
  }

  std::vector<Index> seams_at(Index v) const
  {
    std::vector<Index> seams;
    std::copy_if(m_leaving[v].begin(), m_leaving[v].end(), std::back_inserter(seams),
                 [&](Index h) { return m_is_seam[h]; });
    return seams;
  }

  /// Removes a path that ends at `v`, inside a segment.
  void prune(Index v)
  {
    for (auto seams = seams_at(v); !m_is_border[v] && seams.size() == 1; seams = seams_at(v)) {
      set_seam(seams[0], false);
      v = m_mesh.target(seams[0]);
    }
  }

  const Segmented_halfedges& m_mesh;
  std::vector<double> m_costs;     // by halfedge inside a segment
  std::vector<char> m_is_seam;     // by halfedge
  std::vector<char> m_is_border;   // by vertex
  std::vector<double> m_distances; // from the border, or from the root; by vertex
  std::vector<Index> m_tree;       // the last halfedge of the shortest path; by vertex
  Grouped_items<Index> m_leaving;  // the halfedges inside a segment; by vertex
};

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// marks the borders between segments, and inside them the seams that open every component of a
/// segment to a disc: the map of seam edges of `CGAL::Seam_mesh`.
///
/// A component of genus \f$g\f$ with \f$b > 0\f$ border loops is opened along \f$2g + b - 1\f$
/// paths from border to border, a closed one of genus \f$g > 0\f$ along \f$2g\f$ loops through a
/// vertex, and a sphere along a shortest path from a vertex to the one farthest from it. A disc has
/// no seam.
/// Paths are those of a shortest path tree and its dual (tree-cotree decomposition): two shortest
/// paths from an edge to the border each.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph`, `VertexListGraph` and
///         `EdgeListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam EdgeIsSeamMap a model of `WritablePropertyMap` with the edge descriptor as key and a
///         value type constructible from `bool`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` are not opened
/// \param edge_is_seam_map every key is written. Edges on the border of the mesh are not marked
/// \param cost the cost of the edges of a seam. By default seams are short, and hidden in valleys
/// of
///        any depth; with a gain of 0 they are as short as possible
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the number of marked edges; more than `mark_segment_borders()` marks if a component of
///          a segment is not a disc
/// \throws Invalid_input if a point is not finite; the map is unchanged
/// \pre `cost.concave_gain >= 0 && cost.maximum_deviation >= 0`
///
/// Complexity: O(F log F). Deterministic: the same edges from every mesh type. Concurrent calls on
/// different maps are safe.
///
/// Source: \cgalCite{EW05}.
template <typename FaceGraph, typename FaceSegmentMap, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t mark_segment_seams(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                               EdgeIsSeamMap edge_is_seam_map,
                               const Border_cost& cost = Border_cost{10, CGAL_PI},
                               const NamedParameters& np = parameters::default_values())
{
  using Value = typename boost::property_traits<EdgeIsSeamMap>::value_type;
  CGAL_precondition(cost.concave_gain >= 0 && cost.maximum_deviation >= 0);
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const auto segmented = internal::read_segmented_mesh(mesh, segment_map, pack);
  const Surface surface = internal::make_surface(mesh, pack, internal::Adjacent::NEIGHBORS,
                                                 Execution());
  internal::Seam_finder finder(segmented, [&](std::uint32_t h) {
    const auto a = internal::adjacency_across(surface, segmented, h);
    return cost(surface.length(a), surface.concave_deviation(a));
  });
  const auto seams = finder.find();
  const std::size_t number_of_borders = mark_segment_borders(mesh, segment_map, edge_is_seam_map);
  for (auto h : seams)
    put(edge_is_seam_map, edge(segmented.halfedges[h], mesh), Value(true));
  return number_of_borders + seams.size();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H
