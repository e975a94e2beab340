// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REFERENCE_VISIBILITY_H
#define CGAL_REGION_SEGMENTATION_TEST_REFERENCE_VISIBILITY_H

#include "reference_orientation.h"
#include "reference_straightening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

/// `Visibility_merging` as the manual defines it, step by step and slowly. Shares no code with the
/// library, and uses the obvious data structures: maps, and a search of all candidates for each
/// choice.
namespace reference {
namespace visibility {

using Vector = std::array<double, 3>;
using Pair = std::pair<std::size_t, std::size_t>; // lower, higher

inline Vector operator+(const Vector& a, const Vector& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(double s, const Vector& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vector& a)
{
  return std::sqrt(dot(a, a));
}
inline Vector unit(const Vector& a)
{
  return norm(a) > 0 ? (1 / norm(a)) * a : Vector{};
}
inline double angle(const Vector& a, const Vector& b)
{
  return std::acos(std::max(-1.0, std::min(1.0, dot(a, b))));
}
inline bool face_each_other(const Vector& n_i, const Vector& n_j, const Vector& c_i,
                            const Vector& c_j)
{
  return dot(n_j - n_i, c_j - c_i) < 0;
}

inline Pair ordered(std::size_t a, std::size_t b)
{
  return {std::min(a, b), std::max(a, b)};
}

/// The labels renumbered by their first element.
inline std::vector<std::size_t> numbered(const std::vector<std::size_t>& labels)
{
  std::map<std::size_t, std::size_t> number;
  std::vector<std::size_t> result;
  for (std::size_t label : labels)
    result.push_back(number.emplace(label, number.size()).first->second);
  return result;
}

inline std::size_t number_of(const std::vector<std::size_t>& labels)
{
  return labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
}

struct Edge
{
  std::size_t lower, higher;       // faces
  double length, signed_deviation; // positive: concave
};

struct Mesh
{
  std::vector<Vector> points;
  std::vector<std::vector<std::size_t>> faces; // from the vertex of lowest index on
  std::vector<double> areas;
  std::vector<Vector> normals, centroids;
  std::vector<Edge> edges; // by lower, then by higher face
  double area = 0;

  Mesh(std::vector<Vector> points_, std::vector<std::vector<std::size_t>> faces_)
    : points(std::move(points_))
    , faces(std::move(faces_))
  {
    turn_outward(points, faces);
    std::map<Pair, std::size_t> face_of_halfedge;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      auto& face = faces[f];
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      add_face(face);
      for (std::size_t i = 0; i < face.size(); ++i)
        face_of_halfedge[{face[i], face[(i + 1) % face.size()]}] = f;
    }
    for (const auto& [halfedge, f] : face_of_halfedge) {
      const auto other = face_of_halfedge.find({halfedge.second, halfedge.first});
      if (other != face_of_halfedge.end() && f < other->second)
        add_edge(f, other->second, points[halfedge.second] - points[halfedge.first]);
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.lower, a.higher) < std::tie(b.lower, b.higher);
    });
  }

  double unit_of_length() const { return std::sqrt(area); }

  /// Whether all components are convex; these are not divided where no number is given.
  bool is_convex() const
  {
    Vector sum{};
    for (std::size_t f = 0; f < faces.size(); ++f)
      sum = sum + areas[f] * normals[f];
    double concave = 0, all = 0;
    for (const Edge& e : edges) {
      concave += e.length * std::max(0.0, e.signed_deviation);
      all += e.length * std::abs(e.signed_deviation);
    }
    return area > 0 && norm(sum) <= area / 1e6 && concave <= all / 1000;
  }

  /// The same faces at other points; the edges keep their lengths.
  Mesh moved(const std::vector<Vector>& other_points) const
  {
    Mesh result(other_points, faces);
    for (std::size_t e = 0; e < edges.size(); ++e)
      result.edges[e].length = edges[e].length;
    return result;
  }

private:
  void add_face(const std::vector<std::size_t>& face)
  {
    Vector twice{}, sum{};
    double longest = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vector &p = points[face[i]], &q = points[face[(i + 1) % face.size()]];
      twice = twice + cross(p - points[face[0]], q - points[face[0]]);
      longest = std::max(longest, dot(q - p, q - p));
      sum = sum + p;
    }
    const double a = norm(0.5 * twice);
    const bool is_degenerate = !(a > 1e-12 * longest && a >= std::numeric_limits<double>::min());
    areas.push_back(a);
    normals.push_back(is_degenerate ? Vector{} : (1 / a) * (0.5 * twice));
    centroids.push_back((1 / double(face.size())) * sum);
    area += a;
  }

  void add_edge(std::size_t f, std::size_t g, const Vector& along)
  {
    const double sign = dot(cross(normals[f], normals[g]), along);
    const double deviation = sign == 0 ? 0 : angle(normals[f], normals[g]);
    edges.push_back({f, g, norm(along), sign < 0 ? deviation : -deviation});
  }
};

