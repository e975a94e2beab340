// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_FACE_VALUES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_FACE_VALUES_H

#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// returns the values of a property map for the faces of a mesh, in iteration order, as the parts
/// of methods index faces. By it, a part can use curvatures, colors or labels of the user.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam FaceMap a model of `ReadablePropertyMap` with the face descriptor as key
///
/// Complexity: O(F).
template <typename FaceGraph, typename FaceMap>
auto face_values(const FaceGraph& mesh, const FaceMap& map)
{
  static_assert(internal::check_face_map<FaceMap, FaceGraph>());
  std::vector<typename boost::property_traits<FaceMap>::value_type> values;
  values.reserve(faces(mesh).size());
  for (auto f : faces(mesh))
    values.push_back(get(map, f));
  return values;
}

/// \ingroup PkgRegionSegmentationData
/// writes a value for every face of a mesh, in iteration order: the inverse of `face_values()`.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam Values a type with `operator[](std::size_t)`, such as `Partition` or a vector
/// \tparam FaceMap a model of `WritablePropertyMap` with the face descriptor as key
/// \pre there is a value for each face
///
/// Integers are written as labels to a map of another integral type, but `bool`: -1, the label
/// `no_segment`, as -1 of that type.
/// \throws Invalid_input if this type does not hold a label, and -1 beside it; nothing is written
///
/// Complexity: O(F).
template <typename FaceGraph, typename Values, typename FaceMap>
void write_face_values(const FaceGraph& mesh, const Values& values, FaceMap map)
{
  static_assert(internal::check_face_map<FaceMap, FaceGraph>());
  using Value = typename boost::property_traits<FaceMap>::value_type;
  using Item = std::decay_t<decltype(values[0])>;
  constexpr bool are_labels = std::is_integral<Value>::value && std::is_integral<Item>::value &&
                              !std::is_same<Value, bool>::value;
  if constexpr (are_labels && internal::satisfies<internal::Number_of_parts, Values>) {
    internal::check_labels<Value>(values.number_of_parts());
  } else if constexpr (are_labels && !std::is_same<Value, Item>::value) {
    std::vector<Value> labels;
    for ([[maybe_unused]] const auto f : faces(mesh))
      labels.push_back(internal::converted_label<Value>(values[labels.size()]));
    return write_face_values(mesh, labels, map);
  }
  std::size_t i = 0;
  for (auto f : faces(mesh))
    put(map, f, Value(values[i++]));
}

namespace internal {

/// The partition of the faces of a mesh, in iteration order, by the labels that a property map
/// gives to them.
template <typename FaceGraph, typename FaceLabelMap>
Partition read_face_labels(const FaceGraph& mesh, const FaceLabelMap& label_map)
{
  static_assert(check_face_map<FaceLabelMap, FaceGraph>());
  using Label = typename boost::property_traits<FaceLabelMap>::value_type;
  return Partition::from_labels(faces(mesh), num_faces(mesh),
                                [&](const auto& f) -> Label { return get(label_map, f); });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_FACE_VALUES_H
