// Region segmentation: the test oracle for `two-step`.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REFERENCE_TWO_STEP_H
#define CGAL_REGION_SEGMENTATION_TEST_REFERENCE_TWO_STEP_H

// A slow and obvious implementation of `two-step` ("The Methods Exactly", "The Two Steps"), to
// compare the package with. It knows polygon soups and the standard library only, and shares no
// code with the package.
//
// Source: Yang, Zhou, Wang, Liu, Luo, "A fast and efficient mesh segmentation method based on
// improved region growing", Appl. Math. J. Chinese Univ. 29(4):468-480, 2014, with the choices of
// the manual.
//
// Bits: two implementations break ties alike only if they do the same floating-point operations in
// the same order. Wherever an order or a form was chosen here, the comment begins with "Choice:".
// Compile both sides with the same setting of `-ffp-contract` on machines that have fused
// multiply-add.
//
// Complexity, with F faces, R regions after growing: O(F log F) up to growing; each merge of step
// one looks at all live regions, O(R^2) in total; each merge of step two looks at all pairs of live
// regions, of which there are 2k at most.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace reference {

// ---------------------------------------------------------------------------------------------------
// Input and output
// ---------------------------------------------------------------------------------------------------

using Point = std::array<double, 3>;
using Vector = std::array<double, 3>;
using Polygon = std::vector<std::size_t>; // vertex indices, counterclockwise seen from outside
using Edge = std::pair<std::size_t, std::size_t>; // the two vertex indices, the smaller one first

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

enum class Convexity { convex, concave, all };

struct Two_step_options
{
  std::size_t k = 1;                              // number of segments wanted
  double maximum_angle = 180. - 3.12 * 180. / pi; // bound of the deviation, in degrees
  Convexity convexity = Convexity::concave;       // which edges can be feature edges
  double beta = 0.1;                              // weight of length against angle, eq. (3)
  double gamma = 0.6;                             // weight of planarity against area, eq. (4)
  double factor = 2.;                             // step one ends at factor * k regions
  std::size_t minimum_length = none;              // dangling lines of that many edges are saved
  std::set<Edge> constrained_edges;               // always borders, never merged across
};

struct Merge
{
  std::size_t kept; // id of a region; always the lower one of the two
  std::size_t removed;
};

struct Two_step_result
{
  std::map<Edge, bool> is_feature_detected; // every edge; after item 2, before pruning
  std::map<Edge, bool> is_feature_pruned;   // every edge; after item 3
  std::map<Edge, bool> is_feature;          // every edge; after item 4
  std::vector<std::size_t> region_id;       // per face; after item 4
  std::size_t number_of_regions = 0;        // after item 4
  std::vector<Merge> merges;                // in order, step one and then step two
  std::vector<std::size_t> segment_id;      // per face; the labels
  std::size_t number_of_segments = 0;       // n, which need not be k
};

inline Edge make_edge(std::size_t u, std::size_t v)
{
  return Edge((std::min)(u, v), (std::max)(u, v));
}

// ---------------------------------------------------------------------------------------------------
// Vectors
// ---------------------------------------------------------------------------------------------------

