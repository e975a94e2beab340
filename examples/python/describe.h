// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PYTHON_DESCRIBE_H
#define CGAL_REGION_SEGMENTATION_PYTHON_DESCRIBE_H

#include "Soup.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <vector>

/// A dictionary for each segment, with the members of `Segment_description`.
py::list describe(const Soup& soup, const std::vector<std::int64_t>& labels);

#endif // CGAL_REGION_SEGMENTATION_PYTHON_DESCRIBE_H
