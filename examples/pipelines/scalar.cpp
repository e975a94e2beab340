// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scalar of the faces in the cost of merging: here a gray, so that borders follow paint, too.

#include "../example_mesh.h"

#include <CGAL/region_segmentation.h>

#include <cmath>
#include <vector>

namespace RS = CGAL::Region_segmentation;

// The data of a region: what Visibility_cost reads, and the integral of the gray over the area.
struct Painted_region : RS::Visibility_region_data
{
  double paint = 0;

  double gray() const { return area > 0 ? paint / area : 0; }

  void absorb(const Painted_region& other, const RS::Visibility_section_data& between)
  {
    RS::Visibility_region_data::absorb(other, between);
    paint += other.paint;
  }
};

// Fills the data of regions of the faces.
struct Paint_annotator : RS::Visibility_annotator
{
  using RegionData = Painted_region;

  std::vector<double> gray; // by face, in iteration order

  template <typename Graph>
  void operator()(Graph& graph, const RS::Surface& surface, const RS::Partition& regions,
                  const RS::Region_rays& rays) const
  {
    RS::Visibility_annotator::operator()(graph, surface, regions, rays);
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
      graph[regions[f]].paint += gray[f] * surface.area(f) / surface.area();
  }
};

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto gray = mesh.add_property_map<Mesh::Face_index, double>("f:gray").first;
  for (auto f : faces(mesh)) // one half is painted
    gray[f] = mesh.point(target(halfedge(f, mesh), mesh)).x() < 0 ? 0 : 1;
  const Paint_annotator annotator{{}, RS::face_values(mesh, gray)};

  for (double weight : {0, 20}) {
    const auto cost = [weight](const auto& graph, auto section) {
      return RS::Visibility_cost()(graph, section) +
             weight *
               std::abs(graph[graph.source(section)].gray() - graph[graph.target(section)].gray());
    };
    const RS::Superfacet_merging method{annotator, RS::Lowest_cost_first(cost),
                                        RS::Number_from_costs(-19.5)};
    RS::segment(mesh, segment_id, RS::parameters::number_of_segments(12).method(method));
    std::size_t number = 0;
    for (auto h : halfedges(mesh)) {
      const auto f = face(h, mesh), g = face(opposite(h, mesh), mesh);
      number += f < g && g != Mesh::null_face() && gray[f] != gray[g] &&
                segment_id[f] == segment_id[g];
    }
    std::cout << number << " edges of the paint within segments with weight " << weight << '\n';
  }
  write_colored(mesh, segment_id, "scalar.ply");
}
