// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SEGMENTATION_METHOD_H
#define CGAL_REGION_SEGMENTATION_METHODS_SEGMENTATION_METHOD_H

#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMethods
/// Takes the place of a number chooser in a method that has none: such a method needs the number of segments.
struct No_number_chooser
{};

/// \ingroup PkgRegionSegmentationMethods
/// A method made of its four parts. A model of `SegmentationMethod`.
///
/// A method is a value: its parts are instances, each with its constants and any data or state of the user. A part can
/// be changed (`method.initializer.number = 400`) or replaced by one of another type (`with_...()`, which returns a new
/// method and does not change this one).
///
/// \code
/// const auto method = RS::Visibility_merging().with_policy(RS::Lowest_cost_first(My_cost()))
///                                             .with_chooser(RS::No_number_chooser());
/// RS::segment(mesh, segment_id, RS::parameters::number_of_segments(8).method(method));
/// \endcode
///
/// \tparam RegionInitializer makes the first regions
/// \tparam GraphAnnotator defines and fills the data of the region graph
/// \tparam RegionMergingPolicy proposes which regions are merged next
/// \tparam NumberChooser chooses the number of segments where none is given
template <typename RegionInitializer, typename GraphAnnotator, typename RegionMergingPolicy,
          typename NumberChooser = No_number_chooser>
struct Segmentation_method
{
  RegionInitializer initializer;
  GraphAnnotator annotator;
  RegionMergingPolicy policy;
  NumberChooser chooser = NumberChooser();

  template <typename Other>
  auto with_initializer(Other other) const
  {
    return Segmentation_method<Other, GraphAnnotator, RegionMergingPolicy, NumberChooser>{std::move(other), annotator,
                                                                                         policy, chooser};
  }

  template <typename Other>
  auto with_annotator(Other other) const
  {
    return Segmentation_method<RegionInitializer, Other, RegionMergingPolicy, NumberChooser>{
      initializer, std::move(other), policy, chooser};
  }

  template <typename Other>
  auto with_policy(Other other) const
  {
    return Segmentation_method<RegionInitializer, GraphAnnotator, Other, NumberChooser>{initializer, annotator,
                                                                                       std::move(other), chooser};
  }

  template <typename Other>
  auto with_chooser(Other other) const
  {
    return Segmentation_method<RegionInitializer, GraphAnnotator, RegionMergingPolicy, Other>{
      initializer, annotator, policy, std::move(other)};
  }
};

/// \ingroup PkgRegionSegmentationMethods
/// makes a method of its parts.
template <typename RegionInitializer, typename GraphAnnotator, typename RegionMergingPolicy,
          typename NumberChooser = No_number_chooser>
Segmentation_method<RegionInitializer, GraphAnnotator, RegionMergingPolicy, NumberChooser>
make_segmentation_method(RegionInitializer initializer, GraphAnnotator annotator, RegionMergingPolicy policy,
                         NumberChooser chooser = NumberChooser())
{
  return {std::move(initializer), std::move(annotator), std::move(policy), std::move(chooser)};
}

/// \ingroup PkgRegionSegmentationMethods
/// A method that partitions the region graph instead of merging regions one pair at a time: a partitioner takes the
/// place of policy and chooser. A model of `SegmentationMethod`.
///
/// \tparam GraphPartitioner assigns the regions to a given number of segments
template <typename RegionInitializer, typename GraphAnnotator, typename GraphPartitioner>
struct Partitioning_method
{
  RegionInitializer initializer;
  GraphAnnotator annotator;
  GraphPartitioner partitioner;
};

/// \ingroup PkgRegionSegmentationMethods
/// makes a method of its parts.
template <typename RegionInitializer, typename GraphAnnotator, typename GraphPartitioner>
Partitioning_method<RegionInitializer, GraphAnnotator, GraphPartitioner>
make_partitioning_method(RegionInitializer initializer, GraphAnnotator annotator, GraphPartitioner partitioner)
{
  return {std::move(initializer), std::move(annotator), std::move(partitioner)};
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SEGMENTATION_METHOD_H
