// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REFERENCE_LEARNED_H
#define CGAL_REGION_SEGMENTATION_TEST_REFERENCE_LEARNED_H

#include "reference_visibility.h"

#include <CGAL/Region_segmentation/Superfacets/internal/learned_merge_model.h>

#include <cstdint>

/// `Learned_merging` as the manual defines it. Of the library it uses the constants of the model
/// alone.
namespace reference {
namespace visibility {
namespace learned {

using Matrix = std::array<std::array<double, 3>, 3>;

inline Matrix square(const Vector& v) // v v^T
{
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] = v[i] * v[j];
  return m;
}

inline Matrix sum(const Matrix& a, double s, const Matrix& b)
{
  Matrix m = a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] += s * b[i][j];
  return m;
}

inline double trace(const Matrix& m)
{
  return m[0][0] + m[1][1] + m[2][2];
}

inline double trace_of_product(const Matrix& a, const Matrix& b)
{
  double result = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result += a[i][j] * b[j][i];
  return result;
}

/// By Viete's formula, the largest first.
inline Vector eigenvalues(const Matrix& m)
{
  const double mean = trace(m) / 3, third = std::acos(-1.0) * 2 / 3;
  const Matrix d = sum(m, -mean, Matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  const double radius = std::sqrt(std::max(0.0, trace_of_product(d, d)) / 6);
  if (!(radius > 0))
    return {mean, mean, mean};
  const double determinant = dot(Vector{d[0]}, cross(Vector{d[1]}, Vector{d[2]}));
  const double phi = std::acos(std::max(
                       -1.0, std::min(1.0, determinant / (2 * radius * radius * radius)))) /
                     3;
  const double first = mean + 2 * radius * std::cos(phi),
               last = mean + 2 * radius * std::cos(phi + third);
  return {first, 3 * mean - first - last, last};
}

struct Moments
{
  double weight = 0;
  Vector first{};
  Matrix second{};

  void add(double w, const Vector& point, const Matrix& square_of_point)
  {
    weight += w;
    first = first + w * point;
    second = sum(second, w, square_of_point);
  }
  void add(const Moments& other)
  {
    weight += other.weight;
    first = first + other.first;
    second = sum(second, 1, other.second);
  }
  Vector centroid() const { return weight > 0 ? (1 / weight) * first : Vector{}; }
  Matrix covariance() const
  {
    return weight > 0 ? sum(sum({}, 1 / weight, second), -1, square(centroid())) : Matrix{};
  }
};

struct Learned_section : Section
{
  double strongly_concave = 0, log_thickness = 0;

  void add(const Learned_section& other)
  {
    Section::add(other);
    strongly_concave += other.strongly_concave;
    log_thickness += other.log_thickness;
  }
};

struct Learned_region : Region
{
  double squared_log_thickness = 0, own_visibility = 0, perimeter = 0;
  Vector area_vector{};
  Moments moments;
  std::array<double, 5> whole{}; // features of the whole surface

  void add(const Learned_region& other, const Learned_section& between)
  {
    Region::add(other, between);
    squared_log_thickness += other.squared_log_thickness;
    own_visibility += other.own_visibility + between.visibility;
    perimeter += other.perimeter - 2 * between.length;
    area_vector = area_vector + other.area_vector;
    moments.add(other.moments);
  }
};

using Learned_graph = Basic_graph<Learned_region, Learned_section>;

/// In the order of `Merge_features`. The angles of all pairs.
inline std::array<double, 5> features_of_whole(const Learned_graph& graph)
{
  const double pi = std::acos(-1.0);
  const auto quotient = [](double a, double b) { return b > 0 ? a / b : 0; };
  Moments moments;
  double area = 0, sum = 0, out = 0, most_out = 0, sines = 0, weights = 0;
  for (const auto& [r, region] : graph.regions) {
    moments.add(region.moments);
    area += region.area;
    sum += norm(region.area_vector);
  }
  for (const auto& [r, a] : graph.regions) {
    const Vector c = a.moments.centroid() - moments.centroid();
    out += dot(a.area_vector, c);
    most_out += norm(a.area_vector) * norm(c);
    for (const auto& [s, b] : graph.regions) {
      const double weight = norm(a.area_vector) * norm(b.area_vector);
      const double cosine = quotient(dot(a.area_vector, b.area_vector), weight);
      sines += weight * 4 * cosine * cosine * (1 - cosine * cosine);
      weights += weight;
    }
  }
  double concave = 0, length = 0;
  for (const auto& [pair, section] : graph.sections) {
    concave += section.strongly_concave;
    length += section.length;
  }
  return {-std::log(std::max(1e-12, pi * trace(moments.covariance()))), quotient(sum, area),
          quotient(concave, length), 1 - quotient(sines, weights), quotient(out, most_out)};
}

inline Learned_graph annotate(const Mesh& mesh, const Graph& graph,
                              const std::vector<std::size_t>& region_of)
{
  Learned_graph result;
  for (const auto& [r, region] : graph.regions) {
    Learned_region& learned = result.regions[r];
    static_cast<Region&>(learned) = region;
    learned.squared_log_thickness = region.area * region.thickness() * region.thickness();
    learned.own_visibility = region.visibility / 2;
  }
  const double unit = mesh.unit_of_length();
  const auto relative = [&](const Vector& p) { return (1 / unit) * (p - mesh.centroids[0]); };
  for (std::size_t f = 0; f < region_of.size(); ++f) {
    Learned_region& region = result.regions[region_of[f]];
    const double a = mesh.areas[f] / mesh.area, sigma = 1 / (6 * std::sqrt(3.0));
    const Vector n = mesh.normals[f], c = relative(mesh.centroids[f]);
    const Matrix spread = sum(Matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, -1, square(n));
    region.area_vector = region.area_vector + a * n;
    region.moments.add(a, c, sum(square(c), sigma * a, spread));
  }
  for (const auto& [pair, section] : graph.sections) {
    Learned_section& learned = result.sections[pair];
    static_cast<Section&>(learned) = section;
    Learned_region &i = result.regions[pair.first], &j = result.regions[pair.second];
    learned.log_thickness = section.length * (i.thickness() + j.thickness()) / 2;
    for (Learned_region* region : {&i, &j}) {
      region->own_visibility -= section.visibility / 2;
      region->perimeter += section.length;
    }
  }
  for (const Edge& e : mesh.edges) {
    const Pair pair = ordered(region_of[e.lower], region_of[e.higher]);
    if (pair.first == pair.second)
      continue;
    result.sections[pair].strongly_concave += e.signed_deviation > 0.4 ? e.length / unit : 0;
  }
  const std::array<double, 5> whole = features_of_whole(result);
  for (auto& [r, region] : result.regions)
    region.whole = whole;
  return result;
}

constexpr double tiny = 1e-12;
inline double ln(double x)
{
  return std::log(std::max(x, tiny));
}
inline double quotient(double a, double b)
{
  return b > tiny ? a / b : 0;
}

/// sqrt(a / b) of two eigenvalues of which `e` is the largest.
inline double root(double a, double b, double e)
{
  const double o = 1e-6 * e + tiny;
  return std::sqrt((std::max(a, 0.0) + o) / (std::max(b, 0.0) + o));
}

using Features = std::array<std::int64_t, 35>;

/// In the order of `Merge_features`. `a` has a lower id than `b`.
inline Features features(const Learned_region& a, const Learned_region& b, const Learned_section& s)
{
  const double pi = std::acos(-1.0);
  const bool is_a_smaller = a.area <= b.area;
  const Learned_region &m = is_a_smaller ? a : b, &M = is_a_smaller ? b : a;
  Learned_region u = m;
  u.add(M, s);
  const double d = std::max(0.0, (s.concave - 0.3 * s.convex + 0.08 * s.bend) /
                                   std::max(s.length, tiny)) +
                   0.022;
  const auto width = [](const Learned_region& r) {
    return std::sqrt(std::max(0.0, trace(r.moments.covariance())));
  };
  const auto own = [&](const Learned_region& r) {
    return quotient(2 * r.own_visibility, r.visibility);
  };
  const auto perimeter = [](const Learned_region& r) {
    return 2 * ln(std::max(r.perimeter, 1e-6)) - ln(r.area);
  };
  const auto flatness = [&](const Learned_region& r) {
    return norm(r.area_vector) / std::max(r.area, tiny);
  };
  const auto filling = [&](const Learned_region& r) {
    return ln(r.area) - ln(pi * trace(r.moments.covariance()));
  };
  const Vector line = m.moments.centroid() - M.moments.centroid();
  const auto outward = [&](const Learned_region& r) {
    return quotient(dot(r.area_vector, line), norm(r.area_vector) * norm(line));
  };
  const double t_m = m.thickness(), t_M = M.thickness(), t_u = u.thickness(),
               t_s = quotient(s.log_thickness, s.length);
  const Vector w = eigenvalues(u.moments.covariance());
  const std::array<double, 35> values = {
    cost(a, b, s, false),
    ln(d),
    quotient(s.concave, s.length),
    ln(m.area),
    ln(M.area),
    2 * ln(s.length) - ln(M.area),
    perimeter(m),
    perimeter(M),
    perimeter(u),
    std::abs(t_m - t_M),
    t_m,
    t_M,
    t_s - t_m,
    t_s - t_M,
    std::sqrt(std::max(0.0, quotient(u.squared_log_thickness, u.area) - t_u * t_u)),
    ln(s.length) - std::min(t_m, t_M),
    ln(width(M)) - t_M,
    quotient(s.visibility, std::min(m.visibility, M.visibility)),
    quotient(s.visibility, std::max(m.visibility, M.visibility)),
    own(m),
    own(M),
    flatness(m),
    flatness(u),
    outward(m) - outward(M),
    norm(line) / std::sqrt(std::max(u.area, tiny)),
    root(w[1], w[0], w[0]),
    root(w[2], w[1], w[0]),
    quotient(width(u), width(m) + width(M)),
    filling(m),
    filling(M),
    m.whole[0],
    m.whole[1],
    m.whole[2],
    m.whole[3],
    m.whole[4]};
  Features x;
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = std::int64_t(std::max(-32767.0, std::min(32767.0, std::floor(512 * values[i] + 0.5))));
  return x;
}

/// e^x by squaring 16 times.
inline double power_of_e(double x)
{
  double y = 1 + x / 65536;
  for (int i = 0; i < 16; ++i)
    y *= y;
  return y;
}

/// The probability that points of the two regions belong to one part.
inline double probability(const Features& x)
{
  static const auto model = CGAL::Region_segmentation::internal::learned_merge_model();
  std::vector<std::int64_t> y;
  for (std::size_t i = 0; i < x.size(); ++i) { // in 2^-8
    const auto& input = model.inputs[i];
    y.push_back(std::max<std::int64_t>(
      -1024, std::min<std::int64_t>(1024, (x[i] - input.center) * input.factor / 65536)));
  }
  const auto product = [&](const auto& weights) { // in 2^-18
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i)
      sum += weights[i] * y[i];
    return sum;
  };
  std::int64_t output = model.output_bias + product(model.direct_weights) * 256; // in 2^-26
  for (const auto& unit : model.units) {
    const double h = double(unit.bias + product(unit.weights));
    output += unit.output_weight * std::int64_t(4096 * h / (262144 + std::abs(h)));
  }
  const double odds = double(output / 64) / 1048576;
  return 1 / (1 + power_of_e(-std::max(-16.0, std::min(16.0, odds))));
}

/// The order of the last merges, and what they cost.
inline double order_of(const Learned_region& a, const Learned_region& b, const Learned_section& s)
{
  const Features x = features(a, b, s);
  const double z = 1 - 2 * probability(x), log_share = double(x[3]) / 512 + double(x[4]) / 512;
  return z * power_of_e((z < 0 ? 0.1 : 0.2) * (log_share + 4.605)) + 0.1 * double(x[0]) / 512;
}

inline double expected_cost(const Learned_region& a, const Learned_region& b,
                            const Learned_section& s)
{
  const Features x = features(a, b, s);
  return power_of_e(double(x[3]) / 512 + double(x[4]) / 512) * (1 - 2 * probability(x));
}

/// As `Learned_merging`.
struct Learned_result : Result
{
  Learned_result(const Mesh& mesh, const Annotated& annotated)
    : Result(mesh, annotated, [&](const Draw& draw) {
      Learned_graph graph = annotate(mesh, draw.graph, draw.region_of);
      Run run;
      merge_by_visibility(60, graph, run.merges);
      merge_down_to(1, graph, order_of, expected_cost, run.merges);
      run.chosen_number = mesh.is_convex() ? graph.regions.size()
                                           : choose_number(number_of(draw.region_of), run.merges);
      return run;
    })
  {}

private:
  /// The largest number, from 60 down to 2, at which the sum of the costs is lowest.
  static std::size_t choose_number(std::size_t regions, const std::vector<Merge>& merges)
  {
    const std::size_t least = std::max(regions - merges.size(), std::min<std::size_t>(regions, 2));
    std::size_t best = std::max(least, std::min<std::size_t>(regions, 60));
    double sum = 0, lowest = 0;
    for (std::size_t n = best; n > least; --n) {
      sum += merges[regions - n].cost;
      if (sum < lowest) {
        lowest = sum;
        best = n - 1;
      }
    }
    return best;
  }
};

} // namespace learned
} // namespace visibility
} // namespace reference

#endif // CGAL_REGION_SEGMENTATION_TEST_REFERENCE_LEARNED_H
