// SPDX-License-Identifier: GPL-3.0-or-later

// The targets that segment meshes, in one translation unit, since they instantiate the same.

#define LLVMFuzzerTestOneInput segment_mesh_input
#include "segment_mesh.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput use_segments_input
#include "use_segments.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput segment_soup_input
#include "segment_soup.cpp"
