// SPDX-License-Identifier: GPL-3.0-or-later
//
// How close `Smooth_faces` comes to the faces of machine parts, without a number.

#include "models/machine_parts.h"
#include "soup/link_corners.h"

#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#include <CGAL/Region_segmentation/evaluation/rand_index_distance.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace segment_mesh {

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Mesh to_mesh(const Polygon_soup& soup)
{
  Mesh mesh;
  for (const Point& p : soup.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    std::vector<Mesh::Vertex_index> corners;
    for (std::size_t v : polygon)
      corners.push_back(Mesh::Vertex_index(Mesh::size_type(v)));
    EXPECT_NE(mesh.add_face(corners), Mesh::null_face());
  }
  return mesh;
}

double distance_to_faces(const Machine_part& part)
{
  const Labelled_model model = part.make();
  Mesh mesh = to_mesh(model.soup);
  auto map = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:face").first;
  const std::size_t number = RS::segment(mesh, map, RS::parameters::method(RS::Smooth_faces()));
  std::vector<std::size_t> found;
  for (const Mesh::Face_index f : mesh.faces())
    found.push_back(map[f]);
  const double distance = RS::rand_index_distance(model.labels, found);
  std::cout << part.name << ": " << found.size() << " triangles, " << model.number_of_parts << " faces, " << number
            << " found, " << distance << "\n";
  return distance;
}

TEST(Machine_parts, are_closed_oriented_manifolds_of_one_piece)
{
  for (const Machine_part& part : machine_parts()) {
    SCOPED_TRACE(part.name);
    const Labelled_model model = part.make();
    EXPECT_TRUE(is_oriented_manifold(model.soup));
    ASSERT_EQ(model.labels.size(), model.soup.polygons.size());
    EXPECT_EQ(std::set<std::size_t>(model.labels.begin(), model.labels.end()).size(), model.number_of_parts);
    const Mesh mesh = to_mesh(model.soup);
    EXPECT_TRUE(CGAL::is_closed(mesh));
    const long characteristic =
      long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
    EXPECT_EQ(characteristic, part.loft.bore > 0 ? 0 : 2);
    std::vector<std::size_t> segments(mesh.number_of_faces());
    const auto map = boost::make_iterator_property_map(segments.begin(), get(boost::face_index, mesh));
    EXPECT_EQ(RS::segment(mesh, map, RS::parameters::number_of_segments(1).method(RS::Smooth_faces())), 1u);
  }
  EXPECT_EQ(machine_parts().size(), 40u);
}

/// The bounds of what was asked for; figures are in doc/accuracy.md.
TEST(Machine_parts, have_the_smooth_faces_that_are_found)
{
  double sums[] = {0, 0}, numbers[] = {0, 0}; // without, with fillets
  for (const Machine_part& part : machine_parts()) {
    sums[part.has_fillets] += distance_to_faces(part);
    ++numbers[part.has_fillets];
  }
  std::cout << "mean: " << sums[0] / numbers[0] << ", with fillets " << sums[1] / numbers[1] << "\n";
  EXPECT_LE(sums[0] / numbers[0], 0.005);
  EXPECT_LE(sums[1] / numbers[1], 0.03);
}

} // namespace

} // namespace segment_mesh