/// The mesh as the methods on superfacets see it: if noise exceeds curvature, points move along the
/// normals to the height of their neighbors, unless that is more than 3 times the median; again
/// until little noise is left.
inline Mesh without_noise(const Mesh& mesh, double share = 0.42, int rounds = 5)
{
  const std::size_t n = mesh.points.size();
  std::vector<Vector> normals(n), to_neighbors(n);
  std::vector<double> number(n), heights(n);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t v = face[i];
      normals[v] = normals[v] + mesh.areas[f] * mesh.normals[f];
      for (std::size_t j : {i + 1, i + face.size() - 1}) {
        to_neighbors[v] = to_neighbors[v] + (mesh.points[face[j % face.size()]] - mesh.points[v]);
        number[v] += 1;
      }
    }
  }
  std::vector<Vector> points = mesh.points;
  for (std::size_t v = 0; v < n; ++v) {
    const double height = number[v] > 0 ? dot(unit(normals[v]), to_neighbors[v]) / number[v] : 0;
    if (height * height > 1e-5 * norm(normals[v]))
      heights[v] = height;
  }
  std::vector<double> sizes;
  for (double height : heights)
    if (height != 0)
      sizes.push_back(std::fabs(height));
  std::sort(sizes.begin(), sizes.end());
  for (std::size_t v = 0; v < n; ++v)
    if (heights[v] != 0 && std::fabs(heights[v]) <= 3 * sizes[sizes.size() / 2])
      points[v] = points[v] + heights[v] * unit(normals[v]);
  double all = 0, opposite = 0; // sides of faces
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const double a = heights[face[i]], b = heights[face[(i + 1) % face.size()]];
      all += a != 0 && b != 0;
      opposite += (a < 0 && b > 0) || (a > 0 && b < 0);
    }
  const bool is_noisy = opposite > share * all + std::sqrt(all);
  return is_noisy && rounds > 0 ? without_noise(mesh.moved(points), 0.2, rounds - 1) : mesh;
}

/// Small flat patches of faces, or of other patches.
struct Patches
{
  std::vector<std::size_t> of_element,
    center; // the patch of each face; the face at the center of each patch
  std::vector<double> areas;
  std::vector<Vector> area_vectors, normals, centroids;
  std::map<Pair, double> lengths; // of borders

  double concave_deviation(std::size_t i, std::size_t j) const
  {
    const Vector &m = normals[i], &n = normals[j];
    const bool is_concave = norm(m) > 0 && norm(n) > 0 &&
                            face_each_other(m, n, centroids[i], centroids[j]);
    return is_concave ? angle(m, n) : 0;
  }

  explicit Patches(const Mesh& mesh)
    : areas(mesh.areas)
    , normals(mesh.normals)
    , centroids(mesh.centroids)
  {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      area_vectors.push_back(areas[f] * normals[f]);
    for (const Edge& e : mesh.edges)
      lengths[{e.lower, e.higher}] += e.length;
    join_in_rounds(mesh, mesh.area / 60000);
  }

  /// The patches joined further: their elements are the patches.
  Patches coarse(const Mesh& mesh) const
  {
    Patches result = *this;
    result.join_in_rounds(mesh, mesh.area / 4000);
    return result;
  }

private:
  void join_in_rounds(const Mesh& mesh, double maximum_area)
  {
    const std::vector<Vector> element_normals = normals, element_centroids = centroids;
    of_element.clear();
    for (std::size_t i = 0; i < areas.size(); ++i)
      of_element.push_back(i);
    while (true) {
      const std::size_t n = areas.size();
      join(joined(mesh, maximum_area));
      if (n == areas.size() || n - areas.size() < n / 32)
        break;
    }
    set_centers(element_normals, element_centroids);
  }