inline Vector difference(const Point& p, const Point& q) // p - q
{
  return Vector{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

inline double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector cross(const Vector& a, const Vector& b)
{
  return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double squared_distance(const Point& p, const Point& q)
{
  const Vector d = difference(p, q);
  return dot(d, d);
}

// a / (a + b) for a, b >= 0, where 0/0 is 1/2.
inline double share(double a, double b)
{
  return (a + b == 0.) ? 0.5 : a / (a + b);
}

// e^-a / (e^-a + e^-b) for a, b in [0, infinity]: the larger of the two powers is divided out, so
// that nothing overflows. Two infinities are 0/0, which is 1/2.
inline double share_of_exponentials(double a, double b)
{
  if (a == b)
    return 0.5;
  if (a < b)
    return 1. / (1. + std::exp(a - b));
  const double power = std::exp(b - a);
  return power / (1. + power);
}

// A term of eq. (4) in units of 2^-36, rounded to an integer.
inline std::int64_t rounded_term(double term)
{
  return std::int64_t(std::nearbyint(68719476736. * term));
}

// ---------------------------------------------------------------------------------------------------
// The mesh
// ---------------------------------------------------------------------------------------------------

struct Edge_faces
{
  // Faces to the left of the halfedges first -> second and second -> first; `none` where there is
  // none.
  std::size_t left = none;
  std::size_t right = none;

  bool is_mesh_border() const { return left == none || right == none; }
  std::size_t lower_face() const { return (std::min)(left, right); }
  std::size_t higher_face() const { return (std::max)(left, right); }
  std::size_t opposite(std::size_t face) const { return face == left ? right : left; }
};

struct Face
{
  bool is_degenerate = false;
  double area = 0.;
  Vector normal = {0., 0., 0.};  // unit; unused where degenerate
  bool has_joining_edge = false; // degenerate faces only
  Edge joining_edge;
};

struct Mesh
{
  const std::vector<Point>& points;
  const std::vector<Polygon>& polygons;
  const Two_step_options& options;
  std::map<Edge, Edge_faces> edges;
  std::vector<Face> faces;

  bool is_constrained(const Edge& e) const { return options.constrained_edges.count(e) != 0; }

  // A constrained edge always is a border.
  bool is_border(const Edge& e) const { return edges.at(e).is_mesh_border() || is_constrained(e); }

  double length(const Edge& e) const
  {
    return std::sqrt(squared_distance(points[e.first], points[e.second]));
  }

  bool touches_degenerate_face(const Edge& e) const
  {
    const Edge_faces& sides = edges.at(e);
    return (sides.left != none && faces[sides.left].is_degenerate) ||
           (sides.right != none && faces[sides.right].is_degenerate);
  }

  // The joining edge of a degenerate face on either side.
  bool is_joining(const Edge& e) const
  {
    const Edge_faces& sides = edges.at(e);
    for (const std::size_t f : {sides.left, sides.right})
      if (f != none && faces[f].has_joining_edge && faces[f].joining_edge == e)
        return true;
    return false;
  }

  // An edge of a degenerate face that growing does not cross, although it is not a feature.
  bool is_closed(const Edge& e) const
  {
    return touches_degenerate_face(e) && !is_border(e) && !is_joining(e);
  }

  // N_i . N_j, for an edge that has two faces and touches no degenerate one.
  double cosine_of_deviation(const Edge& e) const
  {
    const Edge_faces& sides = edges.at(e);
    const double cosine = dot(faces[sides.left].normal, faces[sides.right].normal);
    return (std::max)(-1., (std::min)(1., cosine));
  }

  // theta of an edge of a section: pi where a degenerate face is involved.
  double dihedral_angle(const Edge& e) const
  {
    return touches_degenerate_face(e) ? pi : pi - std::acos(cosine_of_deviation(e));
  }
};

inline std::map<Edge, Edge_faces> collect_edges(const std::vector<Polygon>& polygons)
{
  std::map<Edge, Edge_faces> edges;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    const Polygon& polygon = polygons[f];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t source = polygon[i], target = polygon[(i + 1) % polygon.size()];
      Edge_faces& sides = edges[make_edge(source, target)];
      std::size_t& side = (source < target) ? sides.left : sides.right;
      if (side != none)
        throw std::invalid_argument("face " + std::to_string(f) + ": not an oriented 2-manifold");
      side = f;
    }
  }
  return edges;
}

// Item 1: Newell's formula relative to the vertex of lowest index, starting there.
// Choice: the sum of cross products of successive corners, halved at the end, so that its length is
// the area. The two products with the corner of lowest index itself are 0 and left out.
inline Vector area_vector(const std::vector<Point>& points, const Polygon& polygon)
{
  const std::size_t n = polygon.size();
  const std::size_t start = std::min_element(polygon.begin(), polygon.end()) - polygon.begin();
  const Point& origin = points[polygon[start]];

  Vector sum = {0., 0., 0.};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vector a = difference(points[polygon[(start + i) % n]], origin);
    const Vector b = difference(points[polygon[(start + i + 1) % n]], origin);
    const Vector product = cross(a, b);
    for (int c = 0; c < 3; ++c)
      sum[c] += product[c];
  }
  return Vector{sum[0] / 2., sum[1] / 2., sum[2] / 2.};
}

