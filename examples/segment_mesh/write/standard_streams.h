// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STANDARD_STREAMS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STANDARD_STREAMS_H

namespace segment_mesh {

/// Occupies the descriptors of those of stdin, stdout and stderr that are closed, so that no file
/// gets them, into which messages would be written then. Reading from them, or writing to them,
/// remains an error. To be called before a file is opened.
void occupy_closed_standard_streams();

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_STANDARD_STREAMS_H
