// SPDX-License-Identifier: GPL-3.0-or-later

// What comes after a segmentation, on OpenMesh: the same as on Surface_mesh.

// Before CGAL, as its manual says of OpenMesh's own headers.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "segments.h"

#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/helpers.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

namespace segments_mesh_types_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

template <typename Mesh>
Mesh to_openmesh(const Soup& soup) // CGAL's put() of a point would cast to float
{
  Mesh mesh;
  fill_mesh(soup, mesh, [](Mesh& m, const Point& p) { return m.add_vertex({p[0], p[1], p[2]}); });
  return mesh;
}

/// What the functions output, by numbers of vertices and faces.
struct Results
{
  Edge_flags borders;
  std::vector<std::vector<Edge>> lines;
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t, std::ptrdiff_t>> topologies;
  std::vector<Soup> pieces;
  std::vector<double> areas_and_errors;
  Labels transferred;
};

#ifdef TEST_EIGEN
template <typename Mesh>
using Kernel_of_points = typename CGAL::Kernel_traits<
  typename boost::property_map_value<Mesh, CGAL::vertex_point_t>::type>::Kernel;
#endif

template <typename Mesh>
Results results_on(const Mesh& mesh, const Labels& labels)
{
  Results results;
  const auto segments = face_labels(mesh, labels);
  const Ranks<Mesh> rank(mesh);
  auto marks = edge_map(mesh);
  RS::mark_segment_borders(mesh, segments, marks);
  results.borders = flags_of(mesh, marks);

  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(mesh, segments, std::back_inserter(borders));
  for (const auto& border : borders) {
    results.lines.emplace_back();
    for (auto h : border.halfedges)
      results.lines.back().push_back({rank(source(h, mesh)), rank(target(h, mesh))});
  }
  std::vector<RS::Segment_topology<std::size_t>> topologies;
  RS::compute_segment_topology(mesh, segments, std::back_inserter(topologies));
  for (const auto& t : topologies)
    results.topologies.push_back(
      {t.segment, t.number_of_components, t.number_of_border_loops, t.euler_characteristic});

  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, segments, std::back_inserter(pieces));
#ifdef TEST_EIGEN
  RS::close_segments(mesh, segments, std::back_inserter(pieces));
#endif
  auto copies = face_map(mesh);
  RS::transfer_labels(mesh, segments, mesh, copies);
  results.transferred = labels_of(mesh, copies);
  for (const auto& piece : pieces) {
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(piece.mesh));
    results.pieces.push_back(soup_of(piece.mesh));
    for (Polygon& polygon : results.pieces.back().polygons) // from the same corner on every mesh
                                                            // type
      std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  }
#ifdef TEST_EIGEN
  std::vector<RS::Segment_description<std::size_t, Kernel_of_points<Mesh>>> descriptions;
  RS::describe_segments(mesh, segments, std::back_inserter(descriptions));
  for (const auto& d : descriptions)
    results.areas_and_errors.insert(results.areas_and_errors.end(),
                                    {d.area, d.volume, d.surface_error()});
#endif
  return results;
}

template <typename Mesh>
void expect_same_results(Family family, const Soup& soup, unsigned seed)
{
  SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
  const Labels labels = random_labels(soup, 2 + seed, seed);
  const Mesh mesh = to_openmesh<Mesh>(soup);
  const Results expected = results_on(to_surface_mesh(soup), labels),
                results = results_on(mesh, labels);
  EXPECT_EQ(results.borders, expected.borders);
  EXPECT_EQ(results.lines, expected.lines);
  EXPECT_EQ(results.topologies, expected.topologies);
  EXPECT_EQ(results.transferred, expected.transferred);
  EXPECT_EQ(results.areas_and_errors, expected.areas_and_errors);
  ASSERT_EQ(results.pieces.size(), expected.pieces.size());
  for (std::size_t i = 0; i < results.pieces.size(); ++i)
    EXPECT_EQ(results.pieces[i].points.size(), expected.pieces[i].points.size());
}

TEST(Segments_on_openmesh, are_those_on_surface_mesh)
{
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Soup soup = random_mesh(family, seed);
      expect_same_results<OpenMesh::PolyMesh_ArrayKernelT<Double_traits>>(family, soup, seed);
      expect_same_results<OpenMesh::TriMesh_ArrayKernelT<Double_traits>>(family, triangulated(soup),
                                                                         seed);
    }
}

TEST(Segments_on_openmesh, pieces_know_their_border_vertices)
{
  using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;
  const Mesh mesh = to_openmesh<Mesh>(grid(4, 4));
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, face_labels(mesh, Labels(16, 0)), std::back_inserter(pieces));
  ASSERT_EQ(pieces.size(), 1u);
  std::size_t on_border = 0;
  for (auto v : pieces[0].mesh.vertices())
    on_border += pieces[0].mesh.is_boundary(v); // by the outgoing halfedge alone
  EXPECT_EQ(on_border, 16u);
}

} // namespace segments_mesh_types_test
