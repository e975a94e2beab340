// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_FIND_PART_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_FIND_PART_FACES_H

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Part_faces/find_common_surfaces.h>
#include <CGAL/Region_segmentation/Part_faces/find_surface_faces.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Kernel>
void add_neighbors(const Surface& surface, const Surface_faces& faces,
                   std::vector<Part_face<Kernel>>& result)
{
  auto graph = build_region_adjacency_graph<Surface_face_region_data, Surface_face_section_data>(
    surface, faces.partition);
  annotate_surface_faces(graph, surface, faces.partition, faces);
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto section = *range.first;
    const std::size_t a = source(section, graph), b = target(section, graph);
    const double length = surface.unit() * surface.length_unit() * graph[section].length;
    result[a].neighbors.push_back({b, length, graph[section].is_smooth()});
    result[b].neighbors.push_back({a, length, graph[section].is_smooth()});
  }
  for (Part_face<Kernel>& face : result)
    std::sort(face.neighbors.begin(), face.neighbors.end(),
              [](const auto& s, const auto& t) { return s.face < t.face; });
}

/// The faces in units of the mesh.
template <typename Kernel>
std::vector<Part_face<Kernel>> part_faces(const Surface& surface, const Surface_faces& faces)
{
  const double unit = surface.unit();
  const std::vector<Partition::Index> surfaces = find_common_surfaces(surface, faces),
                                      axes = find_common_axes(faces);
  std::vector<Part_face<Kernel>> result(faces.surfaces.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    Part_face<Kernel>& face = result[i];
    face.surface = scaled<Kernel>(faces.surfaces[i], unit);
    face.role = faces.roles[i];
    face.first_on_surface = surfaces[i];
    face.first_on_axis = axes[i];
  }
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    result[faces.partition[f]].area += unit * (unit * surface.area(f));
  add_neighbors(surface, faces, result);
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// finds the faces of a machine part, with the surface, role and neighbors of each: see
/// `find_surface_faces()`, which takes any `Surface`.
///
/// `#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>`, which requires Eigen.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam PartFaceMap a model of `WritablePropertyMap` with the face descriptor as key and an
///         integral value type that holds the number of faces of the part
/// \tparam PartFaceOutputIterator a model of `OutputIterator` that takes `Part_face<Kernel>`:
///         `Kernel` is the kernel of the points, `CGAL::Kernel_traits<Point>::Kernel` where `Point`
///         is the value type of the vertex point map; `CGAL::Simple_cartesian<double>` if that has
///         none
/// \param mesh its faces are polygons of any size
/// \param part_face_map every key is written: the face of the part, 0 .. n-1, numbered by the first
///        face of the mesh
/// \param part_faces receives the faces of the part, in this order
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{the largest distance of a vertex from its surface, in units of the
///                           mesh}
///     \cgalParamType{a number type that is converted to `double`}
///     \cgalParamDefault{0: found from the mesh}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the number n of faces of the part
/// \throws Invalid_input if a point is not finite; Segmentation_cancelled if the visitor cancels;
///         the map is unchanged
///
/// Complexity: near linear in the number of faces of the mesh. Deterministic: the same numbers from
/// every mesh type. Read-only; concurrent calls on different maps are safe.
///
/// \pre `tolerance` is at least 0
template <typename FaceGraph, typename PartFaceMap, typename PartFaceOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t find_part_faces(const FaceGraph& mesh, PartFaceMap part_face_map,
                            PartFaceOutputIterator part_faces,
                            const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::check_face_map<PartFaceMap, FaceGraph>());
  const auto& pack = internal::pack(np);
  using Pack = std::decay_t<decltype(pack)>;
  internal::check_parameters<
    Pack, internal::Tag_list<internal_np::tolerance_t, CGAL::internal_np::visitor_t>>();
  using Kernel = internal::Kernel_of_points<
    typename GetVertexPointMap<FaceGraph, Pack>::const_type>;
  const Execution execution = internal::make_execution<CGAL::Sequential_tag>(pack);
  const Surface surface = internal::make_surface(mesh, pack, execution);
  const double tolerance = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(pack, internal_np::tolerance), 0.0);
  const Surface_faces found = find_surface_faces(surface, tolerance, execution.stage("regions"));
  std::vector<Part_face<Kernel>> result = internal::part_faces<Kernel>(surface, found);
  write_face_values(mesh, found.partition, part_face_map);
  for (Part_face<Kernel>& face : result)
    *part_faces++ = std::move(face);
  return found.surfaces.size();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_FIND_PART_FACES_H
