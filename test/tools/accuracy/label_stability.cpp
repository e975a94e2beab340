// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much the labels of copies of a mesh differ: renumbered, moved, written with fewer digits,
// with noise in the last digits.

#include "Princeton_data.h"
#include "Table.h"
#include "model_sources.h"

#include "read/errors.h"

#include <CGAL/Region_segmentation/Evaluation/overlap_measures.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <CGAL/Simple_cartesian.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace princeton_benchmark {

namespace {

namespace RS = CGAL::Region_segmentation;
using segment_mesh::Point;
using segment_mesh::Polygon_soup;
using Labels = std::vector<std::size_t>;
using Engine = std::mt19937;

/// The sum of 12 evenly distributed numbers less 6, nearly normal, with a deviation of 1: the
/// standard does not fix its distributions.
double deviate(Engine& random)
{
  double sum = -6;
  for (int i = 0; i < 12; ++i)
    sum += std::ldexp(double(random()), -32);
  return sum;
}

template <typename Items>
void shuffle(Items& items, Engine& random)
{
  for (std::size_t i = items.size(); i > 1; --i)
    std::swap(items[i - 1], items[random() % i]);
}

double diagonal(const Polygon_soup& soup)
{
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax_element(
      soup.points.begin(), soup.points.end(),
      [&](const Point& p, const Point& q) { return p[i] < q[i]; });
    squares += std::pow((*high)[i] - (*low)[i], 2);
  }
  return std::sqrt(squares);
}

/// A copy of a mesh, and the face of the copy for each face of the mesh.
struct Copy
{
  Polygon_soup soup;
  std::vector<std::size_t> face;
};

Copy same_faces(Polygon_soup soup)
{
  std::vector<std::size_t> face(soup.polygons.size());
  std::iota(face.begin(), face.end(), std::size_t(0));
  return {std::move(soup), std::move(face)};
}

/// Points, faces and first corners in another order.
Copy renumbered(const Polygon_soup& soup, Engine& random)
{
  Copy copy = same_faces(soup);
  std::vector<std::size_t> vertex(soup.points.size());
  std::iota(vertex.begin(), vertex.end(), std::size_t(0));
  shuffle(vertex, random);
  shuffle(copy.face, random);
  for (std::size_t v = 0; v < vertex.size(); ++v)
    copy.soup.points[vertex[v]] = soup.points[v];
  std::vector<std::size_t> face_of_copy(copy.face.size());
  for (std::size_t f = 0; f < copy.face.size(); ++f)
    face_of_copy[copy.face[f]] = f;
  copy.soup.polygons = segment_mesh::Polygons();
  for (const std::size_t f : face_of_copy) {
    std::vector<std::size_t> corners;
    for (const std::size_t v : soup.polygons[f])
      corners.push_back(vertex[v]);
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(random() % corners.size()),
                corners.end());
    copy.soup.polygons.push_back(corners);
  }
  return copy;
}

/// A random rotation, by a quaternion, a scaling and a translation.
Copy moved(Polygon_soup soup, Engine& random)
{
  std::array<double, 4> q;
  for (double& x : q)
    x = deviate(random);
  const double length = std::sqrt(std::inner_product(q.begin(), q.end(), q.begin(), 0.0));
  for (double& x : q)
    x /= length;
  const auto [w, x, y, z] = q;
  const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  const double scale = std::exp(deviate(random)), size = diagonal(soup);
  const Point away{size * deviate(random), size * deviate(random), size * deviate(random)};
  for (Point& p : soup.points) {
    const Point from = p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = scale * (rows[i][0] * from[0] + rows[i][1] * from[1] + rows[i][2] * from[2]) + away[i];
  }
  return same_faces(std::move(soup));
}

Copy in_five_digits(Polygon_soup soup, Engine&)
{
  for (Point& p : soup.points)
    for (double& x : p) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "%.5g", x);
      x = std::strtod(digits, nullptr);
    }
  return same_faces(std::move(soup));
}

/// `share`: of the diagonal of the bounding box, the standard deviation of each coordinate
Copy with_deviates(Polygon_soup soup, double share, Engine& random)
{
  const double noise = share * diagonal(soup);
  for (Point& p : soup.points)
    for (double& x : p)
      x += noise * deviate(random);
  return same_faces(std::move(soup));
}

