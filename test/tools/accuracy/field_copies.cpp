// SPDX-License-Identifier: GPL-3.0-or-later

#include "field_copies.h"

#include "random_numbers.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace princeton_benchmark {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Vector = Kernel::Vector_3;
using CGAL::Region_segmentation::internal::Lowest_root_forest;
using Index = Lowest_root_forest::Index;

Point corner(const Soup& soup, std::size_t face, std::size_t i)
{
  return soup.points[soup.triangles[face][i]];
}

Point mean(const std::vector<Point>& points)
{
  Vector sum = CGAL::NULL_VECTOR;
  for (const Point& p : points)
    sum += p - CGAL::ORIGIN;
  return CGAL::ORIGIN + sum / double(points.size());
}

using Edge = std::array<std::size_t, 2>;

/// The two faces of each edge; of more than two faces, one with each other.
std::vector<std::pair<std::size_t, std::size_t>> adjacent_faces(const Soup& soup)
{
  std::map<Edge, std::size_t> first;
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(soup.triangles[f][i], soup.triangles[f][(i + 1) % 3]);
      const auto [place, is_new] = first.insert({{a, b}, f});
      if (!is_new)
        result.push_back({place->second, f});
    }
  return result;
}

/// Whether a camera far away in a direction sees the centroid of each face.
std::vector<bool> seen_faces(const Soup& soup, const Vector& to_camera)
{
  using Primitive = CGAL::AABB_triangle_primitive<Kernel,
                                                  std::vector<Kernel::Triangle_3>::const_iterator>;
  std::vector<Kernel::Triangle_3> triangles;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    triangles.push_back({corner(soup, f, 0), corner(soup, f, 1), corner(soup, f, 2)});
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.begin(),
                                                                   triangles.end());
  const CGAL::Bbox_3 box = tree.bbox();
  const double size = std::hypot(box.x_span(), box.y_span(), box.z_span());
  constexpr double edge_on = 0.05, depth_resolution = 0.005;
  std::vector<bool> result;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Vector normal = cross_product(triangles[f][1] - triangles[f][0],
                                        triangles[f][2] - triangles[f][0]);
    const Point start = centroid_of(soup, f) + depth_resolution * size * to_camera;
    result.push_back(normal * to_camera > edge_on * std::sqrt(normal.squared_length()) &&
                     !tree.do_intersect(Kernel::Ray_3(start, to_camera)));
  }
  return result;
}

/// Divides a share of the parts: a number of the piece of each face.
std::vector<std::size_t> divided(const Soup& soup, const std::vector<int>& labels,
                                 double share_of_divided, std::mt19937& random)
{
  std::map<int, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < labels.size(); ++f)
    faces[labels[f]].push_back(f);
  std::vector<std::size_t> piece(labels.size());
  std::size_t first = 0;
  for (const auto& [label, part] : faces) {
    std::vector<Point> centers(uniform(random) < share_of_divided ? 2 + random() % 3 : 1);
    for (Point& center : centers)
      center = centroid_of(soup, part[random() % part.size()]);
    for (const std::size_t f : part) {
      const Point p = centroid_of(soup, f);
      const auto nearest = std::min_element(
        centers.begin(), centers.end(), [&](const Point& a, const Point& b) {
          return squared_distance(a, p) < squared_distance(b, p);
        });
      piece[f] = first + std::size_t(nearest - centers.begin());
    }
    first += centers.size();
  }
  return piece;
}

/// Joins a share of the pairs of adjacent pieces.
void join(std::vector<std::size_t>& piece, const Soup& soup, double share_of_joined,
          std::mt19937& random)
{
  std::set<std::pair<std::size_t, std::size_t>> adjacent; // each pair once
  Lowest_root_forest joined(1 + *std::max_element(piece.begin(), piece.end()));
  for (const auto& [f, g] : adjacent_faces(soup))
    if (piece[f] != piece[g] && adjacent.insert(std::minmax(piece[f], piece[g])).second &&
        uniform(random) < share_of_joined)
      joined.unite(Index(piece[f]), Index(piece[g]));
  for (std::size_t& p : piece)
    p = joined.root(Index(p));
}

/// Some faces of a soup, as a soup of its own.
Copy piece_of(const Soup& soup, const std::vector<std::size_t>& faces)
{
  Copy piece{{}, faces, {}};
  std::map<std::size_t, std::size_t> number; // by vertex of the soup
  for (const std::size_t f : faces) {
    piece.soup.triangles.emplace_back();
    for (const std::size_t v : soup.triangles[f]) {
      const auto [place, is_new] = number.insert({v, piece.soup.points.size()});
      if (is_new)
        piece.soup.points.push_back(soup.points[v]);
      piece.soup.triangles.back().push_back(place->second);
    }
  }
  return piece;
}

