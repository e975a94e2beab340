// SPDX-License-Identifier: GPL-3.0-or-later

// The matrix of mesh types and kernels. Coordinates of the random meshes are multiples of 2^-16
// below 2^7, so float holds them, and every type must give the same labels.

#ifdef TEST_OPENMESH
// Before CGAL, as its manual says of OpenMesh's own headers.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#endif

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#ifdef TEST_OPENMESH
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/segment.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>

namespace {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Double_kernel = CGAL::Simple_cartesian<double>;
using Float_kernel = CGAL::Simple_cartesian<float>;
using Lcc_traits = CGAL::Linear_cell_complex_traits<3, Kernel>;
using Lcc = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Lcc_traits>::type;

#ifdef TEST_OPENMESH
struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Double_poly_mesh = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;
using Double_tri_mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;
using Float_poly_mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using Float_tri_mesh = OpenMesh::TriMesh_ArrayKernelT<>;
#endif

template <typename Mesh>
Mesh make(const Soup& soup)
{
  Mesh mesh;
  if constexpr (std::is_same_v<Mesh, Lcc>)
    fill_mesh(soup, mesh, [](Lcc& m, const Point& p) {
      const auto v = add_vertex(m);
      v->point() = Lcc::Point(p[0], p[1], p[2]);
      return v;
    });
#ifdef TEST_OPENMESH
  else if constexpr (std::is_base_of_v<OpenMesh::BaseKernel, Mesh>) // CGAL's put() of a point would
    fill_mesh(soup, mesh, [](Mesh& m, const Point& p) {             // cast to float
      using Number = typename Mesh::Scalar;
      return m.add_vertex(typename Mesh::Point(Number(p[0]), Number(p[1]), Number(p[2])));
    });
#endif
  else
    mesh = to_mesh<Mesh>(soup);
  return mesh;
}

template <typename Mesh>
bool takes(const Soup& soup)
{
#ifdef TEST_OPENMESH
  if (std::is_base_of_v<OpenMesh::TriConnectivity, Mesh>)
    return std::all_of(soup.polygons.begin(), soup.polygons.end(),
                       [](const Polygon& p) { return p.size() == 3; });
#endif
  return !soup.polygons.empty();
}

/// With the default method, for a number and for one that is chosen.
template <typename Mesh>
std::vector<Result> run_default(const Mesh& mesh, const Options& options)
{
  const RS::Learned_merging method;
  std::vector<Result> results;
  const auto add = [&](const auto& np) {
    results.push_back(
      options.constrained_edges.empty()
        ? run(mesh, np)
        : run(mesh, np.edge_is_constrained_map(edge_map(mesh, options.constrained_edges))));
  };
  add(RS::parameters::number_of_segments(options.k).method(method));
  add(RS::parameters::method(method));
  return results;
}

template <typename Mesh>
void expect_default_as_surface_mesh(const Mesh& mesh, const Options& options)
{
  const auto results = run_default(mesh, options),
             expected = run_default(to_surface_mesh(soup_of(mesh)), options);
  for (std::size_t i = 0; i < results.size(); ++i) {
    expect_same(results[i], expected[i]);
    ASSERT_EQ(results[i].tree.merges().size(), expected[i].tree.merges().size());
    for (std::size_t m = 0; m < results[i].tree.merges().size(); ++m)
      ASSERT_EQ(results[i].tree.merges()[m].cost, expected[i].tree.merges()[m].cost);
  }
}

/// Whatever the type and the order of its elements: as the `Surface_mesh` made from what it
/// iterates over.
template <typename Mesh>
void expect_as_surface_mesh(const Mesh& mesh, const Options& options)
{
  expect_same(run(mesh, options), run(soup_of(mesh), options));
  expect_default_as_surface_mesh(mesh, options);
}

template <typename Mesh>
struct Mesh_types_test : ::testing::Test
{};

using Mesh_types = ::testing::Types<
  Surface_mesh, CGAL::Surface_mesh<Float_kernel::Point_3>, CGAL::Polyhedron_3<Double_kernel>,
  CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>, Lcc
#ifdef TEST_OPENMESH
  ,
  Double_poly_mesh, Double_tri_mesh, Float_poly_mesh, Float_tri_mesh
#endif
  >;

TYPED_TEST_SUITE(Mesh_types_test, Mesh_types);

TYPED_TEST(Mesh_types_test, gives_the_same_labels)
{
  std::size_t meshes = 0;
  for_each_random_mesh(all_families, 4, [&](const Soup& soup, unsigned seed) {
    if (!takes<TypeParam>(soup))
      return;
    ++meshes;
    std::mt19937 random(seed);
    Options options = random_options(random);
    options.k = 4;
    const TypeParam mesh = make<TypeParam>(soup);
    expect_as_surface_mesh(mesh, options);
    // The types keep the order in which they were made, so these are the labels of the soup.
    expect_same(run(mesh, options), run(soup, options));
  });
  EXPECT_GE(meshes, 12u); // triangles alone come from three families
}

#ifdef TEST_EIGEN
TYPED_TEST(Mesh_types_test, has_the_same_smooth_faces)
{
  for (Family family : all_families) {
    SCOPED_TRACE(name(family));
    const Soup soup = random_mesh(family, 5);
    if (!takes<TypeParam>(soup))
      continue;
    const TypeParam mesh = make<TypeParam>(soup);
    const auto np = RS::parameters::method(RS::Smooth_faces());
    EXPECT_EQ(segments_of(mesh, np), segments_of(to_surface_mesh(soup_of(mesh)), np));
  }
}
#endif

TYPED_TEST(Mesh_types_test, takes_constrained_edges)
{
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const TypeParam mesh = make<TypeParam>(random_mesh(Family::SPHERE, seed));
    Options options(3, reference::Convexity::all, 20);
    const Soup soup = soup_of(mesh);
    options.constrained_edges = random_edges(soup, 8, random);
    expect_as_surface_mesh(mesh, options);
  }
}

