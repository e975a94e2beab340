// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H

#include <CGAL/Region_segmentation/Border_cost.h>
#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_borders.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/support/components.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds short paths that open every component of every segment to a disc, all at once, by tree and
/// cotree: shortest path trees grow from all borders, and from the first vertex of each closed
/// component; a spanning tree of the faces crosses edges that are in none of them, those first
/// whose detour to the border is longest. The edges that it does not cross are the seams, without
/// those that lead nowhere: 2 g + b - 1 arcs for genus g and b > 0 loops, or 2 g loops.
///
/// A sphere is opened along a shortest path, to the farthest vertex.
///
/// Source: Erickson and Whittlesey 2005; with borders, Erickson and Har-Peled 2004.
class Seam_finder
{
  using Index = Halfedge_table::Index;

public:
  /// `cost(halfedge)`: of a seam along it.
  template <typename Cost>
  Seam_finder(const Segmented_halfedges& mesh, const Cost& cost)
    : m_mesh(mesh)
    , m_is_border(mesh.number_of_vertices, false)
    , m_distances(mesh.number_of_vertices, infinity)
    , m_tree_edge(mesh.number_of_vertices, Index(none))
  {
    for (Index h = 0; h < mesh.size(); ++h)
      if (mesh.is_on_border(h))
        m_is_border[mesh.source[h]] = m_is_border[mesh.target(h)] = true;
      else if (h < mesh.opposite[h] && mesh.segment(h) != none) {
        m_edges.push_back({{mesh.source[h], mesh.target(h)}, h, cost(h)});
      }
    m_edges_at = Grouped_items<Index>(mesh.number_of_vertices, [&](const auto& add) {
      for (Index e = 0; e < m_edges.size(); ++e)
        for (Index v : m_edges[e].vertices)
          add(v, e);
    });
    m_is_seam.assign(m_edges.size(), false);
  }

  /// A halfedge of each seam edge.
  std::vector<Index> find()
  {
    std::vector<Index> vertices;
    for (Index v = 0; v < m_is_border.size(); ++v)
      if (m_is_border[v])
        vertices.push_back(v);
    grow_tree(vertices);
    std::vector<std::vector<Index>> closed_components; // by their trees
    for (Index v = 0; v < m_distances.size(); ++v)
      if (m_distances[v] == infinity && !m_edges_at[v].empty())
        closed_components.push_back(grow_tree({v}));
    leave_uncrossed();
    for (Index v = 0; v < m_is_border.size(); ++v)
      prune(v);
    for (const std::vector<Index>& component : closed_components)
      if (std::all_of(component.begin(), component.end(),
                      [&](Index v) { return seams_at(v).empty(); }))
        open_sphere(component);
    std::vector<Index> seams;
    for (Index e = 0; e < m_edges.size(); ++e)
      if (m_is_seam[e])
        seams.push_back(m_edges[e].halfedge);
    return seams;
  }

private:
  static constexpr Index none = Halfedge_table::none;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// An edge inside a segment.
  struct Inner_edge
  {
    Index vertices[2], halfedge;
    double cost;
  };

  Index other_end(Index edge, Index vertex) const
  {
    const Inner_edge& e = m_edges[edge];
    return e.vertices[0] == vertex ? e.vertices[1] : e.vertices[0];
  }

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
        for (Index e : m_edges_at[v])
          if (const Index w = other_end(e, v); !m_is_border[w] && enter(w, m_edges[e].cost))
            m_tree_edge[w] = e;
      });
    return order;
  }

  /// Makes seams of all edges but those that the spanning tree of the faces crosses.
  void leave_uncrossed()
  {
    std::vector<Index> candidates;
    std::vector<double> lengths(m_edges.size());
    for (Index e = 0; e < m_edges.size(); ++e) {
      const auto& [v, w] = m_edges[e].vertices;
      m_is_seam[e] = true;
      lengths[e] = m_distances[v] + m_edges[e].cost + m_distances[w];
      if (m_tree_edge[v] != e && m_tree_edge[w] != e)
        candidates.push_back(e);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](Index a, Index b) { return lengths[a] > lengths[b]; });
    Lowest_root_forest faces(m_mesh.number_of_faces());
    for (Index e : candidates) {
      const Index h = m_edges[e].halfedge;
      m_is_seam[e] = !faces.unite(m_mesh.face[h], m_mesh.face[m_mesh.opposite[h]]);
    }
  }

  std::vector<Index> seams_at(Index v) const
  {
    std::vector<Index> seams;
    for (Index e : m_edges_at[v])
      if (m_is_seam[e])
        seams.push_back(e);
    return seams;
  }

  /// Removes a path that ends at `v`, inside a segment.
  void prune(Index v)
  {
    for (auto seams = seams_at(v); !m_is_border[v] && seams.size() == 1; seams = seams_at(v)) {
      m_is_seam[seams[0]] = false;
      v = other_end(seams[0], v);
    }
  }

  /// Along the path to the farthest vertex; along at least two edges, where there are: one alone
  /// would give a border of two vertices.
  void open_sphere(const std::vector<Index>& component)
  {
    const Index root = component.front(), farthest = component.back();
    for (Index v = farthest; v != root; v = other_end(m_tree_edge[v], v))
      m_is_seam[m_tree_edge[v]] = true;
    for (Index e : m_edges_at[farthest])
      if (other_end(m_tree_edge[farthest], farthest) == root && other_end(e, farthest) != root) {
        m_is_seam[e] = true;
        return;
      }
  }

  const Segmented_halfedges& m_mesh;
  std::vector<Inner_edge> m_edges;
  Grouped_items<Index> m_edges_at; // by vertex
  std::vector<char> m_is_border;   // by vertex
  std::vector<double> m_distances; // from the border, or from the root; by vertex
  std::vector<Index> m_tree_edge;  // towards it
  std::vector<char> m_is_seam;     // by edge
};

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// marks the borders between segments, and inside them the seams that open every component of a
/// segment to a disc: the map of seam edges of `CGAL::Seam_mesh`.
///
/// A component of genus \f$g\f$ with \f$b > 0\f$ border loops is opened along \f$2g + b - 1\f$
/// paths from border to border, a closed one of genus \f$g > 0\f$ along \f$2g\f$ loops through a
/// vertex, and a sphere along a path between two vertices far from each other. A disc has no seam.
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
/// \param cost of the edges of a seam: so seams are short, and hidden in valleys of any depth; as
///        short as possible with a gain of 0
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
  const internal::Segmented_mesh segmented(mesh, segment_map, pack);
  const Surface surface = internal::make_surface_of_neighbors(mesh, pack);
  internal::Seam_finder finder(segmented, [&](std::uint32_t h) {
    return cost(norm(internal::direction(segmented, surface, h)),
                (std::max)(0.0, -internal::signed_deviation(segmented, surface, h)));
  });
  const auto seams = finder.find();
  const std::size_t number_of_borders = mark_segment_borders(mesh, segment_map, edge_is_seam_map);
  for (auto h : seams)
    put(edge_is_seam_map, edge(segmented.descriptors[h], mesh), Value(true));
  return number_of_borders + seams.size();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H
