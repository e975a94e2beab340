// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a GraphAnnotator needs the nested types RegionData and SectionData, and: void operator()
#include "common.h"
struct Annotator
{
  using RegionData = RS::Visibility_region_data;
  using SectionData = RS::Visibility_section_data;
#ifdef WITH_FAULT
  void operator()(Visibility_graph&, const RS::Surface&) const {}
#else
  void operator()(Visibility_graph&, const RS::Surface&, const RS::Partition&,
                  const RS::Region_rays&) const
  {}
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  const RS::Superfacet_merging method{Annotator(), RS::Visibility_merging().policy,
                                      RS::Visibility_merging().chooser};
  RS::segment(mesh, labels, RS::parameters::method(method));
}
