// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionInitializer needs: Region_labels operator()
#include "common.h"
struct Initializer
{
#ifdef WITH_FAULT
  RS::Region_labels operator()(const RS::Flat_mesh&) const
  {
    return {};
  }
#else
  RS::Region_labels operator()(const RS::Flat_mesh&, const RS::Edge_marks&) const
  {
    return {};
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels,
              RS::parameters::number_of_segments(3).region_initializer(Initializer()));
}
