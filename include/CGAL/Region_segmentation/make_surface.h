// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_MAKE_SURFACE_H
#define CGAL_REGION_SEGMENTATION_MAKE_SURFACE_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/compiled.h>
#include <CGAL/Region_segmentation/internal/support/components.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/internal/surface/collect_adjacencies.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>
#include <CGAL/Region_segmentation/internal/surface/find_links.h>
#include <CGAL/Region_segmentation/internal/surface/match_sides.h>
#include <CGAL/Region_segmentation/internal/surface/orient_components.h>
#include <CGAL/Region_segmentation/internal/surface/read_face_graph.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What is adjacent beyond the neighbors that are known.
enum class Adjacency_of { NEIGHBORS, COINCIDING_SIDES, COMPONENTS };

/// A seam as an adjacency: with the sign of its angle if its faces are oriented consistently; an
/// edge if one of them is degenerate.
inline Added_adjacency adjacency_of_seam(const Surface& surface, const Seam& seam)
{
  const auto side_of = [&](Surface::Index face) {
    return side_between(surface, face, seam.lower_vertex, seam.higher_vertex);
  };
  const Surface::Index lower = (std::min)(seam.face, seam.other_face),
                       higher = (std::max)(seam.face, seam.other_face);
  const Double_3 direction = surface.point(seam.higher_vertex) - surface.point(seam.lower_vertex);
  Added_adjacency result = {lower,
                            higher,
                            seam.share * seam.share * squared_norm(direction),
                            0,
                            side_of(seam.face),
                            side_of(seam.other_face)};
  if (surface.is_degenerate(lower) || surface.is_degenerate(higher))
    return result;
  result.flags = Surface::SEAM;
  const bool is_forward = runs_along(surface, higher, seam.lower_vertex, seam.higher_vertex);
  if (is_forward != runs_along(surface, lower, seam.lower_vertex, seam.higher_vertex))
    result.flags |= sign_of_edge(surface.normal(higher), surface.normal(lower),
                                 (is_forward ? 1.0 : -1.0) * direction);
  return result;
}

/// Adds links between what is not connected by edges and seams, and marks crumbs.
inline void insert_links(Surface& surface, const Execution& execution)
{
  const Partition connected = label_components(
    surface, [](std::size_t) { return true; }, execution.silent());
  insert_adjacencies(surface, find_links(surface, connected, execution));
  mark_crumbs(surface, edge_components(surface, execution.silent()));
}

/// From points and corners to a surface.
/// \tparam wanted what is adjacent; what others need is not compiled
template <Adjacency_of wanted>
Surface build_surface(Raw_surface&& raw, const Execution& execution)
{
  std::vector<Added_adjacency> added;
  std::vector<Seam> seams;
  const bool has_open_sides = std::find(raw.neighbors.begin(), raw.neighbors.end(),
                                        Raw_surface::none) != raw.neighbors.end();
  if constexpr (wanted != Adjacency_of::NEIGHBORS)
    if (has_open_sides)
      merge_points_of_open_sides(raw);
  compute_normals(raw.surface, execution.step(0, 0.3));
  if constexpr (wanted != Adjacency_of::NEIGHBORS)
    if (has_open_sides) {
      find_doubled_faces(raw, added);
      Side_matcher matcher(raw);
      matcher.match();
      seams = matcher.seams();
      orient_faces(raw, matcher.parallel_sides(), seams);
    }
  std::vector<Surface::Index> faces_at_borders; // as long as neighbors are known
  if (has_open_sides)
    faces_at_borders = faces_with_open_sides(raw);
  collect_adjacencies(raw, execution.step(0.3, 0.8));
  raw.neighbors = Large_array<Surface::Index>(); // later steps need the memory
  const Partition component_of = edge_components(raw.surface, execution.step(0.8, 0.9));
  orient_components(raw, component_of, faces_at_borders, seams);
  for (const Seam& seam : seams)
    added.push_back(adjacency_of_seam(raw.surface, seam));
  insert_adjacencies(raw.surface, added);
  join_degenerate_faces(raw.surface);
  if constexpr (wanted == Adjacency_of::COMPONENTS)
    if (component_of.number_of_parts() > 1)
      insert_links(raw.surface, execution.step(0.9, 1));
  sum_up(raw.surface);
  return std::move(raw.surface);
}

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template Surface
build_surface<Adjacency_of::NEIGHBORS>(Raw_surface&&, const Execution&);
CGAL_REGION_SEGMENTATION_EXTERN template Surface
build_surface<Adjacency_of::COINCIDING_SIDES>(Raw_surface&&, const Execution&);
CGAL_REGION_SEGMENTATION_EXTERN template Surface
build_surface<Adjacency_of::COMPONENTS>(Raw_surface&&, const Execution&);
#endif

} // namespace internal

namespace internal {

/// The value of `component_links` in a pack.
template <typename Pack>
bool component_links(const Pack& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::component_links), true);
}