inline Face measure_face(const std::vector<Point>& points, const Polygon& polygon)
{
  double squared_longest_edge = 0.;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    squared_longest_edge = (std::max)(
      squared_longest_edge,
      squared_distance(points[polygon[i]], points[polygon[(i + 1) % polygon.size()]]));

  const Vector area = area_vector(points, polygon);
  const double length = std::sqrt(dot(area, area));

  Face face;
  // Choice: a length that is not finite is an overflow too, and such a face has area 0; other
  // degenerate faces keep the tiny area they have.
  const bool overflows = !std::isfinite(length);
  face.is_degenerate = overflows || length <= 1e-12 * squared_longest_edge;
  face.area = overflows ? 0. : length;
  if (!face.is_degenerate)
    face.normal = Vector{area[0] / length, area[1] / length, area[2] / length};
  return face;
}

// Item 2: the longest interior edge of a degenerate face; ties: the lower face across.
// Choice: a constrained edge is a border and so is not interior; nor is an edge that has the face
// itself on both sides. Choice: squared lengths are compared.
inline void find_joining_edge(Mesh& mesh, std::size_t f)
{
  Face& face = mesh.faces[f];
  const Polygon& polygon = mesh.polygons[f];
  double longest = 0.;
  std::size_t across = none;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Edge e = make_edge(polygon[i], polygon[(i + 1) % polygon.size()]);
    if (mesh.is_border(e) || mesh.edges.at(e).opposite(f) == f)
      continue;
    const double squared_length = squared_distance(mesh.points[e.first], mesh.points[e.second]);
    const std::size_t candidate = mesh.edges.at(e).opposite(f);
    if (!face.has_joining_edge || squared_length > longest ||
        (squared_length == longest && candidate < across)) {
      face.has_joining_edge = true;
      face.joining_edge = e;
      longest = squared_length;
      across = candidate;
    }
  }
}

inline Mesh read_mesh(const std::vector<Point>& points, const std::vector<Polygon>& polygons,
                      const Two_step_options& options)
{
  Mesh mesh{points, polygons, options, collect_edges(polygons), {}};
  for (const Polygon& polygon : polygons)
    mesh.faces.push_back(measure_face(points, polygon));
  for (std::size_t f = 0; f < polygons.size(); ++f)
    if (mesh.faces[f].is_degenerate)
      find_joining_edge(mesh, f);
  return mesh;
}

// ---------------------------------------------------------------------------------------------------
// Item 2: feature edges
// ---------------------------------------------------------------------------------------------------

inline bool has_wanted_sign(const Mesh& mesh, const Edge& e)
{
  if (mesh.options.convexity == Convexity::all)
    return true;
  const Edge_faces& sides = mesh.edges.at(e);
  const Vector d = difference(mesh.points[e.second], mesh.points[e.first]); // the face of d is
                                                                            // `left`
  const double sign = dot(cross(mesh.faces[sides.left].normal, mesh.faces[sides.right].normal), d);
  return mesh.options.convexity == Convexity::convex ? sign > 0. : sign < 0.;
}

inline bool is_feature_edge(const Mesh& mesh, const Edge& e)
{
  if (mesh.is_border(e))
    return true;
  if (mesh.touches_degenerate_face(e))
    return false;
  return mesh.cosine_of_deviation(e) < std::cos(mesh.options.maximum_angle * pi / 180.) &&
         has_wanted_sign(mesh, e);
}

inline std::map<Edge, bool> detect_feature_edges(const Mesh& mesh)
{
  std::map<Edge, bool> is_feature;
  for (const auto& entry : mesh.edges)
    is_feature[entry.first] = is_feature_edge(mesh, entry.first);
  return is_feature;
}

// ---------------------------------------------------------------------------------------------------
// Item 3: feature lines
// ---------------------------------------------------------------------------------------------------

struct Line
{
  std::set<Edge> edges;
  bool has_free_end = false;
};

// For each vertex, the edges there that growing cannot cross.
// Choice: the closed edges of degenerate faces are among them. They are not features, but like
// borders they make an end not free and a passing line two lines; else pruning could open a region.
inline std::map<std::size_t, std::set<Edge>>
collect_barriers(const Mesh& mesh, const std::map<Edge, bool>& is_feature)
{
  std::map<std::size_t, std::set<Edge>> barriers;
  for (const auto& entry : is_feature)
    if (entry.second || mesh.is_closed(entry.first)) {
      barriers[entry.first.first].insert(entry.first);
      barriers[entry.first.second].insert(entry.first);
    }
  return barriers;
}

