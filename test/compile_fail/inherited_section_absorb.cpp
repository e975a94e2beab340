// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SectionData that adds data members to those of its base class needs its own absorb()
#include "common.h"
struct Section_data : RS::Section_geometry
{
  double added = 0;
  void add_edge(const RS::Flat_mesh& mesh, std::size_t lower_face, std::size_t edge)
  {
    RS::Section_geometry::add_edge(mesh, lower_face, edge);
    ++added;
  }
#ifndef WITH_FAULT
  void absorb(const Section_data& other)
  {
    RS::Section_geometry::absorb(other);
    added += other.added;
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  using Annotator = RS::Geometry_annotator<RS::Region_geometry, Section_data>;
  RS::segment(mesh, labels, 8, RS::parameters::method(RS::Two_step().with_annotator(Annotator())));
}
