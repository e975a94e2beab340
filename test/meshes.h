// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_MESHES_H
#define CGAL_REGION_SEGMENTATION_TEST_MESHES_H

// The meshes that the tests run on: made here, never read, and chosen by property. They are polygon
// soups, the common language of the oracles, the reference implementation and every mesh type.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

using Point = std::array<double, 3>;
using Polygon = std::vector<std::size_t>; // vertex indices, counterclockwise seen from outside
using Edge = std::pair<std::size_t, std::size_t>; // vertex indices, the lower one first
using Voxel = std::array<int, 3>;

struct Soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

inline Edge make_edge(std::size_t u, std::size_t v)
{
  return u < v ? Edge(u, v) : Edge(v, u);
}

// Shapes

/// An open sheet of nx times ny unit squares in z = 0; vertex (x, y) is y * (nx + 1) + x, face (x,
/// y) is y * nx + x.
Soup grid(std::size_t nx, std::size_t ny);

/// The surface of a set of unit cubes, in unit squares. Faces come cube by cube, each in the order
/// -x +x -y +y -z +z; squares between two cubes are left out.
Soup voxel_surface(const std::vector<Voxel>& voxels);
std::vector<Voxel> voxel_block(const Voxel& from, const Voxel& to); // `to` is not in the block

Soup cube();

/// Two boxes in an L, seen from above; the edge at + is concave, both its ends are free.
///     +---+
///     |   |
///     +   +---+
///     |       |
///     +---+---+
Soup l_shape();

/// A cube on the middle of a plate of 3 x 3: the line where they touch is concave and closed.
///         +-+
///      +--+-+--+
///      +-------+
Soup box_on_plate();

/// Two cubes of side 3 and a bar of 1 x 1 x 2 between them; faces: first cube, bar, second cube.
///      +---+     +---+
///      |   +-----+   |
///      |   +-----+   |
///      +---+     +---+
Soup dumbbell();

/// Two quads with the same four vertices, back to back: they share four edges.
Soup pillow();

/// A subdivided octahedron, its points on the unit sphere; 8 * 4^levels faces.
Soup sphere(std::size_t levels);

/// Quads around a torus of radii 2 and `tube`.
Soup torus(std::size_t around, std::size_t across, double tube = 1);

/// The surface of a box of unit cubes, in unit squares.
Soup block(int nx, int ny, int nz);

/// The unit cube in 12 n^2 triangles; its sides have points of their own, which in a polygon soup
/// are merged.
Soup box_of_sheets(std::size_t n);

/// A flat cap (0 1 2), vertex 2 in the middle of 0 1, between one large and two small triangles.
///        3
///      / | \        .
///     0--2--1       faces: 0 1 2, 0 2 3, 2 1 3, 0 4 1
///      \   /
///        4
Soup cap();

/// Two quads at a right angle, a roof, and on its ridge a needle 2 3 4 of which 3 and 4 coincide.
///      0-----1
///      |     |
///      2-----3=4    the quad above is 0 2 3 1, the one below 2 5 6 4; the ridge is convex
///      |     |
///      5-----6
Soup needle_on_crease();

// Changes

