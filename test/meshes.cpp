// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>

namespace test {

namespace {

// Not std::uniform_int_distribution: its numbers differ between standard libraries.
std::size_t below(std::size_t n, std::mt19937& random)
{
  return random() % n;
}

double on_lattice(double x) // multiples of 2^-16
{
  return std::round(x * 65536) / 65536;
}

void put_on_lattice(Soup& soup)
{
  for (Point& p : soup.points)
    for (double& x : p)
      x = on_lattice(x);
}

/// Joins pairs of squares in a grid: a face of six vertices each. Two that lie side by side with a
/// vertex between that no other face has share two edges.
///      +--+--+        +--+--+
///      |  |  |        |  |  |
///      +--+--+   ->   +  +  +     the two share a-b and b-c; b has two faces
///      |  |  |        |  |  |
///      +--+--+        +--+--+
Soup polygon_sheet(std::size_t nx, std::size_t ny, std::mt19937& random)
{
  Soup soup = grid(2 * nx, 2 * ny);
  soup.polygons.clear();
  const std::size_t row = 2 * nx + 1;
  for (std::size_t y = 0; y < ny; ++y)
    for (std::size_t x = 0; x < nx; ++x) {
      const std::size_t v = 2 * y * row + 2 * x;
      const auto at = [&](std::size_t i, std::size_t j) { return v + j * row + i; };
      switch (below(3, random)) {
      case 0: // four quads
        for (std::size_t j = 0; j < 2; ++j)
          for (std::size_t i = 0; i < 2; ++i)
            soup.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        break;
      case 1: // left and right
        for (std::size_t i = 0; i < 2; ++i)
          soup.polygons.push_back(
            {at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i + 1, 2), at(i, 2), at(i, 1)});
        break;
      default: // a pentagon, a triangle and two quads
        soup.polygons.push_back({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
        soup.polygons.push_back({at(1, 0), at(2, 0), at(2, 1), at(1, 1)});
        soup.polygons.push_back({at(0, 1), at(1, 1), at(2, 1), at(1, 2), at(0, 2)});
        soup.polygons.push_back({at(2, 1), at(2, 2), at(1, 2)});
      }
    }
  return soup;
}

} // namespace

Soup grid(std::size_t nx, std::size_t ny)
{
  Soup soup;
  for (std::size_t y = 0; y <= ny; ++y)
    for (std::size_t x = 0; x <= nx; ++x)
      soup.points.push_back({double(x), double(y), 0});
  for (std::size_t y = 0; y < ny; ++y)
    for (std::size_t x = 0; x < nx; ++x) {
      const std::size_t v = y * (nx + 1) + x;
      soup.polygons.push_back({v, v + 1, v + nx + 2, v + nx + 1});
    }
  return soup;
}

Soup voxel_surface(const std::vector<Voxel>& voxels)
{
  Soup soup;
  const std::set<Voxel> is_full(voxels.begin(), voxels.end());
  std::map<Voxel, std::size_t> vertex_at;
  const auto vertex = [&](const Voxel& p) {
    const auto [place, is_new] = vertex_at.emplace(p, soup.points.size());
    if (is_new)
      soup.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return place->second;
  };
  for (const Voxel& v : voxels)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        Voxel neighbor = v;
        neighbor[axis] += side ? 1 : -1;
        if (is_full.count(neighbor))
          continue;
        Voxel corner = v;
        corner[axis] += side;
        const int u = (axis + 1) % 3, w = (axis + 2) % 3; // u x w = axis
        Polygon square;
        for (const auto& [du, dw] :
             {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
          Voxel p = corner;
          p[u] += du;
          p[w] += dw;
          square.push_back(vertex(p));
        }
        if (!side)
          std::reverse(square.begin() + 1, square.end());
        soup.polygons.push_back(square);
      }
  return soup;
}

std::vector<Voxel> voxel_block(const Voxel& from, const Voxel& to)
{
  std::vector<Voxel> voxels;
  for (int x = from[0]; x < to[0]; ++x)
    for (int y = from[1]; y < to[1]; ++y)
      for (int z = from[2]; z < to[2]; ++z)
        voxels.push_back({x, y, z});
  return voxels;
}

Soup block(int nx, int ny, int nz)
{
  return voxel_surface(voxel_block({0, 0, 0}, {nx, ny, nz}));
}

Soup cube()
{
  return block(1, 1, 1);
}

Soup box_of_sheets(std::size_t n)
{
  std::vector<Soup> sides;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double place : {0., 1.}) {
      const Soup side = mapped(triangulated(grid(n, n)), [=](const Point& p) {
        Point q;
        q[axis] = place;
        q[(axis + 1) % 3] = p[0] / double(n);
        q[(axis + 2) % 3] = p[1] / double(n);
        return q;
      });
      sides.push_back(place == 0 ? reversed(side) : side);
    }
  return joined(sides);
}

Soup l_shape()
{
  return voxel_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

Soup box_on_plate()
{
  auto voxels = voxel_block({0, 0, 0}, {3, 3, 1});
  voxels.push_back({1, 1, 1});
  return voxel_surface(voxels);
}

Soup dumbbell()
{
  auto voxels = voxel_block({0, 0, 0}, {3, 3, 3});
  for (const auto& part : {voxel_block({3, 1, 1}, {5, 2, 2}), voxel_block({5, 0, 0}, {8, 3, 3})})
    voxels.insert(voxels.end(), part.begin(), part.end());
  return voxel_surface(voxels);
}

Soup pillow()
{
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {3, 2, 1, 0}}};
}

