// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplification that keeps the borders between segments; faces keep their labels.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace RS = CGAL::Region_segmentation;
namespace SMS = CGAL::Surface_mesh_simplification;

/// A stop predicate: a fifth of the edges is left. (That of CGAL has another name in later
/// releases.)
struct Fifth_of_edges
{
  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile&, std::size_t initial, std::size_t current) const
  {
    return current <= initial / 5;
  }
};

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto is_border = mesh.add_property_map<Mesh::Edge_index, bool>("e:border").first;
  RS::segment(mesh, segment_id);
  const std::size_t before = RS::mark_segment_borders(mesh, segment_id, is_border);
  using Placement = SMS::Constrained_placement<SMS::LindstromTurk_placement<Mesh>,
                                               decltype(is_border)>;
  SMS::edge_collapse(
    mesh, Fifth_of_edges(),
    CGAL::parameters::edge_is_constrained_map(is_border).get_placement(Placement(is_border)));
  mesh.collect_garbage();
  const std::size_t after = RS::mark_segment_borders(mesh, segment_id, is_border);
  std::cout << num_faces(mesh) << " faces; edges between segments: " << before << ", then " << after
            << '\n';
  write_colored(mesh, segment_id, "simplify.ply");
}
