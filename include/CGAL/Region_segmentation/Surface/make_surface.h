// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_MAKE_SURFACE_H
#define CGAL_REGION_SEGMENTATION_SURFACE_MAKE_SURFACE_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Support/version.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Face_graph_input.h>
#include <CGAL/Region_segmentation/Surface/internal/Mesh_order.h>
#include <CGAL/Region_segmentation/Surface/internal/Polygon_input.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/collect_adjacencies.h>
#include <CGAL/Region_segmentation/Surface/internal/find_links.h>
#include <CGAL/Region_segmentation/Surface/internal/orient_faces.h>
#include <CGAL/Region_segmentation/Surface/internal/sew_sides.h>
#include <CGAL/Region_segmentation/Surface/internal/voids.h>

#include <CGAL/tags.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Which faces are adjacent: neighbors in the input, also those at coinciding sides, or also linked
/// components.
enum class Adjacent { NEIGHBORS, AT_COINCIDING_SIDES, LINKED_COMPONENTS };

/// Makes a surface of what a builder has read. This is a template so that `extern template` keeps
/// it out of a translation unit. \tparam Builder `Surface_builder`
template <typename Builder>
Surface build_surface(Builder builder, Adjacent adjacent, const Execution& execution)
{
  const bool is_sewn = adjacent != Adjacent::NEIGHBORS && builder.has_open_sides();
  if (is_sewn)
    builder.merge_vertices_of_open_sides();
  builder.compute_normals(execution.step(0, 0.3));
  if (is_sewn) {
    builder.separate_doubled_faces();
    builder.match_open_sides();
    builder.orient_faces();
  }
  builder.collect_adjacencies(execution.step(0.3, 0.9));
  const std::optional<Voids> voids = builder.orient_components();
  if (adjacent == Adjacent::LINKED_COMPONENTS) {
    if (voids)
      builder.link_voids(*voids, execution.step(0.9, 0.95));
    builder.link_components(execution.step(0.95, 1));
  }
  return builder.finish();
}

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template Surface build_surface(Surface_builder, Adjacent,
                                                               const Execution&);
#endif

/// The value of `component_links` in a pack.
template <typename Pack>
bool component_links(const Pack& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::component_links), true);
}

/// Which faces of a face graph are adjacent for a function that does not use links.
template <typename Pack>
Adjacent without_links(const Pack& np)
{
  return component_links(np) ? Adjacent::AT_COINCIDING_SIDES : Adjacent::NEIGHBORS;
}

/// Which faces of a face graph are adjacent for a segmentation.
template <typename Pack>
Adjacent with_links(const Pack& np)
{
  return component_links(np) ? Adjacent::LINKED_COMPONENTS : Adjacent::NEIGHBORS;
}

/// Makes a surface of a face graph, without constraints.
template <typename FaceGraph, typename Pack>
Surface make_surface(const FaceGraph& mesh, const Pack& np, Adjacent adjacent,
                     const Execution& execution)
{
  Surface_builder builder;
  builder.read_face_graph(Mesh_order<FaceGraph, Pack>(mesh, np), np, execution.step(0, 0.5));
  return build_surface(std::move(builder), adjacent, execution.step(0.5, 1));
}

/// Makes the surface of a face graph for a segmentation.
template <typename FaceGraph, typename Pack>
Surface make_surface(const FaceGraph& mesh, const Pack& np, const Execution& execution)
{
  return make_surface(mesh, np, with_links(np), execution.stage("reading"));
}

/// Makes a surface of a face graph that knows the adjacencies by the sides of the mesh, with its
/// constraints.
template <typename FaceGraph, typename Pack>
Surface make_surface_with_sides(const FaceGraph& mesh, const Pack& np, const Execution& execution)
{
  const Execution reading = execution.stage("reading");
  Surface_builder builder;
  builder.keep_sides_of_mesh();
  builder.read_face_graph(Mesh_order<FaceGraph, Pack>(mesh, np), np, reading.step(0, 0.5));
  return constrained(Face_graph_input<FaceGraph>(mesh),
                     build_surface(std::move(builder), with_links(np), reading.step(0.5, 1)), np);
}