  /// What each patch is joined to, in a round.
  std::vector<std::size_t> joined(const Mesh& mesh, double maximum_area) const
  {
    const std::size_t n = areas.size();
    std::vector<std::pair<float, std::size_t>> selected(
      n, {std::numeric_limits<float>::infinity(), 0});
    for (std::size_t i = 0; i < n; ++i)
      selected[i].second = i;
    for (const auto& entry : lengths) {
      const auto [i, j] = entry.first;
      if (!(areas[i] + areas[j] <= maximum_area))
        continue;
      const double distance = norm(centroids[i] - centroids[j]) / mesh.unit_of_length();
      const float step = float(distance + 0.4 * norm(normals[i] - normals[j]));
      selected[i] = std::min(selected[i], {step, j});
      selected[j] = std::min(selected[j], {step, i});
    }
    std::vector<std::size_t> parent(n), number_of_children(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = selected[i].second;
      const bool is_larger = areas[i] != areas[j] ? areas[i] > areas[j] : i < j;
      parent[i] = selected[j].second == i && is_larger ? i : j;
    }
    for (std::size_t i = 0; i < n; ++i)
      number_of_children[parent[i]] += parent[i] != i;
    std::vector<std::size_t> result(n);
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t depth = 0;
      for (std::size_t j = i; parent[j] != j; j = parent[j])
        ++depth;
      result[i] = depth % 2 == 1                            ? parent[i]
                  : depth > 0 && number_of_children[i] == 0 ? parent[parent[i]]
                                                            : i;
    }
    return numbered(result);
  }

  void join(const std::vector<std::size_t>& parts)
  {
    const std::size_t n = number_of(parts);
    std::vector<double> a(n, 0);
    std::vector<Vector> area_vector(n), normal(n), centroid(n);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      a[parts[i]] += areas[i];
      area_vector[parts[i]] = area_vector[parts[i]] + area_vectors[i];
      centroid[parts[i]] = centroid[parts[i]] + areas[i] * centroids[i];
    }
    for (std::size_t i = parts.size(); i-- > 0;) {
      const std::size_t p = parts[i];
      if (a[p] == 0)
        centroid[p] = centroids[i];
    }
    for (std::size_t p = 0; p < n; ++p) {
      normal[p] = unit(area_vector[p]);
      if (a[p] > 0)
        centroid[p] = (1 / a[p]) * centroid[p];
    }
    std::map<Pair, double> united;
    for (const auto& [pair, length] : lengths) {
      const auto [p, q] = ordered(parts[pair.first], parts[pair.second]);
      if (p != q)
        united[{p, q}] += length;
    }
    areas = a, area_vectors = area_vector, normals = normal, centroids = centroid, lengths = united;
    for (std::size_t& p : of_element)
      p = parts[p];
  }

  void set_centers(const std::vector<Vector>& element_normals,
                   const std::vector<Vector>& element_centroids)
  {
    using Key = std::tuple<bool, double, std::size_t>; // degenerate, distance, element
    std::vector<Key> best(areas.size(),
                          {true, std::numeric_limits<double>::infinity(), of_element.size()});
    for (std::size_t i = 0; i < of_element.size(); ++i) {
      const bool is_degenerate = element_normals[i] == Vector{};
      const Vector away = element_centroids[i] - centroids[of_element[i]];
      best[of_element[i]] = std::min(best[of_element[i]],
                                     Key{is_degenerate, is_degenerate ? 0 : dot(away, away), i});
    }
    center.clear();
    for (const Key& key : best)
      center.push_back(std::get<2>(key));
  }
};

using Neighbors = std::map<std::size_t, std::map<std::size_t, float>>;

/// Seeds on patches, and the one to which each patch belongs.
class Seeding
{
public:
  Seeding(const Mesh& mesh, const Patches& patches)
    : m_patches(patches)
    , m_distance(patches.areas.size(), unreached)
    , m_seed_of(patches.areas.size())
  {
    for (const auto& [pair, length] : patches.lengths) {
      const auto [i, j] = pair;
      const double distance = norm(patches.centroids[i] - patches.centroids[j]) /
                              mesh.unit_of_length();
      const double step = distance + 0.4 * std::min(patches.concave_deviation(i, j), 0.6);
      m_steps[i][j] = m_steps[j][i] = float(std::min(std::max(step, 1e-37), 1e28));
    }
  }

  /// One seed after the other, each at the farthest patch.
  void place_farthest(std::size_t number)
  {
    const std::size_t n = m_patches.areas.size();
    Vector center{};
    double area = 0;
    for (std::size_t p = 0; p < n; ++p) {
      center = center + m_patches.areas[p] * m_patches.centroids[p];
      area += m_patches.areas[p];
    }
    center = (1 / area) * center;
    while (std::count(m_distance.begin(), m_distance.end(), unreached) > 0) {
      std::size_t next = n;
      for (std::size_t p = 0; p < n; ++p)
        if (m_distance[p] == unreached && (next == n || norm(m_patches.centroids[p] - center) >
                                                          norm(m_patches.centroids[next] - center)))
          next = p;
      m_seeds.push_back(next);
      relax({next});
    }
    number_of_components = m_seeds.size();
    while (m_seeds.size() < number) {
      const std::size_t next = std::size_t(std::max_element(m_distance.begin(), m_distance.end()) -
                                           m_distance.begin());
      if (!(m_distance[next] > 0))
        break;
      m_seeds.push_back(next);
      relax({next});
    }
  }

