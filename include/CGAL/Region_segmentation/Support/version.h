// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_VERSION_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_VERSION_H

/// \file version.h
/// The version of the package: the only place where it is written; CMake reads it from here.

#define CGAL_REGION_SEGMENTATION_VERSION_MAJOR 1
#define CGAL_REGION_SEGMENTATION_VERSION_MINOR 0
#define CGAL_REGION_SEGMENTATION_VERSION_PATCH 0

/// The version as one number, to be compared: 10000 * major + 100 * minor + patch.
#define CGAL_REGION_SEGMENTATION_VERSION_NUMBER                                                    \
  (10000 * CGAL_REGION_SEGMENTATION_VERSION_MAJOR + 100 * CGAL_REGION_SEGMENTATION_VERSION_MINOR + \
   CGAL_REGION_SEGMENTATION_VERSION_PATCH)

/// The version as text.
#define CGAL_REGION_SEGMENTATION_VERSION "1.0.0"

/// `CGAL_REGION_SEGMENTATION_COMPILED` is defined by users of the target
/// `CGAL::Region_segmentation_compiled`: the code of `build_surface()` and of the methods is in one
/// translation unit, `compiled_methods.cpp`, alone, which defines
/// `CGAL_REGION_SEGMENTATION_EXTERN` as nothing.
#ifndef CGAL_REGION_SEGMENTATION_EXTERN
#define CGAL_REGION_SEGMENTATION_EXTERN extern
#endif

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_VERSION_H
