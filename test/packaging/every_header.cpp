// SPDX-License-Identifier: GPL-3.0-or-later

// Linked with the headers alone: what is defined in a header and not inline is defined twice.

#include "every_header.h"

#if defined CGAL_REGION_SEGMENTATION_PARAMETERS || defined CGAL_REGION_SEGMENTATION_ADD ||         \
  defined CGAL_add_named_parameter
#error "a macro of the named parameters is left defined"
#endif

int main() {}
