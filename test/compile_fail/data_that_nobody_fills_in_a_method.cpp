// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the GraphAnnotator does not fill its RegionData or SectionData
#include "common.h"
struct Region_data : RS::Visibility_region_data
{};
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  const RS::Geometry_annotator<Region_data, RS::Visibility_section_data> annotator;
#else
  const RS::Visibility_annotator annotator;
#endif
  RS::segment(mesh, labels, RS::parameters::method(RS::Visibility_merging().with_annotator(annotator)));
}
