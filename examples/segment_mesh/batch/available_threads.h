// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_AVAILABLE_THREADS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_AVAILABLE_THREADS_H

#include <cstddef>

namespace segment_mesh {

/// How many threads, this one among them and at most `wanted`, can run at a time within the limits
/// on threads and address space. Found by starting them: TBB ends the program where it cannot start
/// one.
std::size_t available_threads(std::size_t wanted);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_AVAILABLE_THREADS_H
