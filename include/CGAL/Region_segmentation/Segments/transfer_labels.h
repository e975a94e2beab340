// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_TRANSFER_LABELS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_TRANSFER_LABELS_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/segments/Mesh_geometry.h>
#include <CGAL/Region_segmentation/internal/segments/Nearest_face_finder.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/dissolve_islands.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// A face is divided into triangles between its sides and the mean of its corners. The middle of
/// each finds a face of the other mesh, and votes for its label by its area; of equal votes the
/// lowest label counts.
inline std::vector<Halfedge_table::Index>
labels_of_nearest_faces(const Mesh_geometry& to, const Mesh_geometry& from,
                        const std::vector<Halfedge_table::Index>& labels)
{
  using Index = Halfedge_table::Index;
  const double scale = to.unit() / from.unit();
  Nearest_face_finder finder(from.surface());
  const Surface& surface = to.surface();
  std::vector<Index> result;
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    const std::size_t n = surface.number_of_corners(f);
    const Double_3 center = surface.centroid(f);
    const Double_3 normal = to.given_normal(f);
    const auto agrees = [&](Index g) {
      return to.surface().is_degenerate(f) || dot(normal, from.given_normal(g)) > 0;
    };
    std::map<Index, double> votes;
    for (std::size_t i = 0; i < n; ++i) {
      const Double_3 p = surface.point(surface.corner(f, i)),
                     q = surface.point(surface.corner(f, (i + 1) % n));
      const Index nearest = finder.find(scale / 3 * (p + q + center), agrees);
      votes[labels[nearest]] += norm(cross(p - center, q - center));
    }
    result.push_back(std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first);
  }
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// gives the faces of a mesh the labels of another mesh of the same surface: of a remeshed,
/// decimated, subdivided or split copy, or of the original.
///
/// Each face takes the label to which most of its area is nearest. Faces of `from` whose normals
/// are more than \f$\pi/2\f$ away count as farther by a twentieth of the square root of its area:
/// so labels do not change sides of a thin wall.
///
/// *Islands* are dissolved: a component of faces with equal labels is one if it is smaller than a
/// tenth of the largest one of its label, and than as many others of this label as there are
/// components of it on `from`. It takes the label with which it shares the longest border. So
/// segments stay connected, also where borders are narrower than faces. A segment smaller than the
/// faces of `to` may be lost.
///
/// \tparam FromGraph, ToGraph models of `FaceListGraph` and `HalfedgeListGraph`, of any two types
/// \tparam FromMap a model of `ReadablePropertyMap` with the face descriptor of `from` as key and
///         an integral value type of at most 64 bits
/// \tparam ToMap a model of `WritablePropertyMap` with the face descriptor of `to` as key and a
///         value type constructible from that of `FromMap`
/// \param from an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param from_map the labels, any integers; those of `no_segment` are transferred, too
/// \param to as `from`; its place in space is that of `from`, and it is oriented as it is
/// \param to_map every key is written
/// \param np_from, np_to optional sequences of \ref PkgRegionSegmentationNP "Named Parameters" for
///        the two meshes:
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the number of different labels on `to`
/// \throws Invalid_input if a point is not finite, or `from` has no face and `to` has one; the map
///         is unchanged
///
/// Complexity: O((F + G) log F) in practice, G the number of faces of `to`. Deterministic.
/// Concurrent calls on different maps are safe.
template <typename FromGraph, typename FromMap, typename ToGraph, typename ToMap,
          typename FromParameters = parameters::Default_named_parameters,
          typename ToParameters = parameters::Default_named_parameters>
std::size_t transfer_labels(const FromGraph& from, const FromMap& from_map, const ToGraph& to,
                            ToMap to_map,
                            const FromParameters& np_from = parameters::default_values(),
                            const ToParameters& np_to = parameters::default_values())
{
  static_assert(internal::check_face_map<ToMap, ToGraph>());
  using Index = internal::Halfedge_table::Index;
  const auto &from_pack = internal::pack(np_from), &to_pack = internal::pack(np_to);
  internal::check_parameters<std::decay_t<decltype(from_pack)>, internal::Tag_list<>>();
  internal::check_parameters<std::decay_t<decltype(to_pack)>, internal::Tag_list<>>();
  const auto segmented = internal::make_segmented_mesh(from, from_map, from_pack);
  const internal::Mesh_geometry from_geometry(segmented,
                                              internal::make_surface_of_neighbors(from, from_pack));
  internal::Halfedge_table halfedges;
  internal::read_halfedges(to, to_pack, halfedges);
  const internal::Mesh_geometry to_geometry(halfedges,
                                            internal::make_surface_of_neighbors(to, to_pack));
  if (halfedges.number_of_faces() == 0)
    return 0;
  if (segmented.number_of_faces() == 0)
    throw Invalid_input("transfer_labels: the mesh with labels has no faces");

  std::vector<Index> labels = internal::labels_of_nearest_faces(to_geometry, from_geometry,
                                                                segmented.segment_of_face);
  const Partition components = internal::components_of_labels(from_geometry.surface(),
                                                              segmented.segment_of_face);
  std::map<Index, std::size_t> numbers;
  for (std::size_t f = 0, next = 0; f < components.size(); ++f)
    if (components[f] == next) { // numbered by their first faces
      ++numbers[segmented.segment_of_face[f]];
      ++next;
    }
  internal::dissolve_islands(to_geometry.surface(), numbers, labels);

  std::vector<typename boost::property_traits<FromMap>::value_type> values;
  for (Index label : labels)
    values.push_back(segmented.label(label));
  write_face_values(to, values, to_map);
  return Partition::from_labels(labels).number_of_parts();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_TRANSFER_LABELS_H
