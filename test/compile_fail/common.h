// SPDX-License-Identifier: GPL-3.0-or-later

// For the tests that must not compile. Each file compiles without WITH_FAULT, so that it is the
// fault that is refused, and with it fails with the message of its line `expect:`. All are parsed
// as one unit, where an error in a template is told once for the same arguments: no two faults may
// share them.

#ifndef REGION_SEGMENTATION_TEST_COMPILE_FAIL_COMMON_H
#define REGION_SEGMENTATION_TEST_COMPILE_FAIL_COMMON_H

#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <boost/property_map/function_property_map.hpp>

#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;
using Graph = RS::Region_adjacency_graph<>;
using Visibility_graph = RS::Region_adjacency_graph<RS::Visibility_region_data,
                                                    RS::Visibility_section_data>;

#endif // REGION_SEGMENTATION_TEST_COMPILE_FAIL_COMMON_H
