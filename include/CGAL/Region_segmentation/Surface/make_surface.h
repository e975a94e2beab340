// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_MAKE_SURFACE_H
#define CGAL_REGION_SEGMENTATION_SURFACE_MAKE_SURFACE_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Support/version.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/collect_adjacencies.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>
#include <CGAL/Region_segmentation/Surface/internal/find_links.h>
#include <CGAL/Region_segmentation/Surface/internal/match_sides.h>
#include <CGAL/Region_segmentation/Surface/internal/orient_components.h>
#include <CGAL/Region_segmentation/Surface/internal/read_surface.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Which adjacencies a surface has: those of neighbors in the input, also those across coinciding
/// sides, or also links between components.
enum class Adjacency_of { NEIGHBORS, COINCIDING_SIDES, COMPONENTS };

/// Makes a surface of points and corners. This is a template so that `extern template` keeps it out
/// of a translation unit.
/// \tparam Raw `Raw_surface`
template <typename Raw>
Surface build_surface(Raw raw, Adjacency_of wanted, const Execution& execution)
{
  Surface& surface = raw.surface;
  std::vector<Added_adjacency> added;
  const bool is_open = wanted != Adjacency_of::NEIGHBORS &&
                       std::find(raw.neighbors.begin(), raw.neighbors.end(), Raw::none) !=
                         raw.neighbors.end();
  if (is_open)
    merge_points_of_open_sides(raw);
  compute_normals(surface, execution.step(0, 0.3));
  if (is_open) {
    find_doubled_faces(raw, added);
    const std::vector<bool> is_parallel = Side_matcher(raw, added).match();
    orient_faces(raw, is_parallel, added);
  }
  collect_adjacencies(raw, execution.step(0.3, 0.8));
  raw.neighbors = Large_array<Surface::Index>(); // the next steps need the memory
  insert_adjacencies(surface, added);
  arrays_of(surface).component_of = edge_components(surface, execution.step(0.8, 0.9));
  if (orient_components(surface) || surface.has_seams_or_links())
    set_signs(surface);
  join_degenerate_faces(surface);
  if (wanted == Adjacency_of::COMPONENTS && surface.number_of_components() > 1)
    insert_links(surface, execution.step(0.9, 1));
  sum_up(surface);
  return std::move(surface);
}

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template Surface build_surface(Raw_surface, Adjacency_of,
                                                               const Execution&);
#endif

/// The value of `component_links` in a pack.
template <typename Pack>
bool component_links(const Pack& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::component_links), true);
}

template <typename FaceGraph, typename Pack>
Surface make_surface(const Mesh_order<FaceGraph, Pack>& order, const Pack& np, Adjacency_of wanted,
                     const Execution& execution)
{
  return build_surface(read_face_graph(order, np, execution.step(0, 0.5)), wanted,
                       execution.step(0.5, 1));
}

template <typename FaceGraph, typename Pack>
Surface make_surface(const FaceGraph& mesh, const Pack& np, const Execution& execution)
{
  return make_surface(Mesh_order<FaceGraph, Pack>(mesh, np), np,
                      component_links(np) ? Adjacency_of::COMPONENTS : Adjacency_of::NEIGHBORS,
                      execution.stage("reading"));
}

/// The surface of a face graph as it is: without links, and with borders where they coincide.
template <typename FaceGraph, typename Pack>
Surface make_surface_of_neighbors(const FaceGraph& mesh, const Pack& np)
{
  return make_surface(Mesh_order<FaceGraph, Pack>(mesh, np), np, Adjacency_of::NEIGHBORS,
                      Execution());
}

template <typename PointRange, typename PolygonRange, typename Pack>
Surface make_surface_of_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                                     const Pack& np, const Execution& execution)
{
  const Execution reading = execution.stage("reading");
  return build_surface(read_polygons(points, polygons, reading.step(0, 0.5)),
                       component_links(np) ? Adjacency_of::COMPONENTS
                                           : Adjacency_of::COINCIDING_SIDES,
                       reading.step(0.5, 1));
}

using Surface_parameters = Tag_list<internal_np::component_links_t, CGAL::internal_np::visitor_t>;

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// makes a surface of a face graph.
///
/// Neighbors are those of the graph. Unless `component_links` is `false`, faces at border edges
/// with equal end points are adjacent, too, and components are linked, as those of polygons are.
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
/// - Points with equal coordinates are one vertex if they are at a side that has not exactly one
///   partner with the same two indices. So closed components keep vertices of their own, as those
///   of a face graph.
/// - Two sides of polygons with the same two vertices are an edge. More than two sides are seams,
///   see `Surface`; but the sides of degenerate faces among them are edges to the lowest other
///   face.
/// - Faces are turned so that neighbors across edges are oriented alike; the orientation of a
///   component is that of the larger area. An edge whose faces cannot be oriented is a seam.
/// - A polygon with the sides of a lower one, in any orientation, is degenerate, and is adjacent to
///   that one alone.
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

#endif // CGAL_REGION_SEGMENTATION_SURFACE_MAKE_SURFACE_H