  /// Given seeds, all at once, beside those before. A patch that does not become nearer keeps its
  /// seed.
  void place_all(const std::vector<std::size_t>& seeds)
  {
    const std::vector<double> before = m_distance;
    relax(seeds);
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < m_distance.size(); ++p)
      order.push_back(p);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t p, std::size_t q) { return m_distance[p] < m_distance[q]; });
    for (const std::size_t p : order) {
      if (m_distance[p] == before[p])
        continue;
      std::pair<float, std::size_t> through{std::numeric_limits<float>::infinity(), 0};
      for (const auto& [q, step] : m_steps[p])
        if (m_distance[q] + double(step) == m_distance[p])
          through = std::min(through, {float(m_distance[q]), q});
      m_seed_of[p] = m_distance[p] == 0 ? p : m_seed_of[through.second];
    }
  }

  std::size_t number_of_components = 0;

  const std::vector<std::size_t>& seeds() const { return m_seeds; }
  std::vector<std::size_t> regions() const { return numbered(m_seed_of); }

private:
  static constexpr double unreached = std::numeric_limits<double>::infinity();

  void relax(const std::vector<std::size_t>& seeds)
  {
    std::set<std::pair<double, std::size_t>> front;
    for (const std::size_t seed : seeds) {
      m_distance[seed] = 0;
      front.insert({0, seed});
    }
    while (!front.empty()) {
      const auto [d, p] = *front.begin();
      front.erase(front.begin());
      for (const auto& [q, step] : m_steps[p])
        if (d + double(step) < m_distance[q]) {
          front.erase({m_distance[q], q});
          m_distance[q] = d + double(step);
          front.insert({m_distance[q], q});
        }
    }
  }

  const Patches& m_patches;
  Neighbors m_steps;
  std::vector<double> m_distance;
  std::vector<std::size_t> m_seeds, m_seed_of;
};

/// The draws of `Superfacets`, that of most regions first: the regions of the faces.
inline std::vector<std::vector<std::size_t>> draws(const Mesh& mesh, const Patches& patches,
                                                   const Patches& coarse)
{
  std::vector<std::size_t> numbers{480};
  while (numbers.size() < 5)
    numbers.push_back(numbers.back() * 15 / 16);
  const bool is_on_coarse = coarse.areas.size() / 4 >= numbers.front();
  Seeding places(mesh, is_on_coarse ? coarse : patches), seeding(mesh, patches);
  places.place_farthest(numbers.front());
  std::vector<std::vector<std::size_t>> result;
  std::size_t begin = 0;
  for (std::size_t i = numbers.size(); i-- > 0;) {
    const std::size_t end = std::min(std::max(numbers[i], places.number_of_components),
                                     places.seeds().size());
    if (end == begin)
      continue;
    std::vector<std::size_t> seeds;
    for (; begin < end; ++begin)
      seeds.push_back(is_on_coarse ? coarse.center[places.seeds()[begin]] : places.seeds()[begin]);
    seeding.place_all(seeds);
    std::vector<std::size_t> labels;
    for (const std::size_t p : patches.of_element)
      labels.push_back(seeding.regions()[p]);
    result.insert(result.begin(), numbered(labels));
  }
  return result;
}

struct Section
{
  double length = 0, concave = 0, convex = 0, bend = 0, visibility = 0;
  std::size_t number_of_edges = 0;

  void add(const Section& other)
  {
    length += other.length, concave += other.concave, convex += other.convex;
    bend += other.bend, visibility += other.visibility, number_of_edges += other.number_of_edges;
  }
};

struct Region
{
  double area = 0, log_thickness = 0, visibility = 0;

  double thickness() const { return area > 0 ? log_thickness / area : 0; }
  void add(const Region& other, const Section&)
  {
    area += other.area, log_thickness += other.log_thickness, visibility += other.visibility;
  }
};

/// The region graph: merges change it.
template <typename RegionData, typename SectionData>
struct Basic_graph
{
  std::map<std::size_t, RegionData> regions;
  std::map<Pair, SectionData> sections;
};
using Graph = Basic_graph<Region, Section>;