// Follows the line of `edge` beyond its vertex `v`.
inline void follow_line(std::map<std::size_t, std::set<Edge>>& barriers,
                        const std::map<Edge, bool>& is_feature, Edge edge, std::size_t v,
                        Line& line)
{
  while (barriers[v].size() == 2) {
    const Edge next = (*barriers[v].begin() == edge) ? *barriers[v].rbegin() : *barriers[v].begin();
    if (!is_feature.at(next) || line.edges.count(next) != 0)
      return;
    line.edges.insert(next);
    v = (next.first == v) ? next.second : next.first;
    edge = next;
  }
  if (barriers[v].size() == 1)
    line.has_free_end = true;
}

inline std::vector<Line> extract_feature_lines(const Mesh& mesh,
                                               const std::map<Edge, bool>& is_feature)
{
  std::map<std::size_t, std::set<Edge>> barriers = collect_barriers(mesh, is_feature);
  std::vector<Line> lines;
  std::set<Edge> visited;
  for (const auto& entry : is_feature) {
    if (!entry.second || visited.count(entry.first) != 0)
      continue;
    Line line;
    line.edges.insert(entry.first);
    follow_line(barriers, is_feature, entry.first, entry.first.first, line);
    follow_line(barriers, is_feature, entry.first, entry.first.second, line);
    visited.insert(line.edges.begin(), line.edges.end());
    lines.push_back(line);
  }
  return lines;
}

// Choice: all lines that are to go in one round go together, before lines are extracted anew; this
// matters to `minimum_length` only. Choice: constrained edges stay, as they always are borders.
inline std::map<Edge, bool> prune_feature_lines(const Mesh& mesh, std::map<Edge, bool> is_feature)
{
  bool changed = true;
  while (changed) {
    changed = false;
    for (const Line& line : extract_feature_lines(mesh, is_feature)) {
      if (!line.has_free_end || line.edges.size() >= mesh.options.minimum_length)
        continue;
      for (const Edge& e : line.edges)
        if (!mesh.is_border(e)) {
          is_feature[e] = false;
          changed = true;
        }
    }
  }
  return is_feature;
}

// ---------------------------------------------------------------------------------------------------
// Item 4: growing
// ---------------------------------------------------------------------------------------------------

inline std::vector<std::size_t> grow_regions(const Mesh& mesh,
                                             const std::map<Edge, bool>& is_feature,
                                             std::size_t& number_of_regions)
{
  std::vector<std::vector<std::size_t>> neighbors(mesh.faces.size());
  for (const auto& entry : mesh.edges)
    if (!is_feature.at(entry.first) && !mesh.is_closed(entry.first)) {
      neighbors[entry.second.left].push_back(entry.second.right);
      neighbors[entry.second.right].push_back(entry.second.left);
    }

  std::vector<std::size_t> region_id(mesh.faces.size(), none);
  number_of_regions = 0;
  for (std::size_t seed = 0; seed < mesh.faces.size(); ++seed) {
    if (region_id[seed] != none)
      continue;
    region_id[seed] = number_of_regions;
    std::vector<std::size_t> stack(1, seed);
    while (!stack.empty()) {
      const std::size_t f = stack.back();
      stack.pop_back();
      for (const std::size_t g : neighbors[f])
        if (region_id[g] == none) {
          region_id[g] = number_of_regions;
          stack.push_back(g);
        }
    }
    ++number_of_regions;
  }
  return region_id;
}

inline std::map<Edge, bool> clear_inner_features(const Mesh& mesh, std::map<Edge, bool> is_feature,
                                                 const std::vector<std::size_t>& region_id)
{
  for (auto& entry : is_feature) {
    const Edge_faces& sides = mesh.edges.at(entry.first);
    if (!mesh.is_border(entry.first) && region_id[sides.left] == region_id[sides.right])
      entry.second = false;
  }
  return is_feature;
}

// ---------------------------------------------------------------------------------------------------
// Items 5 to 7: regions, sections, merging
// ---------------------------------------------------------------------------------------------------

struct Section
{
  double length = 0.;
  double sum_of_angles = 0.;
  std::size_t number_of_edges = 0;
  bool is_constrained = false; // Choice: one constrained edge forbids the merge, and changes
                               // nothing else

