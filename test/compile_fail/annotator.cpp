// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a GraphAnnotator needs: void operator()
#include "common.h"
struct Annotator
{
  using RegionData = RS::Region_geometry;
  using SectionData = RS::Section_geometry;
#ifdef WITH_FAULT
  void operator()(Graph&, const RS::Flat_mesh&) const {}
#else
  void operator()(Graph&, const RS::Flat_mesh&, const RS::Partition&) const {}
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(RS::Two_step().with_annotator(Annotator())));
}