/// The shapes of regions of faces.
struct Shapes
{
  struct Shape
  {
    double area = 0;
    Vector normal{}, centroid{};
  };

  std::vector<Shape> regions;
  Vector center{}; // of the surface

  Shapes(const Mesh& mesh, const std::vector<std::size_t>& region_of)
    : regions(number_of(region_of))
  {
    for (std::size_t f = 0; f < region_of.size(); ++f) {
      Shape& shape = regions[region_of[f]];
      shape.area += mesh.areas[f];
      shape.normal = shape.normal + mesh.areas[f] * mesh.normals[f];
      shape.centroid = shape.centroid + mesh.areas[f] * mesh.centroids[f];
    }
    for (Shape& shape : regions) {
      center = center + (1 / mesh.area) * shape.centroid;
      shape.normal = unit(shape.normal);
      shape.centroid = shape.area > 0 ? (1 / shape.area) * shape.centroid : mesh.centroids[0];
    }
  }
};

struct Ray
{
  std::size_t source, end; // faces
  double distance, weight;
};

/// The rays of regions of faces that hit a face.
class Rays
{
public:
  Rays(const Mesh& mesh, const Patches& patches, const std::vector<std::size_t>& region_of)
    : m_mesh(mesh)
    , m_patches(patches)
    , m_region_of(region_of)
    , m_shapes(mesh, region_of)
  {
    for (std::size_t r = 0; r < m_shapes.regions.size(); ++r)
      cast(r);
  }

  std::vector<Ray> all;

private:
  std::vector<std::pair<double, std::size_t>> candidates(std::size_t region) const
  {
    std::vector<std::pair<double, std::size_t>> result;
    for (const std::size_t f : m_patches.center)
      if (m_region_of[f] == region) {
        const Vector away = m_mesh.centroids[f] - m_shapes.regions[region].centroid;
        result.push_back({dot(away, away), f});
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  void cast(std::size_t region)
  {
    const auto from = candidates(region);
    const std::size_t n = from.size(), m = std::min<std::size_t>(n, 3);
    const double share = m_shapes.regions[region].area / m_mesh.area;
    if (share < 1. / 25600)
      return;
    const bool is_small = share < 1. / 6400;
    for (std::size_t k = 0; k < (is_small ? 1 : m); ++k) {
      const std::size_t face = from[9 * k * n / (10 * m)].second, q = 12 / m;
      if (m_mesh.normals[face] == Vector{})
        continue;
      for (std::size_t i = 0; i < (is_small ? 1 : q); ++i) {
        const double a = 0.9 * std::sqrt(double(i) / double(q - 1)),
                     b = 2.399963229728653 * double(i) + double(k);
        const auto [end, distance] = first_hit(face, direction(face, a, b));
        if (end == m_mesh.faces.size())
          continue;
        all.push_back({face, end, distance, share / (is_small ? 1 : 12)});
      }
    }
  }

  Vector direction(std::size_t face, double a, double b) const
  {
    const Vector normal = m_mesh.normals[face], center = m_mesh.centroids[face];
    const auto in_plane = [&](const Vector& v) { return v - dot(v, normal) * normal; };
    Vector u = in_plane(center - m_shapes.center);
    if (!(norm(u) > 1e-3 * norm(center - m_shapes.center)))
      u = in_plane(m_mesh.points[m_mesh.faces[face][0]] - center);
    u = unit(u);
    const Vector v = cross(-1.0 * normal, u);
    return -std::cos(a) * normal + std::sin(a) * (std::cos(b) * u + std::sin(b) * v);
  }

  /// The number of faces if there is none.
  std::pair<std::size_t, double> first_hit(std::size_t from, const Vector& direction) const
  {
    std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(),
                                        m_mesh.faces.size()};
    for (std::size_t f = 0; f < m_mesh.faces.size(); ++f)
      for (std::size_t i = 1; f != from && i + 1 < m_mesh.faces[f].size(); ++i)
        if (const double d = distance_to(f, i, m_mesh.centroids[from], direction); d < best.first)
          best = {d, f};
    return {best.second, best.first};
  }

  /// To triangle i of the fan of a face; infinite if the ray misses it.
  double distance_to(std::size_t face, std::size_t i, const Vector& source, const Vector& d) const
  {
    const auto corner = [&](std::size_t j) { return m_mesh.points[m_mesh.faces[face][j]]; };
    const Vector e = corner(i) - corner(0), g = corner(i + 1) - corner(0),
                 to_source = source - corner(0), p = cross(d, g), q = cross(to_source, e);
    const double inverse = 1 / dot(e, p), u = dot(to_source, p) * inverse, v = dot(d, q) * inverse,
                 distance = dot(g, q) * inverse;
    const bool is_hit = u >= -1e-6 && v >= -1e-6 && u + v <= 1 + 1e-6 && distance > 0;
    return is_hit ? distance : std::numeric_limits<double>::infinity();
  }

  const Mesh& m_mesh;
  const Patches& m_patches;
  const std::vector<std::size_t>& m_region_of;
  const Shapes m_shapes;
};

/// The annotated graph of regions of faces, by the rays of these or of other regions.
class Annotation
{
public:
  Annotation(const Mesh& mesh, const std::vector<std::size_t>& region_of,
             const std::vector<Ray>& rays)
    : m_mesh(mesh)
    , m_region_of(region_of)
    , m_shapes(mesh, region_of)
  {
    for (std::size_t r = 0; r < m_shapes.regions.size(); ++r)
      graph.regions[r].area = m_shapes.regions[r].area / mesh.area;
    set_sections();
    set_rays(rays);
  }