/// What is measured of one kind of copies.
struct Kind
{
  std::string name;
  std::function<Copy(const Polygon_soup&, Engine&)> make;
  std::vector<double> given, chosen; ///< Rand index distances
  std::size_t other_numbers = 0;     ///< models whose chosen number changes
};

struct Segmentations
{
  Labels given, chosen;
  std::size_t number; ///< that is chosen
};

Segmentations segmentations(const Polygon_soup& soup, std::size_t k,
                            const RS::Learned_merging& method)
{
  using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point_3> points;
  for (const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  const RS::Polygon_soup_segmenter<RS::Learned_merging> segmenter(points, soup.polygons,
                                                                  RS::parameters::method(method));
  Segmentations result{Labels(soup.polygons.size()), Labels(soup.polygons.size()), 0};
  segmenter.segment(result.given, k);
  result.number = segmenter.segment(result.chosen);
  return result;
}

void measure(const Model& model, const RS::Learned_merging& method, unsigned seed,
             std::vector<Kind>& kinds)
{
  const Segmentations of_model = segmentations(model.soup, model.number_of_segments, method);
  for (Kind& kind : kinds) {
    Engine random(seed);
    const Copy copy = kind.make(model.soup, random);
    const Segmentations of_copy = segmentations(copy.soup, model.number_of_segments, method);
    const auto distance = [&](const Labels& labels, const Labels& labels_of_copy) {
      Labels by_face;
      for (const std::size_t face : copy.face)
        by_face.push_back(labels_of_copy[face]);
      return RS::rand_index_distance(labels, by_face);
    };
    kind.given.push_back(distance(of_model.given, of_copy.given));
    kind.chosen.push_back(distance(of_model.chosen, of_copy.chosen));
    kind.other_numbers += of_model.number != of_copy.number;
  }
}

/// Mean, median, largest.
std::vector<std::string> summary(std::vector<double> distances)
{
  std::sort(distances.begin(), distances.end());
  return {
    score(std::accumulate(distances.begin(), distances.end(), 0.0) / double(distances.size())),
    score(distances[distances.size() / 2]), score(distances.back())};
}

Table table(const std::vector<Kind>& kinds)
{
  Table result;
  result.title = "1 - Rand index between the labels of " +
                 counted(kinds.front().given.size(), "model") + " and of their copies";
  result.header = {"",       "k given: mean", "median",       "largest", "chosen: mean",
                   "median", "largest",       "other numbers"};
  for (const Kind& kind : kinds) {
    std::vector<std::string> row{kind.name};
    for (const auto* distances : {&kind.given, &kind.chosen})
      for (const std::string& value : summary(*distances))
        row.push_back(value);
    row.push_back(std::to_string(kind.other_numbers));
    result.rows.push_back(row);
  }
  return result;
}

int run_program(int argc, char** argv)
{
  std::string folder;
  std::size_t step = 1;
  RS::Learned_merging method;
  CLI::App app("Compares the labels of copies of meshes, by the default method.",
               "label_stability");
  app
    .add_option("--data", folder,
                "The Princeton benchmark in its own layout. Default: procedural "
                "models")
    ->check(CLI::ExistingDirectory)
    ->type_name("DIR");
  app.add_option("--every", step, "One of so many models. Default: 1")->check(CLI::Range(1, 1000));
  app.add_option("--draws", method.number_of_draws, "Default: that of the method")
    ->check(CLI::Range(1, 1000));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::optional<Princeton_data> data;
  if (!folder.empty())
    data.emplace(folder);
  const std::vector<Model_source> sources = data ? princeton_sources(*data) : procedural_sources();
  const auto noise = [](double share) {
    return [share](const Polygon_soup& soup, Engine& random) {
      return with_deviates(soup, share, random);
    };
  };
  std::vector<Kind> kinds = {{"renumbered", renumbered, {}, {}},
                             {"moved and scaled", moved, {}, {}},
                             {"5 digits", in_five_digits, {}, {}},
                             {"noise of 1e-7", noise(1e-7), {}, {}},
                             {"noise of 1e-5", noise(1e-5), {}, {}}};
  for (std::size_t i = 0; i < sources.size(); i += step)
    measure(sources[i].load(), method, unsigned(i + 1), kinds);
  write_text(std::cout, table(kinds));
  return 0;
}

} // namespace

} // namespace princeton_benchmark

int main(int argc, char** argv)
{
  try {
    return princeton_benchmark::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "label_stability: " << segment_mesh::one_line(error.what()) << "\n";
    return 1;
  }
}