/// Closes each loop of the border by a fan around the mean of its vertices.
void close_by_fans(Copy& piece)
{
  std::map<Edge, std::size_t> open; // by edge: where the triangle on its left comes from
  for (std::size_t f = 0; f < piece.source.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = piece.soup.triangles[f][i], b = piece.soup.triangles[f][(i + 1) % 3];
      if (open.erase({b, a}) == 0)
        open[{a, b}] = piece.source[f];
    }
  Lowest_root_forest loops(piece.soup.points.size());
  for (const auto& [edge, source] : open)
    loops.unite(Index(edge[0]), Index(edge[1]));
  std::map<Index, std::vector<Point>> starts; // of the edges of each loop
  for (const auto& [edge, source] : open)
    starts[loops.root(Index(edge[0]))].push_back(piece.soup.points[edge[0]]);
  std::map<Index, std::size_t> apex;
  for (const auto& [loop, points] : starts) {
    apex[loop] = piece.soup.points.size();
    piece.soup.points.push_back(mean(points));
  }
  for (const auto& [edge, source] : open) {
    piece.soup.triangles.push_back({edge[1], edge[0], apex[loops.root(Index(edge[0]))]});
    piece.source.push_back(source);
  }
}

/// Adds a piece, scaled about the mean of its vertices.
void add_scaled(Copy& copy, const Copy& piece, double scale)
{
  const std::size_t first = copy.soup.points.size();
  const Point center = mean(piece.soup.points);
  for (const Point& p : piece.soup.points)
    copy.soup.points.push_back(center + scale * (p - center));
  for (const auto& t : piece.soup.triangles)
    copy.soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  copy.source.insert(copy.source.end(), piece.source.begin(), piece.source.end());
}

} // namespace

Copy seen_from_one_side(const Soup& soup, unsigned seed)
{
  constexpr double least_share = 0.02;
  std::mt19937 random(seed);
  std::vector<bool> is_seen = seen_faces(soup, direction(random));
  Lowest_root_forest pieces(soup.triangles.size());
  for (const auto& [f, g] : adjacent_faces(soup))
    if (is_seen[f] && is_seen[g])
      pieces.unite(Index(f), Index(g));
  std::vector<std::size_t> size(soup.triangles.size());
  for (std::size_t f = 0; f < size.size(); ++f)
    ++size[pieces.root(Index(f))];
  const auto seen = std::count(is_seen.begin(), is_seen.end(), true);
  for (std::size_t f = 0; f < size.size(); ++f)
    is_seen[f] = is_seen[f] && double(size[pieces.root(Index(f))]) > least_share * double(seen);
  return with_faces(soup, is_seen);
}

Copy cut_in_half(const Soup& soup, unsigned seed)
{
  std::mt19937 random(seed);
  const Point center = mean(soup.points);
  const Vector normal = direction(random);
  std::vector<bool> is_kept;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    is_kept.push_back((centroid_of(soup, f) - center) * normal > 0);
  return with_faces(soup, is_kept);
}

Copy in_closed_pieces(const Model& model, unsigned seed)
{
  const double share_of_divided = seed % 2 == 0 ? 0.25 : 0.75;
  constexpr double share_of_joined = 0.125, scale = 1.01;
  std::mt19937 random(seed);
  const std::size_t person = random() % model.people.size();
  std::vector<std::size_t> piece = divided(model.soup, model.people[person].labels,
                                           share_of_divided, random);
  join(piece, model.soup, share_of_joined, random);
  std::map<std::size_t, std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < piece.size(); ++f)
    faces[piece[f]].push_back(f);
  Copy copy;
  copy.person = person;
  for (const auto& [p, faces_of_piece] : faces) {
    Copy closed = piece_of(model.soup, faces_of_piece);
    close_by_fans(closed);
    add_scaled(copy, closed, scale);
  }
  return copy;
}

const std::vector<Copying>& field_copies()
{
  static const std::vector<Copying> all = {
    {"seen from one side",
     [](const Model& m, unsigned seed) { return seen_from_one_side(m.soup, seed); }},
    {"cut in half", [](const Model& m, unsigned seed) { return cut_in_half(m.soup, seed); }},
    {"closed pieces", in_closed_pieces}};
  return all;
}

} // namespace princeton_benchmark
