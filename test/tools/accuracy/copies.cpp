// SPDX-License-Identifier: GPL-3.0-or-later

#include "copies.h"

#include "random_numbers.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/bounding_box.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <utility>

namespace princeton_benchmark {

namespace {

using Engine = std::mt19937;

std::vector<std::size_t> numbers_up_to(std::size_t n)
{
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), std::size_t(0));
  return result;
}

/// A copy with the triangles of a mesh, in their order. `move`: from a point to a point.
template <typename Move>
Copy with_moved_points(Soup soup, const Move& move)
{
  for (Point& p : soup.points)
    p = move(p);
  std::vector<std::size_t> source = numbers_up_to(soup.triangles.size());
  return {std::move(soup), std::move(source), {}};
}

/// `deviate`: of each coordinate
template <typename Deviate>
Copy with_deviates(const Soup& soup, const Deviate& deviate)
{
  return with_moved_points(soup, [&](const Point& p) {
    const double x = p.x() + deviate(), y = p.y() + deviate();
    return Point(x, y, p.z() + deviate());
  });
}

double mean_edge_length(const Soup& soup)
{
  double sum = 0;
  for (const auto& corners : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sum += std::sqrt(
        squared_distance(soup.points[corners[i]], soup.points[corners[(i + 1) % 3]]));
  return sum / double(3 * soup.triangles.size());
}

/// Moves every coordinate evenly, with a standard deviation of `share` of the mean edge length.
Copy with_noise(const Soup& soup, double share, unsigned seed)
{
  Engine engine(seed);
  const double amount = share * mean_edge_length(soup) * std::sqrt(3.0);
  return with_deviates(
    soup, [&] { return amount * (2 * (double(engine()) / double(Engine::max())) - 1); });
}

Copy split_into_four(const Soup& soup)
{
  Copy copy{{soup.points, {}}, {}, {}};
  std::vector<Point>& points = copy.soup.points;
  std::map<std::array<std::size_t, 2>, std::size_t> middles;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto entry = middles.insert({{(std::min)(a, b), (std::max)(a, b)}, points.size()});
    if (entry.second)
      points.push_back(CGAL::midpoint(points[a], points[b]));
    return entry.first->second;
  };
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const auto& corners = soup.triangles[f];
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < 3; ++i)
      inner.push_back(middle(corners[i], corners[(i + 1) % 3]));
    for (std::size_t i = 0; i < 3; ++i)
      copy.soup.triangles.push_back({corners[i], inner[i], inner[(i + 2) % 3]});
    copy.soup.triangles.push_back(inner);
    copy.source.resize(copy.soup.triangles.size(), f);
  }
  return copy;
}

/// Up to `most` faces around one, those that share a point first.
std::vector<std::size_t> faces_around(const Soup& soup,
                                      const std::vector<std::vector<std::size_t>>& faces_at,
                                      std::size_t face, std::size_t most)
{
  std::vector<std::size_t> result = {face};
  for (std::size_t i = 0; i < result.size() && result.size() < most; ++i)
    for (const std::size_t corner : soup.triangles[result[i]])
      for (const std::size_t f : faces_at[corner])
        if (result.size() < most && std::find(result.begin(), result.end(), f) == result.end())
          result.push_back(f);
  return result;
}

/// Without about `share` of the faces, at least. Points are kept.
Copy with_holes(const Soup& soup, double share, unsigned seed)
{
  const std::size_t size = soup.triangles.size();
  std::vector<std::vector<std::size_t>> faces_at(soup.points.size());
  for (std::size_t f = 0; f < size; ++f)
    for (const std::size_t corner : soup.triangles[f])
      faces_at[corner].push_back(f);
  Engine engine(seed);
  std::vector<bool> is_kept(size, true);
  for (std::size_t missing = 0; double(missing) < share * double(size);)
    for (const std::size_t f : faces_around(soup, faces_at, engine() % size, 10)) {
      missing += is_kept[f];
      is_kept[f] = false;
    }
  return with_faces(soup, is_kept);
}

