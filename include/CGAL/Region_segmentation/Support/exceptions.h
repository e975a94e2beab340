// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_EXCEPTIONS_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_EXCEPTIONS_H

#include <stdexcept>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationExceptions
/// Thrown, in every build, for invalid data: a point that is not finite, a file of labels with a
/// wrong number of lines. The message states the location. Outputs are unchanged.
class Invalid_input : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgRegionSegmentationExceptions
/// Thrown when a visitor cancels. Outputs are unchanged.
class Segmentation_cancelled : public std::runtime_error
{
public:
  Segmentation_cancelled()
    : std::runtime_error("segmentation cancelled by its visitor")
  {}
};

/// \ingroup PkgRegionSegmentationExceptions
/// Thrown, in every build, when a method or a part of it violates its concept in a way that cannot
/// be detected at compile time: a constant is not in its range, its regions are not those of the
/// faces, or a policy proposes a merge across a removed section or at a cost that is not a number.
/// Outputs are unchanged.
class Invalid_method : public std::logic_error
{
public:
  using std::logic_error::logic_error;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_EXCEPTIONS_H
