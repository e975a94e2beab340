// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EVALUATION_CUT_DISCREPANCY_H
#define CGAL_REGION_SEGMENTATION_EVALUATION_CUT_DISCREPANCY_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The end points, in order, of the edges whose two faces have different labels.
template <typename Label>
std::vector<Surface::Index> cut_vertices(const Surface& surface, const std::vector<Label>& labels)
{
  static_assert(std::is_integral<Label>::value, "labels are integral");
  std::vector<char> is_on_cut(surface.number_of_vertices(), false);
  for_each_side_of_surface(surface, [&](auto, Surface::Index v, Surface::Index w, auto a) {
    if (a != Surface::none && labels[surface.lower_face(a)] != labels[surface.higher_face(a)])
      is_on_cut[v] = is_on_cut[w] = true;
  });
  std::vector<Surface::Index> result;
  for (Surface::Index v = 0; v < is_on_cut.size(); ++v)
    if (is_on_cut[v])
      result.push_back(v);
  return result;
}

/// By vertex, the vertices at the other ends of its edges. An edge inside the surface is a side of
/// two faces, one for each direction.
using Edge_graph = Grouped_items<Surface::Index>;

inline Edge_graph edge_graph(const Surface& surface)
{
  return Edge_graph(surface.number_of_vertices(), [&](const auto& add) {
    for_each_side_of_surface(surface, [&](auto, Surface::Index v, Surface::Index w, auto a) {
      add(v, w);
      if (a == Surface::none)
        add(w, v);
    });
  });
}

/// The sum over `targets`, which are different, of the length of the shortest path along edges to
/// the nearest of `sources`; infinite where a target has no path. O(E log E).
inline double sum_of_distances(const Surface& surface, const Edge_graph& graph,
                               const std::vector<Surface::Index>& sources,
                               const std::vector<Surface::Index>& targets)
{
  std::vector<double> distances(graph.number_of_groups(), std::numeric_limits<double>::infinity());
  find_shortest_paths(
    sources, distances, [](Surface::Index) { return true; },
    [&](Surface::Index v, const auto& enter) {
      for (const Surface::Index w : graph[v])
        enter(w, norm(surface.point(v) - surface.point(w)));
    });
  return std::accumulate(targets.begin(), targets.end(), 0.0,
                         [&](double sum, Surface::Index t) { return sum + distances[t]; });
}

/// The mean distance of the surface to its centroid: the centroids of the faces stand for them,
/// weighted by area. 0 where the surface has no area.
inline double mean_distance_to_centroid(const Surface& surface)
{
  if (!(surface.area() > 0))
    return 0;
  double sum = 0;
  Double_3 centroid{0, 0, 0};
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    centroid = centroid + surface.area(f) / surface.area() * surface.centroid(f);
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    sum += surface.area(f) * norm(surface.centroid(f) - centroid);
  return sum / surface.area();
}

} // namespace internal

/// \ingroup PkgRegionSegmentationEvaluation
/// computes the cut discrepancy of two segmentations: the distance of their cuts, in units of the
/// size of the surface.
///
/// The *cut vertices* of a segmentation are the end points of the edges whose two faces have
/// different labels; borders of the mesh are no cuts. With \f$V_a\f$ and \f$V_b\f$ the cut vertices
/// of the two segmentations and d the length of the shortest path along edges of the mesh,
///
/// \f[ CD = \frac{1}{R \, (|V_a| + |V_b|)} \Big(\sum_{v \in V_a} \min_{w \in V_b} d(v, w) +
///     \sum_{w \in V_b} \min_{v \in V_a} d(v, w)\Big), \f]
///
/// where R is the mean distance of the surface to its centroid (the means of the corners of the
/// faces stand for them, weighted by area). CD has no unit and does not change with the scale of
/// the mesh.
///
/// The range is [0, infinity): 0 if and only if the cut vertices are the same (edges of length 0
/// aside). Symmetric, to the bit. It is undefined if one segmentation has no cut (so on a mesh with
/// no face or one), if a cut vertex has no path to the cuts of the other (on a mesh with several
/// components), and if the surface has no area.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam FaceLabelMapA a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type
/// \tparam FaceLabelMapB the same
/// \param mesh a mesh, with or without boundary, of faces of any size; the area of a face that is
///        not planar is the length of its area vector (Newell)
/// \param a the first segmentation; labels may be sparse or negative
/// \param b the second one; its labels need not be those of `a`
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the cut discrepancy, or none if it is undefined
/// \pre the mesh has fewer than 2^32 - 1 vertices and faces
/// \throws Invalid_input if a point is not finite
///
/// Complexity: O(F log F) time, one shortest-path run (Dijkstra, from all cut vertices) for each
/// side, and O(F) memory, F including the vertices. Coordinates do not overflow. Deterministic.
/// Read-only; concurrent calls are safe if reading the maps is.
///
/// Source: \cgalCite{CGF09}, \cgalCite{HD95}. Distances there are
/// geodesic; the benchmark's evaluator measures along edges, and so does this function.
template <typename FaceGraph, typename FaceLabelMapA, typename FaceLabelMapB,
          typename NamedParameters = parameters::Default_named_parameters>
std::optional<double> cut_discrepancy(const FaceGraph& mesh, const FaceLabelMapA& a,
                                      const FaceLabelMapB& b,
                                      const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const Surface surface = internal::surface_as_given(mesh, pack);
  const auto cut_a = internal::cut_vertices(surface, face_values(mesh, a)),
             cut_b = internal::cut_vertices(surface, face_values(mesh, b));
  const double size = internal::mean_distance_to_centroid(surface);
  if (cut_a.empty() || cut_b.empty() || size == 0)
    return std::nullopt;

  const internal::Edge_graph graph = internal::edge_graph(surface);
  const double sum = internal::sum_of_distances(surface, graph, cut_b, cut_a) +
                     internal::sum_of_distances(surface, graph, cut_a, cut_b);
  if (!std::isfinite(sum))
    return std::nullopt;
  return sum / (size * double(cut_a.size() + cut_b.size()));
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EVALUATION_CUT_DISCREPANCY_H