/// The faces whose centroids are nearest to those of the faces of another mesh.
std::vector<std::size_t> nearest_faces(const Soup& soup, const Soup& other)
{
  namespace bg = boost::geometry;
  using Place = bg::model::point<double, 3, bg::cs::cartesian>;
  using Item = std::pair<Place, std::size_t>;
  const auto place = [](const Soup& s, std::size_t f) {
    const Point p = centroid_of(s, f);
    return Place(p.x(), p.y(), p.z());
  };
  std::vector<Item> items;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    items.push_back({place(soup, f), f});
  const bg::index::rtree<Item, bg::index::quadratic<16>> tree(items);
  std::vector<std::size_t> result;
  for (std::size_t f = 0; f < other.triangles.size(); ++f)
    result.push_back(tree.qbegin(bg::index::nearest(place(other, f), 1))->second);
  return result;
}

/// About `share` of the edges. \pre the faces can be oriented as a manifold
Copy decimated(const Soup& soup, double share)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  namespace SMS = CGAL::Surface_mesh_simplification;
  Soup oriented = soup;
  PMP::orient_polygon_soup(oriented.points, oriented.triangles);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(oriented.points, oriented.triangles, mesh);
  SMS::edge_collapse(mesh, SMS::Count_ratio_stop_predicate<Mesh>(share));
  mesh.collect_garbage();
  Copy copy;
  PMP::polygon_mesh_to_polygon_soup(mesh, copy.soup.points, copy.soup.triangles);
  copy.source = nearest_faces(soup, copy.soup);
  return copy;
}

/// The sum of 12 evenly distributed numbers less 6, nearly normal, with a deviation of 1.
double deviate(Engine& random)
{
  double sum = -6;
  for (int i = 0; i < 12; ++i)
    sum += uniform(random);
  return sum;
}

template <typename Items>
void shuffle(Items& items, Engine& random)
{
  for (std::size_t i = items.size(); i > 1; --i)
    std::swap(items[i - 1], items[random() % i]);
}

Copy renumbered(const Soup& soup, unsigned seed)
{
  Engine random(seed);
  std::vector<std::size_t> vertex = numbers_up_to(soup.points.size());
  Copy copy{{std::vector<Point>(vertex.size()), {}}, numbers_up_to(soup.triangles.size()), {}};
  shuffle(vertex, random);
  shuffle(copy.source, random);
  for (std::size_t v = 0; v < vertex.size(); ++v)
    copy.soup.points[vertex[v]] = soup.points[v];
  for (const std::size_t f : copy.source) {
    std::vector<std::size_t> corners;
    for (const std::size_t v : soup.triangles[f])
      corners.push_back(vertex[v]);
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(random() % 3), corners.end());
    copy.soup.triangles.push_back(corners);
  }
  return copy;
}

double diagonal(const Soup& soup)
{
  const auto box = CGAL::bounding_box(soup.points.begin(), soup.points.end());
  return std::sqrt(squared_distance((box.min)(), (box.max)()));
}

/// The rotation is that of a random quaternion.
Copy moved(const Soup& soup, unsigned seed)
{
  Engine random(seed);
  std::array<double, 4> q;
  for (double& x : q)
    x = deviate(random);
  const double length = std::sqrt(std::inner_product(q.begin(), q.end(), q.begin(), 0.0));
  const double w = q[0] / length, x = q[1] / length, y = q[2] / length, z = q[3] / length;
  const double scale = std::exp(deviate(random)), size = diagonal(soup);
  const auto away = [&] { return size * deviate(random); };
  const double a = away(), b = away(), c = away();
  const CGAL::Aff_transformation_3<CGAL::Simple_cartesian<double>> motion(
    scale * (1 - 2 * (y * y + z * z)), scale * 2 * (x * y - w * z), scale * 2 * (x * z + w * y), a,
    scale * 2 * (x * y + w * z), scale * (1 - 2 * (x * x + z * z)), scale * 2 * (y * z - w * x), b,
    scale * 2 * (x * z - w * y), scale * 2 * (y * z + w * x), scale * (1 - 2 * (x * x + y * y)), c);
  return with_moved_points(soup, motion);
}