  Graph graph;

private:
  void set_sections()
  {
    for (const Edge& e : m_mesh.edges) {
      const auto [r, s] = ordered(m_region_of[e.lower], m_region_of[e.higher]);
      if (r == s)
        continue;
      Section& section = graph.sections[{r, s}];
      const double l = e.length / m_mesh.unit_of_length();
      section.length += l;
      ++section.number_of_edges;
      section.concave += e.signed_deviation > 0 ? l * std::min(e.signed_deviation, 0.6) : 0;
      section.convex += e.signed_deviation < 0 ? l * std::min(-e.signed_deviation, 2.0) : 0;
    }
    for (auto& [pair, section] : graph.sections) {
      const Shapes::Shape &i = m_shapes.regions[pair.first], &j = m_shapes.regions[pair.second];
      const double bend = std::atan2(norm(cross(i.normal, j.normal)), dot(i.normal, j.normal));
      section.bend = section.length *
                     (face_each_other(i.normal, j.normal, i.centroid, j.centroid) ? bend : -bend);
    }
  }

  void set_rays(const std::vector<Ray>& rays)
  {
    const std::size_t n = graph.regions.size();
    std::vector<double> sum(n, 0), hits(n, 0);
    for (const Ray& ray : rays) {
      const std::size_t r = m_region_of[ray.source], s = m_region_of[ray.end];
      sum[r] += std::log(ray.distance / m_mesh.unit_of_length() + 1e-4);
      hits[r] += 1;
      graph.regions[r].visibility += ray.weight;
      graph.regions[s].visibility += ray.weight;
      if (r != s)
        graph.sections[ordered(r, s)].visibility += ray.weight;
    }
    double mean = 0, regions = 0;
    for (std::size_t r = 0; r < n; ++r)
      if (hits[r] > 0) {
        mean += sum[r] / hits[r];
        ++regions;
      }
    mean = regions > 0 ? mean / regions : 0;
    for (std::size_t r = 0; r < n; ++r)
      graph.regions[r].log_thickness = graph.regions[r].area *
                                       (hits[r] > 0 ? sum[r] / hits[r] : mean);
  }