/// Fans; for faces that are convex, or where it does not matter.
Soup triangulated(const Soup& soup);
Soup reversed(const Soup& soup);
Soup mapped(const Soup& soup, const std::function<Point(const Point&)>& map);
Soup scaled(const Soup& soup, double factor);
Soup translated(const Soup& soup, double x, double y, double z);
/// By two angles in radian, about the z axis and then about the x axis.
Soup rotated(const Soup& soup, double about_z, double about_x);
/// One mesh of two parts that do not touch.
Soup joined(const Soup& a, const Soup& b);
Soup joined(const std::vector<Soup>& soups);
/// Each polygon has points of its own, as in a file of STL.
Soup torn(const Soup& soup);
/// Reverses one polygon of so many, at random.
void flip_some(Soup& soup, unsigned one_of, std::mt19937& random);
void shuffle_faces(Soup& soup, std::mt19937& random);
/// `new_of_old` receives the new number of each old vertex.
void shuffle_vertices(Soup& soup, std::mt19937& random, std::vector<std::size_t>& new_of_old);
/// Moves every coordinate by at most `amplitude`, in steps of 2^-16: sums of a few are exact, and
/// float holds them.
void bump(Soup& soup, double amplitude, std::mt19937& random);
/// All points moved by independent normal deviates, of this standard deviation for each coordinate.
Soup with_noise(const Soup& soup, double deviation, unsigned seed);
/// Lets some vertices coincide with a neighbor: needles, and faces without any extent.
void collapse_some(Soup& soup, std::size_t count, std::mt19937& random);
/// Moves some corners of triangles onto the opposite edge: caps.
void flatten_some(Soup& soup, std::size_t count, std::mt19937& random);

/// No halfedge twice, and one fan of faces around every vertex.
bool is_manifold(const Soup& soup);

// Random meshes

enum class Family {
  SHEET,            // open, triangles
  QUAD_SHEET,       // open, quads that are not flat
  POLYGON_SHEET,    // open, faces of 4 to 6 vertices, some of which share two edges
  SPHERE,           // closed, genus 0
  TORUS,            // closed, genus 1, quads
  BLOCKS,           // closed, boxes glued at random, corners moved a little
  TWO_COMPONENTS,   // a sphere and a sheet
  DEGENERATE_SHEET, // with needles and caps
  DEGENERATE_TORUS  // closed, with polygons that have no area
};
constexpr Family all_families[] = {
  Family::SHEET,           Family::QUAD_SHEET, Family::POLYGON_SHEET,  Family::SPHERE,
  Family::TORUS,           Family::BLOCKS,     Family::TWO_COMPONENTS, Family::DEGENERATE_SHEET,
  Family::DEGENERATE_TORUS};
std::string name(Family family);
bool has_degenerate_faces(Family family);
std::ostream& operator<<(std::ostream& out, Family family);

/// The surface of boxes that are glued at random, in at least 40 unit squares.
Soup random_blocks(std::mt19937& random);

/// 50 to 400 faces in shuffled order; the same for the same seed. Coordinates are multiples of
/// 2^-16 below 2^7, but for caps.
Soup random_mesh(Family family, unsigned seed);

// Conversion

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// A mesh of any type with its vertices and faces in the order of the soup. `add_point(mesh, p)`
/// adds a vertex and returns it.
template <typename Mesh, typename AddPoint>
void fill_mesh(const Soup& soup, Mesh& mesh, AddPoint add_point)
{
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> descriptors, polygon;
  for (const Point& p : soup.points)
    descriptors.push_back(add_point(mesh, p));
  for (const Polygon& indices : soup.polygons) {
    polygon.clear();
    for (std::size_t i : indices)
      polygon.push_back(descriptors[i]);
    if (CGAL::Euler::add_face(polygon, mesh) == boost::graph_traits<Mesh>::null_face())
      throw std::logic_error("the soup is no manifold");
  }
}

/// For mesh types whose points are made of three coordinates and put into a property map.
template <typename Mesh>
Mesh to_mesh(const Soup& soup)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Mesh_point = typename boost::property_traits<Map>::value_type;
  using Number = std::decay_t<decltype(std::declval<Mesh_point>()[0])>;
  Mesh result;
  fill_mesh(soup, result, [](Mesh& mesh, const Point& p) {
    const Vertex v = add_vertex(mesh);
    put(get(CGAL::vertex_point, mesh), v, Mesh_point(Number(p[0]), Number(p[1]), Number(p[2])));
    return v;
  });
  return result;
}

inline Surface_mesh to_surface_mesh(const Soup& soup)
{
  return to_mesh<Surface_mesh>(soup);
}

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_MESHES_H
