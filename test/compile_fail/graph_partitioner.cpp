// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a GraphPartitioner needs: Partition operator()(const Graph&, std::size_t number_of_segments) const
#include "common.h"
struct Partitioner
{
#ifdef WITH_FAULT
  RS::Partition operator()(const Graph&) const { return {}; }
#else
  RS::Partition operator()(const Graph&, std::size_t) const { return {}; }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels,
              RS::parameters::number_of_segments(3).method(RS::make_partitioning_method(
                RS::Region_growing(), RS::Geometry_annotator<>(), Partitioner())));
}