  const Mesh& m_mesh;
  const std::vector<std::size_t>& m_region_of;
  const Shapes m_shapes;
};

inline double cost(const Region& a, const Region& b, const Section& s, bool are_many)
{
  const double p_d = are_many ? 3.14 : 4, d_0 = are_many ? 0.055 : 0.022,
               p_a = are_many ? 1.2 : 1.74;
  const double p_l = are_many ? 0.87 : 0.95, p_s = are_many ? 0.49 : 0.195;
  const double eta = 0.16, p_t = 1, t_0 = 0.18, s_0 = 0.01, w_x = 0.3, w_b = 0.08;
  const auto at_least = [](double x) { return std::max(x, 1e-12); };
  const double length = at_least(s.length), m = at_least(std::min(a.area, b.area)),
               l = at_least(std::max(a.area, b.area));
  const double d = std::max(0.0, (s.concave - w_x * s.convex + w_b * s.bend) / length) + d_0;
  const double seen = std::min(a.visibility, b.visibility);
  return p_d * std::log(d) + p_a * ((1 - eta) * std::log(m) + eta * std::log(2 * m * l / (m + l))) -
         p_l * std::log(length * length / m) +
         p_t * std::log(t_0 + std::abs(a.thickness() - b.thickness())) -
         p_s * std::log(s_0 + (seen > 0 ? s.visibility / seen : 0));
}

struct Merge
{
  std::size_t kept, removed;
  double cost;
};

template <typename RegionData, typename SectionData>
void merge(Basic_graph<RegionData, SectionData>& graph, std::size_t kept, std::size_t removed)
{
  graph.regions[kept].add(graph.regions[removed], graph.sections[{kept, removed}]);
  graph.regions.erase(removed);
  std::map<Pair, SectionData> sections;
  for (const auto& [pair, section] : graph.sections) {
    const auto rename = [&, gone = removed](std::size_t r) { return r == gone ? kept : r; };
    const Pair renamed = ordered(rename(pair.first), rename(pair.second));
    if (renamed.first != renamed.second)
      sections[renamed].add(section);
  }
  graph.sections = std::move(sections);
}

/// Merges across the section of lowest `order(a, b, section)` until `few` regions are left, or none
/// is adjacent to another; the section costs `cost(a, b, section)`.
template <typename Graph, typename Order, typename Cost>
void merge_down_to(std::size_t few, Graph& graph, const Order& order, const Cost& cost,
                   std::vector<Merge>& merges)
{
  while (graph.regions.size() > few) {
    Merge best{0, 0, std::numeric_limits<double>::infinity()};
    for (const auto& [pair, section] : graph.sections)
      if (section.number_of_edges > 0)
        if (const double c = order(graph.regions[pair.first], graph.regions[pair.second], section);
            c < best.cost)
          best = {pair.first, pair.second, c};
    if (best.removed == 0)
      return;
    best.cost = cost(graph.regions[best.kept], graph.regions[best.removed],
                     graph.sections[{best.kept, best.removed}]);
    merge(graph, best.kept, best.removed);
    merges.push_back(best);
  }
}

/// The merges by `Visibility_cost`.
template <typename Graph>
void merge_by_visibility(std::size_t few, Graph& graph, std::vector<Merge>& merges)
{
  for (bool are_many : {true, false}) {
    const auto order = [=](const Region& a, const Region& b, const Section& s) {
      return cost(a, b, s, are_many);
    };
    merge_down_to(are_many ? std::max<std::size_t>(150, few) : few, graph, order, order, merges);
  }
}

/// The labels of the faces after the merges down to a number of segments.
inline std::vector<std::size_t> labels_after(const std::vector<std::size_t>& region_of,
                                             const std::vector<Merge>& merges,
                                             std::size_t number_of_segments)
{
  const std::size_t regions = number_of(region_of);
  std::vector<std::size_t> segment_of(regions);
  for (std::size_t r = 0; r < regions; ++r)
    segment_of[r] = r;
  for (std::size_t i = 0; i < merges.size() && regions - i > number_of_segments; ++i)
    for (std::size_t& s : segment_of)
      s = s == merges[i].removed ? merges[i].kept : s;
  std::vector<std::size_t> result;
  for (std::size_t r : region_of)
    result.push_back(segment_of[r]);
  return numbered(result);
}

/// The first regions of a draw, and their annotated graph.
struct Draw
{
  std::vector<std::size_t> region_of;
  Graph graph;
};

/// The draws of a mesh, with the rays of the first one.
struct Annotated
{
  Patches patches, coarse;
  std::vector<Draw> draws;

  explicit Annotated(const Mesh& mesh)
    : patches(mesh)
    , coarse(patches.coarse(mesh))
  {
    const auto regions = visibility::draws(mesh, patches, coarse);
    const Rays rays(mesh, patches, regions.front());
    for (const std::vector<std::size_t>& region_of : regions)
      draws.push_back({region_of, Annotation(mesh, region_of, rays.all).graph});
  }
};

/// All merges of a draw.
struct Run
{
  std::vector<Merge> merges;
  std::size_t chosen_number; // as regions are before borders move
};

/// The draw whose chosen segmentation differs least from those of all others, by the pairs of
/// coarse patches that are in one segment in one of the two.
inline std::size_t central_draw(const Mesh& mesh, const Annotated& annotated,
                                const std::vector<Run>& runs)
{
  const Patches& coarse = annotated.coarse;
  const std::size_t n = coarse.areas.size();
  std::vector<std::vector<std::size_t>> labels(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto of_faces = labels_after(annotated.draws[i].region_of, runs[i].merges,
                                       runs[i].chosen_number);
    for (std::size_t c = 0; c < n; ++c)
      labels[i].push_back(of_faces[annotated.patches.center[coarse.center[c]]]);
  }
  std::vector<std::int64_t> areas, sums(runs.size());
  for (const double area : coarse.areas)
    areas.push_back(std::int64_t(area / mesh.area * (1 << 26)));
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t p = 0; p < n; ++p)
        for (std::size_t q = 0; q < n; ++q)
          if ((labels[i][p] == labels[i][q]) != (labels[j][p] == labels[j][q])) {
            sums[i] += areas[p] * areas[q];
            sums[j] += areas[p] * areas[q];
          }
  return std::size_t(std::min_element(sums.begin(), sums.end()) - sums.begin());
}

