// SPDX-License-Identifier: GPL-3.0-or-later

// split_benchmark [FACES [SEGMENTS]]: split_into_segments() against copying the mesh once by
// CGAL::copy_face_graph(). Ratios of processor times of one run each, alternating; once with each
// piece discarded when it is complete, once with all kept.

#include "make_mesh.h"
#include "make_triangles.h"
#include "seconds.h"

#include <CGAL/Region_segmentation/Segments/split_into_segments.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace speed_benchmark;
using Piece = RS::Segment_piece<Mesh, Mesh, std::size_t>;

/// Squares of the quads that a torus is made of.
std::size_t label_squares(const Mesh& mesh, Mesh::Property_map<Mesh::Face_index, std::size_t> map,
                          std::size_t segments)
{
  const auto quads = std::size_t(std::sqrt(double(num_faces(mesh)) / 2)),
             squares = std::size_t(std::sqrt(double(segments)));
  for (auto f : faces(mesh)) {
    const std::size_t quad = std::size_t(f) / 2;
    map[f] = quad / quads * squares / quads * squares + quad % quads * squares / quads;
  }
  return squares * squares;
}

int main(int argc, char** argv)
{
  Mesh mesh = make_mesh(wavy_torus(argc > 1 ? std::size_t(std::atoll(argv[1])) : 5000000));
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = label_squares(mesh, segment_id,
                                      argc > 2 ? std::size_t(std::atoll(argv[2])) : 10000);
  std::cout << num_faces(mesh) << " faces, " << n << " segments\n";
  for (int round = 0; round < 5; ++round) {
    Mesh copy;
    const double to_copy = seconds_of(Clock::PROCESSOR, [&] { CGAL::copy_face_graph(mesh, copy); });
    copy.clear();
    std::size_t number_of_faces = 0;
    const double to_split = seconds_of(Clock::PROCESSOR, [&] {
      RS::split_into_segments(mesh, segment_id,
                              boost::make_function_output_iterator([&](const Piece& piece) {
                                number_of_faces += num_faces(piece.mesh);
                              }));
    });
    std::vector<Piece> pieces;
    const double to_keep = seconds_of(Clock::PROCESSOR, [&] {
      RS::split_into_segments(mesh, segment_id, std::back_inserter(pieces));
    });
    if (pieces.size() != n || number_of_faces != num_faces(mesh))
      return EXIT_FAILURE;
    std::cout << "copied in " << to_copy << " s; split in " << to_split / to_copy
              << " times that, kept in " << to_keep / to_copy << " times\n";
  }
}
