// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_TRANSFER_LABELS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_TRANSFER_LABELS_H

#include <CGAL/Region_segmentation/Segments/find_nearest_faces.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The key of the greatest value of a map, of equal values the lowest key.
inline Surface::Index key_of_greatest(const std::map<Surface::Index, double>& map)
{
  return std::max_element(map.begin(), map.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
    ->first;
}

/// The connected components of the faces with equal labels.
/// `labels`: a range with a label for each face
template <typename Labels>
Partition components_of_labels(const Surface& surface, const Labels& labels)
{
  return label_components(
    surface,
    [&](std::size_t a) { return labels[surface.lower_face(a)] == labels[surface.higher_face(a)]; },
    Execution());
}

/// Gives the faces of each island the label with which it shares the longest border. An island is a
/// component of less than a tenth of the area of the largest one of its label. Islands inside other
/// islands follow after these; an island without a neighbor keeps its label.
inline void dissolve_islands(const Surface& surface, std::vector<Surface::Index>& label_of_face)
{
  using Index = Surface::Index;
  const Partition components = components_of_labels(surface, label_of_face);
  const std::vector<double> areas = part_areas(surface, components);
  std::vector<Index> labels(areas.size());
  std::map<Index, double> largest; // component of a label
  for (std::size_t f = 0; f < components.size(); ++f) {
    const Index label = labels[components[f]] = label_of_face[f];
    largest[label] = (std::max)(largest[label], areas[components[f]]);
  }
  std::vector<char> is_island;
  for (std::size_t c = 0; c < areas.size(); ++c)
    is_island.push_back(areas[c] < 0.1 * largest[labels[c]]);
  std::map<Index, std::map<Index, double>> lengths; // by island and label beside it
  do {
    lengths.clear();
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const Index f = components[surface.lower_face(a)], g = components[surface.higher_face(a)];
      if (is_island[f] != is_island[g])
        lengths[is_island[f] ? f : g][labels[is_island[f] ? g : f]] += surface.length(a);
    }
    for (const auto& [island, of_labels] : lengths) {
      labels[island] = key_of_greatest(of_labels);
      is_island[island] = false;
    }
  } while (!lengths.empty());
  for (Index f = 0; f < components.size(); ++f)
    label_of_face[f] = labels[components[f]];
}

/// The parts of the faces of a surface `from` that are nearest to the faces of `to`. A face is
/// divided into triangles between its sides and the mean of its corners. The middle of each
/// triangle finds a face of `from`, and votes for its part by the area of the triangle. If two
/// parts have equal votes, the lower one is taken.
inline std::vector<Surface::Index> nearest_parts(const Surface& to, const Surface& from,
                                                 const Partition& parts)
{
  using Index = Surface::Index;
  const double scale = to.unit() / from.unit();
  const Nearest_face_finder finder(from);
  std::vector<Index> result;
  for (Index f = 0; f < to.number_of_faces(); ++f) {
    const Double_3 center = to.centroid(f);
    const auto agrees = [&](Index g) {
      return to.is_degenerate(f) || dot(to.normal(f), from.normal(g)) > 0;
    };
    std::map<Index, double> votes;
    for_each_side(to, f, [&](Index v, Index w) {
      const Double_3 &p = to.point(v), &q = to.point(w);
      votes[parts[finder.find(scale / 3 * (p + q + center), agrees)]] += norm(
        cross(p - center, q - center));
    });
    result.push_back(key_of_greatest(votes));
  }
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// gives the faces of a mesh the labels of another mesh of the same surface: of a remeshed,
/// decimated, subdivided or split copy, or of the original.
///
/// Each face takes the label to which most of its area is nearest. Faces of `from` whose normals
/// differ by more than \f$\pi/2\f$ count as farther by a twentieth of the square root of the area
/// of `from`: so labels do not change sides of a thin wall.
///
/// Each component of a segment of `from` is transferred as one: where it falls to pieces on `to`,
/// pieces of less than a tenth of the area of the largest one are *islands*. An island takes the
/// label with which it shares the longest border. So segments stay connected, also where they are
/// narrower than faces. A component smaller than the faces of `to` may be lost.
///
/// \tparam FromGraph, ToGraph models of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`,
///         of any two types
/// \tparam FromMap a model of `ReadablePropertyMap` with the face descriptor of `from` as key and
///         an integral value type of at most 64 bits
/// \tparam ToMap a model of `WritablePropertyMap` with the face descriptor of `to` as key and an
///         integral value type
/// \param from an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param from_map the labels, any integers. `no_segment` is transferred as `no_segment`, whatever
///        the two types are
/// \param to as `from`: a surface in the same place, whose normals are on the same side
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
/// \throws Invalid_input if a point is not finite, `from` has no face and `to` has one, or the type
///         of `to_map` does not hold the labels, and -1 beside them; the map is unchanged
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
  using Label = typename boost::property_traits<ToMap>::value_type;
  const auto &from_pack = internal::pack(np_from), &to_pack = internal::pack(np_to);
  internal::check_parameters<std::decay_t<decltype(from_pack)>, internal::Tag_list<>>();
  internal::check_parameters<std::decay_t<decltype(to_pack)>, internal::Tag_list<>>();
  const Surface from_surface = internal::surface_as_given(from, from_pack),
                to_surface = internal::surface_as_given(to, to_pack);
  if (to_surface.number_of_faces() == 0)
    return 0;
  if (from_surface.number_of_faces() == 0)
    throw Invalid_input("transfer_labels: the mesh with labels has no faces");

  // Each component of a segment is transferred as one, so that on `to` it is one, too.
  const auto labels = face_values(from, from_map);
  const Partition components = internal::components_of_labels(from_surface, labels);
  auto nearest = internal::nearest_parts(to_surface, from_surface, components);
  internal::dissolve_islands(to_surface, nearest);

  std::vector<Label> label_of(components.number_of_parts()), result;
  for (std::size_t f = 0; f < labels.size(); ++f)
    label_of[components[f]] = internal::converted_label<Label>(labels[f]);
  for (const Surface::Index component : nearest)
    result.push_back(label_of[component]);
  write_face_values(to, result, to_map);
  return Partition::from_labels(result).number_of_parts();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_TRANSFER_LABELS_H