/// The regions of the faces, and their merges, after borders are straightened.
struct Straightened
{
  std::vector<std::size_t> region_of;
  std::vector<Merge> merges;

  Straightened(const Mesh& mesh, const Patches& patches,
               const std::vector<std::size_t>& region_of_face,
               const std::vector<Merge>& merges_before)
  {
    const std::size_t n = patches.areas.size();
    Straightening_input input;
    input.costs.resize(n);
    input.lengths.resize(n);
    for (const auto& [pair, length] : patches.lengths) {
      const auto [i, j] = pair;
      const Vector &c_i = patches.centroids[i], &c_j = patches.centroids[j];
      const double concavity = std::min(patches.concave_deviation(i, j), 0.6);
      input.costs[i][j] = input.costs[j][i] = float(length / mesh.unit_of_length() /
                                                    (1 + 10 * concavity));
      input.lengths[i][j] = input.lengths[j][i] = norm(c_i - c_j) / mesh.unit_of_length();
    }
    for (double area : patches.areas)
      input.areas.push_back(area / mesh.area);
    input.region_of.resize(n);
    for (std::size_t f = 0; f < patches.of_element.size(); ++f)
      input.region_of[patches.of_element[f]] = region_of_face[f];
    for (const Merge& merge : merges_before)
      input.merges.push_back({merge.kept, merge.removed});
    const Straightening straightening(input);

    std::vector<std::size_t> labels;
    for (std::size_t p : patches.of_element)
      labels.push_back(straightening.labels()[p]);
    region_of = numbered(labels);
    std::map<std::size_t, std::size_t> lowest; // the lowest new region of each segment; none if it
                                               // has no faces
    for (std::size_t f = 0; f < labels.size(); ++f)
      lowest[labels[f]] = region_of[f];
    for (const Merge& merge : merges_before) {
      const auto kept = lowest.find(merge.kept), removed = lowest.find(merge.removed);
      if (removed == lowest.end())
        continue;
      if (kept == lowest.end()) {
        lowest[merge.kept] = removed->second;
        continue;
      }
      const auto [low, high] = ordered(kept->second, removed->second);
      merges.push_back({low, high, merge.cost});
      kept->second = low;
    }
  }
};

/// The regions of the faces and their merges: of the draw that is nearest to all others.
struct Result
{
  std::vector<std::size_t> region_of;
  std::vector<Merge> merges;
  std::size_t chosen_number;

  /// `run`: of a draw
  template <typename Run_of>
  Result(const Mesh& mesh, const Annotated& annotated, const Run_of& run)
  {
    std::vector<Run> runs;
    for (const Draw& draw : annotated.draws)
      runs.push_back(run(draw));
    const std::size_t i = central_draw(mesh, annotated, runs);
    const Straightened straightened(mesh, annotated.patches, annotated.draws[i].region_of,
                                    runs[i].merges);
    region_of = straightened.region_of;
    merges = straightened.merges;
    chosen_number = runs[i].chosen_number;
  }
};

/// As `Visibility_merging`.
struct Visibility_result : Result
{
  Visibility_result(const Mesh& mesh, const Annotated& annotated)
    : Result(mesh, annotated, [&](const Draw& draw) {
      Graph graph = draw.graph;
      Run run;
      merge_by_visibility(1, graph, run.merges);
      run.chosen_number = mesh.is_convex() ? graph.regions.size()
                                           : choose_number(number_of(draw.region_of), run.merges);
      return run;
    })
  {}

private:
  static std::size_t choose_number(std::size_t regions, const std::vector<Merge>& merges)
  {
    const std::size_t least = regions - merges.size();
    const std::size_t first = regions - std::min(regions, std::max<std::size_t>(40, least));
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i < merges.size(); ++i)
      highest = std::max(highest, merges[i].cost);
    std::size_t i = first;
    while (i < merges.size() && !(merges[i].cost > (-19.5 + highest) / 2))
      ++i;
    return std::max(regions - i, std::min<std::size_t>(regions, 2));
  }
};

} // namespace visibility
} // namespace reference

#endif // CGAL_REGION_SEGMENTATION_TEST_REFERENCE_VISIBILITY_H
