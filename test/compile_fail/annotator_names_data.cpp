// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a GraphAnnotator needs the nested types RegionData and SectionData
#include "common.h"
struct Annotator
{
#ifndef WITH_FAULT
  using RegionData = RS::Visibility_region_data;
#endif
  using SectionData = RS::Visibility_section_data;
  template <typename AnyGraph>
  void operator()(AnyGraph&, const RS::Surface&, const RS::Partition&, const RS::Region_rays&) const
  {}
};
void test(const Mesh& mesh, Labels labels)
{
  const RS::Superfacet_merging method{Annotator(), RS::Visibility_merging().policy,
                                      RS::Visibility_merging().chooser};
  RS::segment(mesh, labels, RS::parameters::method(method));
}