/// The surface of a face graph as it is: no side is sewn, nothing is turned or linked.
template <typename FaceGraph, typename Pack>
Surface surface_as_given(const FaceGraph& mesh, const Pack& np)
{
  Surface_builder builder;
  builder.read_face_graph(Mesh_order<FaceGraph, Pack>(mesh, np), np, Execution());
  builder.compute_normals(Execution());
  builder.collect_adjacencies(Execution());
  return builder.finish();
}

template <typename PointRange, typename PolygonRange, typename Pack>
Surface make_surface_of_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                                     const Pack& np, const Execution& execution)
{
  const Execution reading = execution.stage("reading");
  Surface_builder builder;
  builder.read_polygons(points, polygons, reading.step(0, 0.5));
  return build_surface(std::move(builder),
                       component_links(np) ? Adjacent::LINKED_COMPONENTS
                                           : Adjacent::AT_COINCIDING_SIDES,
                       reading.step(0.5, 1));
}

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// makes a surface of a face graph.
///
/// Neighbors are those of the graph. Unless `component_links` is `false`, faces at border edges
/// with equal end points are adjacent, too, and components are linked, as those of polygons are.
///
/// End points are equal, too, if their coordinates differ by at most \f$2^{-22}\f$ of the largest
/// coordinate of the surface, the rounding of single precision, and by at most a tenth of the
/// shortest border edge at them. `Surface::number_of_vertices_apart_by_rounding()` counts these.
///
/// An outermost closed component of negative signed volume is inside out: it is turned, together
/// with the closed components inside it. A closed one of negative volume inside another one, its
/// *body*, bounds a *void*, and stays; if components are linked, each of its faces has a link to
/// the nearest face of the body. Open components are read as they are.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; also of
///         `EdgeListGraph` where there is an `edge_is_constrained_map`
/// \param mesh its faces are polygons of any size
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///        `edge_is_constrained_map`, `component_links`, `visitor` (stage "reading"),
///        `vertex_point_map`, `face_index_map`, `vertex_index_map`; see `segment()`
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
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Reading_parameters>();
  return internal::make_surface_with_sides(mesh, pack,
                                           internal::make_execution<ConcurrencyTag>(pack));
}

/// \ingroup PkgRegionSegmentationData
/// makes a surface of points and polygons. They need not be manifold, oriented, connected or free
/// of duplicates.
///
/// - Points with equal coordinates, or that are apart by rounding as those of a face graph, are one
///   vertex if they are at a side that has not exactly one partner with the same two indices. So
///   closed components keep vertices of their own, as those of a face graph.
/// - Two sides of polygons with the same two vertices are an edge. More than two sides are seams,
///   see `Surface`; but the sides of degenerate faces among them are edges to the lowest other
///   face.
/// - Faces are turned so that neighbors across edges are oriented alike; the orientation of a
///   component is that of the larger area. An edge whose faces cannot be oriented is a seam.
/// - A polygon with the sides of a lower one, in any orientation, is degenerate, and is adjacent to
///   that one alone; but where two bodies touch, a face of each on the same points, both remain.
///
/// Closed components are turned, and components are linked, as those of a face graph.
///
/// \tparam PointRange a range whose value type is a model of `Kernel::Point_3`, or has `operator[]`
///         for its coordinates
/// \tparam PolygonRange a range of ranges of indices of points
/// \param points, polygons the points, and the polygons of their indices
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///        `constrained_edges`, `component_links`, `visitor` (stage "reading"); see
///        `segment_polygon_soup()`
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
  internal::check_parameters<
    std::decay_t<decltype(pack)>,
    internal::Tag_list<internal_np::component_links_t, internal_np::constrained_edges_t,
                       CGAL::internal_np::visitor_t>>();
  Surface surface = internal::make_surface_of_polygon_soup(
    points, polygons, pack, internal::make_execution<ConcurrencyTag>(pack));
  const internal::Polygon_input input(surface.number_of_faces());
  return internal::constrained(input, std::move(surface), pack);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_MAKE_SURFACE_H
