// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXCEPTIONS_H
#define CGAL_REGION_SEGMENTATION_EXCEPTIONS_H

#include <stdexcept>

namespace CGAL {
namespace Region_segmentation {

/// Thrown, in every build, for what only the data can tell: a point that is not finite, a file of
/// labels with a wrong number of lines. The message names the place. Outputs are as before.
class Invalid_input : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Thrown when a visitor asks to stop. Outputs are as before.
class Segmentation_cancelled : public std::runtime_error
{
public:
  Segmentation_cancelled() : std::runtime_error("segmentation cancelled by its visitor") {}
};

/// Thrown, in every build, when a part of a method does what its concept forbids and no type can tell: it reads data of
/// the mesh that it did not ask for, or proposes to merge across a section that is removed. Outputs are as before.
class Invalid_method : public std::logic_error
{
public:
  using std::logic_error::logic_error;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EXCEPTIONS_H