Soup sphere(std::size_t levels)
{
  Soup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.polygons = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                   {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (; levels > 0; --levels) {
    std::map<Edge, std::size_t> middle_of;
    const auto middle = [&](std::size_t u, std::size_t v) {
      const auto [place, is_new] = middle_of.emplace(make_edge(u, v), soup.points.size());
      if (is_new) {
        Point p;
        for (int i = 0; i < 3; ++i)
          p[i] = (soup.points[u][i] + soup.points[v][i]) / 2;
        soup.points.push_back(p);
      }
      return place->second;
    };
    std::vector<Polygon> finer;
    for (const Polygon& t : soup.polygons) {
      const std::size_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      for (const Polygon& s : {Polygon{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}})
        finer.push_back(s);
    }
    soup.polygons = finer;
  }
  for (Point& p : soup.points) {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    p = {p[0] / length, p[1] / length, p[2] / length};
  }
  return soup;
}

Soup torus(std::size_t around, std::size_t across, double tube)
{
  Soup soup;
  const double turn = 2 * std::acos(-1.0);
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      const double a = turn * double(i) / double(around), b = turn * double(j) / double(across);
      const double r = 2 + tube * std::cos(b);
      soup.points.push_back({r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
      const std::size_t i1 = (i + 1) % around, j1 = (j + 1) % across;
      soup.polygons.push_back({i * across + j, i1 * across + j, i1 * across + j1, i * across + j1});
    }
  return soup;
}

Soup cap()
{
  return {{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {0, 4, 1}}};
}

Soup needle_on_crease()
{
  return {{{0, 2, -1}, {2, 2, -1}, {0, 1, 0}, {2, 1, 0}, {2, 1, 0}, {0, 0, -1}, {2, 0, -1}},
          {{0, 2, 3, 1}, {2, 4, 3}, {2, 5, 6, 4}}};
}

Soup triangulated(const Soup& soup)
{
  Soup result{soup.points, {}};
  for (const Polygon& p : soup.polygons)
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
      result.polygons.push_back({p[0], p[i], p[i + 1]});
  return result;
}

Soup reversed(const Soup& soup)
{
  Soup result = soup;
  for (Polygon& p : result.polygons)
    std::reverse(p.begin(), p.end());
  return result;
}

Soup mapped(const Soup& soup, const std::function<Point(const Point&)>& map)
{
  Soup result = soup;
  for (Point& p : result.points)
    p = map(p);
  return result;
}

Soup scaled(const Soup& soup, double factor)
{
  return mapped(soup, [=](const Point& p) {
    return Point{p[0] * factor, p[1] * factor, p[2] * factor};
  });
}

Soup translated(const Soup& soup, double x, double y, double z)
{
  return mapped(soup, [=](const Point& p) { return Point{p[0] + x, p[1] + y, p[2] + z}; });
}

Soup rotated(const Soup& soup, double about_z, double about_x)
{
  return mapped(soup, [=](const Point& p) {
    const double x = std::cos(about_z) * p[0] - std::sin(about_z) * p[1],
                 y = std::sin(about_z) * p[0] + std::cos(about_z) * p[1];
    return Point{x, std::cos(about_x) * y - std::sin(about_x) * p[2],
                 std::sin(about_x) * y + std::cos(about_x) * p[2]};
  });
}

Soup joined(const Soup& a, const Soup& b)
{
  Soup result = a;
  result.points.insert(result.points.end(), b.points.begin(), b.points.end());
  for (Polygon p : b.polygons) {
    for (std::size_t& v : p)
      v += a.points.size();
    result.polygons.push_back(p);
  }
  return result;
}

Soup joined(const std::vector<Soup>& soups)
{
  Soup result;
  for (const Soup& soup : soups)
    result = joined(result, soup);
  return result;
}

Soup torn(const Soup& soup)
{
  Soup result;
  for (const Polygon& polygon : soup.polygons) {
    result.polygons.emplace_back();
    for (std::size_t v : polygon) {
      result.polygons.back().push_back(result.points.size());
      result.points.push_back(soup.points[v]);
    }
  }
  return result;
}

void flip_some(Soup& soup, unsigned one_of, std::mt19937& random)
{
  for (Polygon& polygon : soup.polygons)
    if (random() % one_of == 0)
      std::reverse(polygon.begin(), polygon.end());
}

void shuffle_faces(Soup& soup, std::mt19937& random)
{
  for (std::size_t i = soup.polygons.size(); i > 1; --i)
    std::swap(soup.polygons[i - 1], soup.polygons[below(i, random)]);
}

void shuffle_vertices(Soup& soup, std::mt19937& random, std::vector<std::size_t>& new_of_old)
{
  new_of_old.resize(soup.points.size());
  for (std::size_t i = 0; i < new_of_old.size(); ++i)
    new_of_old[i] = i;
  for (std::size_t i = new_of_old.size(); i > 1; --i)
    std::swap(new_of_old[i - 1], new_of_old[below(i, random)]);
  const Soup old = soup;
  for (std::size_t v = 0; v < new_of_old.size(); ++v)
    soup.points[new_of_old[v]] = old.points[v];
  for (Polygon& p : soup.polygons)
    for (std::size_t& v : p)
      v = new_of_old[v];
}

void bump(Soup& soup, double amplitude, std::mt19937& random)
{
  for (Point& p : soup.points)
    for (double& x : p)
      x += on_lattice((2 * double(random()) / 4294967296.0 - 1) * amplitude);
}

Soup with_noise(const Soup& soup, double deviation, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> moves(0, deviation);
  return mapped(soup, [&](const Point& p) {
    const double x = moves(random), y = moves(random), z = moves(random);
    return Point{p[0] + x, p[1] + y, p[2] + z};
  });
}

void collapse_some(Soup& soup, std::size_t count, std::mt19937& random)
{
  for (; count > 0; --count) {
    const Polygon& p = soup.polygons[below(soup.polygons.size(), random)];
    const std::size_t i = below(p.size(), random);
    soup.points[p[i]] = soup.points[p[(i + 1) % p.size()]];
    if (below(4, random) == 0) // all of the face in one point
      for (std::size_t v : p)
        soup.points[v] = soup.points[p[0]];
  }
}

void flatten_some(Soup& soup, std::size_t count, std::mt19937& random)
{
  for (; count > 0; --count) {
    const Polygon& p = soup.polygons[below(soup.polygons.size(), random)];
    const Point &a = soup.points[p[0]], &b = soup.points[p[1]];
    for (std::size_t i = 2; i < p.size(); ++i)
      for (int c = 0; c < 3; ++c)
        soup.points[p[i]][c] = a[c] + (b[c] - a[c]) * double(i - 1) / 4; // an exact quarter
  }
}

bool is_manifold(const Soup& soup)
{
  return CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.polygons);
}

Soup random_blocks(std::mt19937& random)
{
  while (true) {
    std::set<Voxel> voxels;
    Voxel corner = {0, 0, 0};
    for (int i = 0; i < 4; ++i) {
      const Voxel size = {1 + int(below(3, random)), 1 + int(below(3, random)),
                          1 + int(below(2, random))};
      for (const Voxel& v :
           voxel_block(corner, {corner[0] + size[0], corner[1] + size[1], corner[2] + size[2]}))
        voxels.insert(v);
      corner = *std::next(voxels.begin(), std::ptrdiff_t(below(voxels.size(), random)));
    }
    const Soup soup = voxel_surface({voxels.begin(), voxels.end()});
    if (is_manifold(soup) && soup.polygons.size() >= 40)
      return soup;
  }
}

std::string name(Family family)
{
  constexpr const char* names[] = {
    "sheet",  "quad sheet",     "polygon sheet",    "sphere",          "torus",
    "blocks", "two components", "degenerate sheet", "degenerate torus"};
  return names[int(family)];
}

bool has_degenerate_faces(Family family)
{
  return family == Family::DEGENERATE_SHEET || family == Family::DEGENERATE_TORUS;
}

std::ostream& operator<<(std::ostream& out, Family family)
{
  return out << name(family);
}

Soup random_mesh(Family family, unsigned seed)
{
  std::mt19937 random(seed);
  Soup soup;
  const std::size_t nx = 6 + below(6, random), ny = 5 + below(6, random);
  switch (family) {
  case Family::SHEET:
  case Family::DEGENERATE_SHEET:
    soup = triangulated(grid(nx, ny));
    bump(soup, 0.4, random);
    break;
  case Family::QUAD_SHEET:
    soup = grid(nx, ny);
    bump(soup, 0.3, random);
    break;
  case Family::POLYGON_SHEET:
    soup = polygon_sheet(nx / 2 + 1, ny / 2 + 1, random);
    bump(soup, 0.3, random);
    break;
  case Family::SPHERE:
    soup = sphere(2);
    bump(soup, 0.15, random);
    break;
  case Family::TORUS:
  case Family::DEGENERATE_TORUS:
    soup = torus(nx, ny);
    bump(soup, 0.15, random);
    break;
  case Family::BLOCKS:
    soup = random_blocks(random);
    bump(soup, 0.05, random);
    break;
  case Family::TWO_COMPONENTS: {
    soup = sphere(1 + below(2, random));
    soup = joined(soup, translated(triangulated(grid(nx, 5)), 4, 0, 0));
    bump(soup, 0.2, random);
    break;
  }
  }
  put_on_lattice(soup);
  if (has_degenerate_faces(family)) {
    collapse_some(soup, 1 + below(6, random), random);
    flatten_some(soup, 1 + below(6, random), random);
  }
  shuffle_faces(soup, random);
  return soup;
}

} // namespace test
