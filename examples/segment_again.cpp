// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh is prepared once and asked often: for other numbers of segments, with edges that a person
// drew, with seeds.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;

  RS::Segmenter segmenter(mesh); // reads, annotates and merges
  std::cout << segmenter.segment(segment_id) << " segments, as many as the method chooses\n";
  for (std::size_t k : {2, 3, 8})
    std::cout << segmenter.segment(segment_id, k) << " segments\n"; // in the time of writing labels

  // A loop of edges around the bar, halfway along it, as a person might draw it.
  auto is_drawn = mesh.add_property_map<Mesh::Edge_index, bool>("e:drawn", false).first;
  std::size_t number_of_drawn_edges = 0;
  for (auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    is_drawn[e] = mesh.point(source(h, mesh)).x() == 0 && mesh.point(target(h, mesh)).x() == 0;
    number_of_drawn_edges += is_drawn[e];
  }
  segmenter.add_constraints(is_drawn);
  std::cout << number_of_drawn_edges << " drawn edges: " << segmenter.segment(segment_id, 2)
            << " segments\n";

  // Two faces that belong together, and one that does not.
  auto seed = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:seed", std::size_t(-1)).first;
  const auto first = *faces(mesh).begin(), last = *std::prev(faces(mesh).end());
  seed[first] = 0;
  seed[last] = 1;
  segmenter.set_seeds(seed);
  segmenter.segment(segment_id, 2);
  std::cout << "the first and the last face are in segments " << segment_id[first] << " and "
            << segment_id[last] << '\n';
}