  double mean_angle() const { return sum_of_angles / double(number_of_edges); }
};

struct Region
{
  double area = 0.;
  double perimeter = 0.;
  std::map<std::size_t, Section> sections; // by neighbor; both sides hold equal copies

  double planarity() const
  {
    return area == 0. ? infinity : perimeter * perimeter / (4. * pi * area);
  }

  bool can_merge() const
  {
    for (const auto& entry : sections)
      if (!entry.second.is_constrained)
        return true;
    return false;
  }
};

using Regions = std::map<std::size_t, Region>; // the live ones, by id

// The edges between different regions by higher face, then by lower face.
// Choice: several edges between the same two faces come in the order of their vertex pairs.
inline std::vector<Edge> collect_section_edges(const Mesh& mesh,
                                               const std::vector<std::size_t>& region_id)
{
  std::vector<std::tuple<std::size_t, std::size_t, Edge>> keys;
  for (const auto& entry : mesh.edges) {
    const Edge_faces& sides = entry.second;
    if (!sides.is_mesh_border() && region_id[sides.left] != region_id[sides.right])
      keys.emplace_back(sides.higher_face(), sides.lower_face(), entry.first);
  }
  std::sort(keys.begin(), keys.end());

  std::vector<Edge> edges;
  for (const auto& key : keys)
    edges.push_back(std::get<2>(key));
  return edges;
}

inline void add_edge(Section& section, const Mesh& mesh, const Edge& e)
{
  section.length += mesh.length(e);
  section.sum_of_angles += mesh.dihedral_angle(e);
  section.number_of_edges += 1;
  section.is_constrained = section.is_constrained || mesh.is_constrained(e);
}

// Choice: a perimeter runs over its edges in the same order as sections do (not section by
// section).
inline Regions build_regions(const Mesh& mesh, const std::vector<std::size_t>& region_id)
{
  Regions regions;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    regions[region_id[f]].area += mesh.faces[f].area;

  for (const Edge& e : collect_section_edges(mesh, region_id)) {
    const std::size_t a = region_id[mesh.edges.at(e).left], b = region_id[mesh.edges.at(e).right];
    add_edge(regions[a].sections[b], mesh, e);
    add_edge(regions[b].sections[a], mesh, e);
    regions[a].perimeter += mesh.length(e);
    regions[b].perimeter += mesh.length(e);
  }
  return regions;
}

// Eq. (3): the section of the region with the largest sum over its other sections; ties: lower
// neighbor. Choice: constrained sections count in the sums, but are not taken; the section itself
// counts with 1/2, so that equal sections have the same terms in the same order.
inline std::size_t choose_neighbor(const Region& region, double beta)
{
  std::size_t best = none;
  double best_sum = 0.;
  for (const auto& candidate : region.sections) {
    const Section& section_i = candidate.second;
    if (section_i.is_constrained)
      continue;
    double sum = 0.;
    for (const auto& other : region.sections) {
      const Section& section_j = other.second;
      sum += beta * share(section_i.length, section_j.length) +
             (1. - beta) * share(section_i.mean_angle(), section_j.mean_angle());
    }
    if (best == none || sum > best_sum) {
      best = candidate.first;
      best_sum = sum;
    }
  }
  return best;
}

// Step one: the region of smallest area that has a section to merge across; ties: lower id.
inline std::size_t choose_smallest_region(const Regions& regions)
{
  std::size_t best = none;
  for (const auto& candidate : regions)
    if ((best == none || candidate.second.area < regions.at(best).area) &&
        candidate.second.can_merge())
      best = candidate.first;
  return best;
}

// Step two, eq. (4): the region that has a section to merge across, with the largest sum over all
// other live regions, which is the smallest one of what is subtracted; ties: lower id.
inline std::size_t choose_region_by_planarity(const Regions& regions, double gamma)
{
  std::size_t best = none;
  std::int64_t best_sum = 0;
  for (const auto& candidate : regions) {
    if (!candidate.second.can_merge())
      continue;
    std::int64_t sum = 0;
    for (const auto& other : regions)
      if (other.first != candidate.first)
        sum += rounded_term(
          gamma * share_of_exponentials(candidate.second.planarity(), other.second.planarity()) +
          (1. - gamma) * share(candidate.second.area, other.second.area));
    if (best == none || sum < best_sum) {
      best = candidate.first;
      best_sum = sum;
    }
  }
  return best;
}

