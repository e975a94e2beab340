// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a GraphAnnotator needs the nested types RegionData and SectionData
#include "common.h"
struct Annotator
{
#ifndef WITH_FAULT
  using RegionData = RS::Region_geometry;
#endif
  using SectionData = RS::Section_geometry;
  template <typename AnyGraph>
  void operator()(AnyGraph&, const RS::Flat_mesh&, const RS::Partition&) const
  {}
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(RS::Two_step().with_annotator(Annotator())));
}