TYPED_TEST(Mesh_types_test, takes_seeds)
{
  const Options options(3);
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TypeParam mesh = make<TypeParam>(random_mesh(Family::SPHERE, seed));
    const auto segments = [&](const auto& any_mesh, const auto& method) {
      auto seeds = face_map(any_mesh, std::size_t(-1));
      std::size_t i = 0;
      for (auto f : faces(any_mesh)) {
        if (i % 20 == 3)
          put(seeds, f, i < 60 ? 5 : i);
        ++i;
      }
      return segments_of(any_mesh,
                         RS::parameters::number_of_segments(4).method(method).face_seed_map(seeds));
    };
    const Surface_mesh same = to_surface_mesh(soup_of(mesh));
    EXPECT_EQ(segments(mesh, RS::Learned_merging()), segments(same, RS::Learned_merging()));
    EXPECT_EQ(segments(mesh, options.method()), segments(same, options.method()));
  }
}

TYPED_TEST(Mesh_types_test, has_voids)
{
  const Soup soup = joined(scaled(sphere(3), 2), reversed(translated(sphere(2), 0.3, 0.4, 0.5)));
  const TypeParam mesh = make<TypeParam>(soup);
  Options options(4, reference::Convexity::all, 5);
  expect_default_as_surface_mesh(mesh, options);
  const auto np = RS::parameters::number_of_segments(4).method(options.method());
  EXPECT_EQ(segments_of(mesh, np), segments_of(to_surface_mesh(soup_of(mesh)), np));
  EXPECT_EQ(segments_of(mesh, RS::parameters::number_of_segments(1).method(options.method())),
            Labels(soup.polygons.size(), 0));
}

TYPED_TEST(Mesh_types_test, takes_an_empty_mesh)
{
  const TypeParam mesh;
  EXPECT_EQ(run(mesh, Options(3)).number_of_segments, 0u);
  EXPECT_EQ(run(mesh, RS::parameters::number_of_segments(3)).number_of_segments, 0u);
  EXPECT_EQ(segments_of(mesh, RS::parameters::default_values()).size(), 0u);
}

// Removed faces that are still there: sizes count them, ranges do not.

/// Faces 0 and 5 of a sheet, then every fifth; none of them share a vertex with another.
template <typename Mesh>
void remove_some_faces(Mesh& mesh)
{
  std::vector<typename boost::graph_traits<Mesh>::face_descriptor> doomed;
  std::size_t i = 0;
  for (auto f : faces(mesh)) {
    const std::size_t x = i % 9, y = i / 9;
    if (x % 3 == 1 && y % 3 == 1)
      doomed.push_back(f);
    ++i;
  }
  for (auto f : doomed)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
}

template <typename Mesh>
struct Garbage_test : ::testing::Test
{};
using Garbage_types = ::testing::Types<Surface_mesh, CGAL::Polyhedron_3<Kernel>,
                                       CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>
#ifdef TEST_OPENMESH
                                       ,
                                       Double_poly_mesh
#endif
                                       >;
TYPED_TEST_SUITE(Garbage_test, Garbage_types);

TYPED_TEST(Garbage_test, gives_the_labels_of_what_is_left)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Soup soup = grid(9, 9);
    bump(soup, 0.3, random);
    TypeParam mesh = make<TypeParam>(soup);
    remove_some_faces(mesh);
    ASSERT_EQ(soup_of(mesh).polygons.size(), 81u - 9u);
    Options options(4, reference::Convexity::all, 15);
    expect_as_surface_mesh(mesh, options);
  }
}

TEST(Garbage_of_surface_mesh_test, is_really_there)
{
  Surface_mesh mesh = to_surface_mesh(grid(9, 9));
  remove_some_faces(mesh);
  EXPECT_TRUE(mesh.has_garbage());
  EXPECT_EQ(num_faces(mesh), 81u);
}

// Part of a mesh

TEST(Const_mesh_test, keeps_its_ids)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  auto mesh = make<Polyhedron>(box_on_plate());
  const auto np = RS::parameters::number_of_segments(2).method(RS::Two_step());
  const Labels labels = segments_of(mesh, np);
  const auto set_ids = [](auto range) {
    for (auto element : range)
      element->id() = 7;
  };
  set_ids(faces(mesh));
  set_ids(vertices(mesh));
  set_ids(halfedges(mesh));
  const Polyhedron& given = mesh;
  EXPECT_EQ(segments_of(given, np), labels);
  const auto expect_ids = [](auto range) {
    for (auto element : range)
      EXPECT_EQ(element->id(), 7u);
  };
  expect_ids(faces(mesh));
  expect_ids(vertices(mesh));
  expect_ids(halfedges(mesh));
}

TEST(Face_filtered_graph_test, gives_the_labels_of_its_part)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Soup soup = grid(12, 9);
    bump(soup, 0.3, random);
    Surface_mesh mesh = to_surface_mesh(soup);
    std::vector<Surface_mesh::Face_index> part; // a ring, open to the left
    for (auto f : faces(mesh)) {
      const std::size_t x = std::size_t(f) % 12, y = std::size_t(f) / 12;
      if (y < 3 || y >= 6 || x >= 8)
        part.push_back(f);
    }
    const CGAL::Face_filtered_graph<Surface_mesh> filtered(mesh, part);
    ASSERT_EQ(soup_of(filtered).polygons.size(), part.size());
    for (std::size_t k : {1, 4})
      expect_as_surface_mesh(filtered, Options(k, reference::Convexity::all, 15));
  }
}

} // namespace
