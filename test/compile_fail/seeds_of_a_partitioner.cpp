// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a method with a GraphPartitioner takes no seeds
#include "common.h"
struct Partitioner
{
  template <typename AnyGraph>
  RS::Partition operator()(const AnyGraph&, std::size_t) const
  {
    return {};
  }
};
void test(const Mesh& mesh, Labels labels, Labels seeds)
{
  const auto np = RS::parameters::number_of_segments(3).method(
    RS::make_partitioning_method(RS::Region_growing(), RS::Geometry_annotator<>(), Partitioner()));
#ifdef WITH_FAULT
  RS::segment(mesh, labels, np.face_seed_map(seeds));
#else
  RS::segment(mesh, labels, np);
  static_cast<void>(seeds);
#endif
}
