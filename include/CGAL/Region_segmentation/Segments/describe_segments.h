// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_DESCRIBE_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_DESCRIBE_SEGMENTS_H

/// \file describe_segments.h
/// Requires Eigen 3; so it is not part of region_segmentation.h.

#include <CGAL/Region_segmentation/Segments/Segment_description.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/segments/Segment_describer.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/support/concept_checks.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// describes every segment: area, volume, centroid, principal axes, neighbors, and the primitive
/// that fits best. See `Segment_description`.
///
/// `#include <CGAL/Region_segmentation/Segments/describe_segments.h>`, which requires Eigen.
///
/// A plane, sphere, cylinder and cone are fitted to the corners of the faces, weighted by area:
/// minimum of the mean square distance (Levenberg and Marquardt), from a start by linear systems in
/// points and normals; for large segments from 2000 faces, spread evenly. The misfit of a primitive
/// is the root mean square distance of these corners and of the middles of the faces together,
/// since corners on two circles alone could be those of a sphere. From the simplest to the most
/// complex, a primitive replaces the previous choice if its misfit is below 0.8 of it, and that one
/// was more than \f$10^{-4}\f$ of the square root of the area. Planes are exact; for the others the
/// minimum is local. Spheres, cylinders and cones whose radius or apex is more than 100 times that
/// square root away are not considered, nor are cones whose half angle is within 0.01 radians of 0
/// or \f$\pi/2\f$.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam DescriptionOutputIterator a model of `OutputIterator` that takes
///         `Segment_description<Label, Kernel>`: `Label` is the value type of `FaceSegmentMap`,
///         `Kernel` the kernel of the points, `CGAL::Kernel_traits<Point>::Kernel` where `Point` is
///         the value type of the vertex point map; `CGAL::Simple_cartesian<double>` if that has
///         none
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` belong to none
/// \param descriptions receives the descriptions, in the order of the first faces of the segments
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the number of segments
/// \throws Invalid_input if a point is not finite
///
/// Complexity: O(F log F). Deterministic: the same numbers from every mesh type. Read-only;
/// concurrent calls are safe. Areas and volumes in units of the mesh may exceed the range of
/// `double` if coordinates are extreme.
template <typename FaceGraph, typename FaceSegmentMap, typename DescriptionOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t describe_segments(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                              DescriptionOutputIterator descriptions,
                              const NamedParameters& np = parameters::default_values())
{
  using Label = typename boost::property_traits<FaceSegmentMap>::value_type;
  const auto& pack = internal::pack(np);
  using Pack = std::decay_t<decltype(pack)>;
  using Kernel = internal::Kernel_of_points<
    typename GetVertexPointMap<FaceGraph, Pack>::const_type>;
  internal::check_parameters<Pack, internal::Tag_list<>>();
  const internal::Segmented_mesh segmented(mesh, segment_map, pack);
  const Surface surface = internal::make_surface_of_neighbors(mesh, pack);
  internal::Segment_describer<FaceGraph, Label, Kernel> describer(segmented, surface);
  for (auto& description : describer.describe())
    *descriptions++ = std::move(description);
  return segmented.number_of_segments;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_DESCRIBE_SEGMENTS_H