Copy in_five_digits(const Soup& soup)
{
  const auto rounded = [](double x) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.5g", x);
    return std::strtod(digits, nullptr);
  };
  return with_moved_points(
    soup, [&](const Point& p) { return Point(rounded(p.x()), rounded(p.y()), rounded(p.z())); });
}

/// `share`: of the diagonal of the bounding box
Copy with_normal_noise(const Soup& soup, double share, unsigned seed)
{
  Engine random(seed);
  const double noise = share * diagonal(soup);
  return with_deviates(soup, [&] { return noise * deviate(random); });
}

} // namespace

Point centroid_of(const Soup& soup, std::size_t face)
{
  return centroid(soup.points[soup.triangles[face][0]], soup.points[soup.triangles[face][1]],
                  soup.points[soup.triangles[face][2]]);
}

Copy with_faces(const Soup& soup, const std::vector<bool>& is_kept)
{
  Copy copy{{soup.points, {}}, {}, {}};
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (is_kept[f]) {
      copy.soup.triangles.push_back(soup.triangles[f]);
      copy.source.push_back(f);
    }
  return copy;
}

const std::vector<Copying>& variants()
{
  static const std::vector<Copying> all = {
    {"faces split into four", [](const Model& m, unsigned) { return split_into_four(m.soup); }},
    {"noise of 1/8 of the mean edge",
     [](const Model& m, unsigned seed) { return with_noise(m.soup, 1. / 8, seed); }},
    {"noise of 1/16 of the mean edge",
     [](const Model& m, unsigned seed) { return with_noise(m.soup, 1. / 16, seed); }},
    {"a tenth of the edges", [](const Model& m, unsigned) { return decimated(m.soup, 0.1); }},
    {"half of the edges", [](const Model& m, unsigned) { return decimated(m.soup, 0.5); }},
    {"holes of 1 % of the faces",
     [](const Model& m, unsigned seed) { return with_holes(m.soup, 0.01, seed); }}};
  return all;
}

const std::vector<Copying>& equal_copies()
{
  static const std::vector<Copying> all = {
    {"renumbered", [](const Model& m, unsigned seed) { return renumbered(m.soup, seed); }},
    {"motion", [](const Model& m, unsigned seed) { return moved(m.soup, seed); }},
    {"5 digits", [](const Model& m, unsigned) { return in_five_digits(m.soup); }},
    {"noise of 1e-7",
     [](const Model& m, unsigned seed) { return with_normal_noise(m.soup, 1e-7, seed); }},
    {"noise of 1e-5",
     [](const Model& m, unsigned seed) { return with_normal_noise(m.soup, 1e-5, seed); }}};
  return all;
}

Model copied(const Model& model, const Copying& copying, unsigned seed)
{
  Copy copy = copying.copy(model, seed);
  Model result{std::move(copy.soup), 0, {}};
  const std::size_t number = copy.person ? model.people[*copy.person].number_of_segments
                                         : model.number_of_segments;
  double parts = 0, parts_left = 0;
  for (const Person& person : model.people) {
    if (copy.person && &person != &model.people[*copy.person])
      continue;
    std::vector<int> labels;
    for (const std::size_t face : copy.source)
      labels.push_back(person.labels[face]);
    parts += double(number_of_large_parts(person.labels));
    parts_left += double(number_of_large_parts(labels));
    result.people.push_back({std::move(labels), person.number_of_segments});
  }
  result.number_of_segments = (std::max)(
    std::size_t(1), std::size_t(std::lround(double(number) * parts_left / (std::max)(parts, 1.0))));
  return result;
}

} // namespace princeton_benchmark
