// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_CAN_LIMIT_MEMORY_H
#define CGAL_REGION_SEGMENTATION_TEST_CAN_LIMIT_MEMORY_H

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define TEST_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define TEST_ADDRESS_SANITIZER
#endif

/// Whether a limit on the address space leaves any: the address sanitizer takes all of it.
#ifdef TEST_ADDRESS_SANITIZER
constexpr bool can_limit_memory = false;
#else
constexpr bool can_limit_memory = true;
#endif

#endif // CGAL_REGION_SEGMENTATION_TEST_CAN_LIMIT_MEMORY_H
