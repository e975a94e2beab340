// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_COMPILED_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_COMPILED_H

/// \file
/// `CGAL_REGION_SEGMENTATION_COMPILED` is defined by users of the target
/// `CGAL::Region_segmentation_compiled`: the code of `build_surface()` and of the methods is in one
/// translation unit, `compiled_methods.cpp`, alone, which defines
/// `CGAL_REGION_SEGMENTATION_EXTERN` as nothing.

#ifndef CGAL_REGION_SEGMENTATION_EXTERN
#define CGAL_REGION_SEGMENTATION_EXTERN extern
#endif

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_COMPILED_H
