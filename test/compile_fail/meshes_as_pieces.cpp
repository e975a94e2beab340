// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the output iterator does not take what this function gives: Segment_piece
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  std::vector<Mesh> pieces;
#else
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
#endif
  RS::split_into_segments(mesh, labels, std::back_inserter(pieces));
}