inline Merge merge_regions(Regions& regions, std::size_t a, std::size_t b)
{
  const Merge merge = {(std::min)(a, b), (std::max)(a, b)};
  Region& kept = regions.at(merge.kept);
  const Region removed = regions.at(merge.removed);
  const Section between = kept.sections.at(merge.removed);
  regions.erase(merge.removed);
  kept.sections.erase(merge.removed);

  kept.area += removed.area;
  kept.perimeter = (kept.perimeter + removed.perimeter) - 2. * between.length;
  for (const auto& entry : removed.sections) {
    if (entry.first == merge.kept)
      continue;
    Section& section = kept.sections[entry.first]; // empty where the neighbor is not a common one
    section.length += entry.second.length;
    section.sum_of_angles += entry.second.sum_of_angles;
    section.number_of_edges += entry.second.number_of_edges;
    section.is_constrained = section.is_constrained || entry.second.is_constrained;

    Region& neighbor = regions.at(entry.first);
    neighbor.sections.erase(merge.removed);
    neighbor.sections[merge.kept] = section;
  }
  return merge;
}

inline void merge_step_one(Regions& regions, const Two_step_options& options,
                           std::vector<Merge>& merges)
{
  while (double(regions.size()) > options.factor * double(options.k)) {
    const std::size_t id = choose_smallest_region(regions);
    if (id == none)
      return;
    const std::size_t neighbor = choose_neighbor(regions.at(id), options.beta);
    merges.push_back(merge_regions(regions, id, neighbor));
  }
}

inline void merge_step_two(Regions& regions, const Two_step_options& options,
                           std::vector<Merge>& merges)
{
  while (regions.size() > options.k) {
    const std::size_t id = choose_region_by_planarity(regions, options.gamma);
    if (id == none)
      return;
    const std::size_t neighbor = choose_neighbor(regions.at(id), options.beta);
    merges.push_back(merge_regions(regions, id, neighbor));
  }
}

// ---------------------------------------------------------------------------------------------------
// Item 8: the result
// ---------------------------------------------------------------------------------------------------

inline std::vector<std::size_t> number_segments(const std::vector<std::size_t>& region_id,
                                                std::size_t number_of_regions,
                                                const std::vector<Merge>& merges,
                                                std::size_t& number_of_segments)
{
  // The live region that each region has become part of: a merge hands on all that `removed` stood
  // for, so going through the merges backwards finds `kept` already resolved.
  std::vector<std::size_t> representative(number_of_regions);
  for (std::size_t r = 0; r < number_of_regions; ++r)
    representative[r] = r;
  for (auto merge = merges.rbegin(); merge != merges.rend(); ++merge)
    representative[merge->removed] = representative[merge->kept];

  std::map<std::size_t, std::size_t> label_of_region;
  std::vector<std::size_t> segment_id;
  for (const std::size_t r : region_id)
    segment_id.push_back(
      label_of_region.emplace(representative[r], label_of_region.size()).first->second);
  number_of_segments = label_of_region.size();
  return segment_id;
}

// The whole method, of a soup whose closed components are not inside out. Throws
// `std::invalid_argument` if the soup is not an oriented 2-manifold (no halfedge twice).
inline Two_step_result two_step(const std::vector<Point>& points,
                                const std::vector<Polygon>& polygons,
                                const Two_step_options& options)
{
  const Mesh mesh = read_mesh(points, polygons, options);

  Two_step_result result;
  result.is_feature_detected = detect_feature_edges(mesh);
  result.is_feature_pruned = prune_feature_lines(mesh, result.is_feature_detected);
  result.region_id = grow_regions(mesh, result.is_feature_pruned, result.number_of_regions);
  result.is_feature = clear_inner_features(mesh, result.is_feature_pruned, result.region_id);

  Regions regions = build_regions(mesh, result.region_id);
  merge_step_one(regions, options, result.merges);
  merge_step_two(regions, options, result.merges);

  result.segment_id = number_segments(result.region_id, result.number_of_regions, result.merges,
                                      result.number_of_segments);
  return result;
}

} // namespace reference

#endif // CGAL_REGION_SEGMENTATION_TEST_REFERENCE_TWO_STEP_H