/// With links, or with what is adjacent without them.
template <Adjacency_of unlinked, typename Pack>
Surface build_linked_surface(Raw_surface&& raw, const Pack& np, const Execution& execution)
{
  if constexpr (has_parameter<Pack, internal_np::component_links_t>)
    if (!component_links(np))
      return build_surface<unlinked>(std::move(raw), execution);
  return build_surface<Adjacency_of::COMPONENTS>(std::move(raw), execution);
}

template <typename FaceGraph, typename Pack>
Surface make_surface(const FaceGraph& mesh, const Pack& np, const Execution& execution)
{
  const Execution reading = execution.stage("reading");
  Raw_surface raw = read_face_graph(Mesh_order<FaceGraph, Pack>(mesh, np), np,
                                    reading.step(0, 0.5));
  return build_linked_surface<Adjacency_of::NEIGHBORS>(std::move(raw), np, reading.step(0.5, 1));
}

/// For functions that read a face graph as it is: without links and coinciding borders.
template <typename FaceGraph, typename Pack>
Surface make_surface_of_neighbors(const Mesh_order<FaceGraph, Pack>& order, const Pack& np,
                                  const Execution& execution = Execution())
{
  return build_surface<Adjacency_of::NEIGHBORS>(read_face_graph(order, np, execution.step(0, 0.5)),
                                                execution.step(0.5, 1));
}
/// For single stages: without links.
template <typename FaceGraph, typename Pack>
Surface make_unlinked_surface(const Mesh_order<FaceGraph, Pack>& order, const Pack& np,
                              const Execution& execution)
{
  return build_surface<Adjacency_of::COINCIDING_SIDES>(
    read_face_graph(order, np, execution.step(0, 0.5)), execution.step(0.5, 1));
}

template <typename FaceGraph, typename Pack>
Surface make_surface_of_neighbors(const FaceGraph& mesh, const Pack& np)
{
  return make_surface_of_neighbors(Mesh_order<FaceGraph, Pack>(mesh, np), np);
}

template <typename PointRange, typename PolygonRange, typename Pack>
Surface make_surface_of_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                                     const Pack& np, const Execution& execution)
{
  const Execution reading = execution.stage("reading");
  return build_linked_surface<Adjacency_of::COINCIDING_SIDES>(
    read_polygons(points, polygons, reading.step(0, 0.5)), np, reading.step(0.5, 1));
}

using Surface_parameters = Tag_list<internal_np::component_links_t, CGAL::internal_np::visitor_t>;

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// makes a surface of a face graph.
///
/// Neighbors are those of the graph. Unless `component_links` is `false`, border edges with equal
/// end points are adjacent, too, and components are linked, as those of polygons are.
///
/// An outermost closed component of negative signed volume is inside out: it is turned, together
/// with the closed components inside it. A closed one of negative volume inside another one bounds
/// a void, and stays. Open components are read as they are.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \param mesh its faces are polygons of any size
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///        `component_links`, `visitor` (stage "reading"), `vertex_point_map`, `face_index_map`,
///        `vertex_index_map`; see `segment()`
/// \throws Invalid_input if a point of a face is not finite, Segmentation_cancelled if the visitor
/// cancels
///
/// Complexity: O(F), O(F log F) with several components.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters>
Surface make_surface(const FaceGraph& mesh,
                     const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Surface_parameters>();
  return internal::make_surface(mesh, pack, internal::make_execution<ConcurrencyTag>(pack));
}

/// \ingroup PkgRegionSegmentationData
/// makes a surface of points and polygons. They need not be manifold, oriented, connected or free
/// of duplicates.
///
/// - Points with equal coordinates are one vertex, where they are at a side that has not exactly
/// one partner with the same two indices: closed components keep vertices of their own, as those of
/// a face graph.
/// - Two sides of polygons with the same two vertices are an edge. Where there are more of them,
/// they are seams, see
///   `Surface`, but for those of degenerate faces, which are edges to the lowest other face.
/// - Faces are turned so that neighbors across edges are oriented alike; the orientation of a
/// component is that of the
///   larger area. An edge whose faces cannot be oriented is a seam.
/// - A polygon that was given before, in any orientation, is degenerate, and is adjacent to that
/// one alone.
///
/// Closed components are turned, and components are linked, as those of a face graph.
///
/// \tparam PointRange a range whose value type is a model of `Kernel::Point_3`, or has `operator[]`
///         for its coordinates
/// \tparam PolygonRange a range of ranges of indices of points
/// \throws Invalid_input if a polygon has no corner or one that is not a point, or a point of a
///         polygon is not finite; Segmentation_cancelled if the visitor cancels
///
/// Complexity: O(F log F); O(F) for a connected face graph without borders.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange,
          typename PolygonRange, typename NamedParameters = parameters::Default_named_parameters>
Surface make_surface_of_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                                     const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Surface_parameters>();
  return internal::make_surface_of_polygon_soup(points, polygons, pack,
                                                internal::make_execution<ConcurrencyTag>(pack));
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_MAKE_SURFACE_H
