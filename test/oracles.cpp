// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles.h"

#include <algorithm>
#include <cmath>

namespace test {

namespace {

std::size_t count_pieces(const Soup& soup, const Labels& labels, const std::set<Edge>& uncrossed)
{
  std::vector<std::vector<std::size_t>> neighbors(soup.polygons.size());
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (faces.size() == 2 && labels[faces[0]] == labels[faces[1]] && !uncrossed.count(edge)) {
      neighbors[faces[0]].push_back(faces[1]);
      neighbors[faces[1]].push_back(faces[0]);
    }
  std::vector<bool> is_seen(soup.polygons.size());
  std::size_t pieces = 0;
  for (std::size_t seed = 0; seed < soup.polygons.size(); ++seed) {
    if (is_seen[seed])
      continue;
    ++pieces;
    std::vector<std::size_t> stack = {seed};
    is_seen[seed] = true;
    while (!stack.empty()) {
      const std::size_t f = stack.back();
      stack.pop_back();
      for (std::size_t g : neighbors[f])
        if (!is_seen[g]) {
          is_seen[g] = true;
          stack.push_back(g);
        }
    }
  }
  return pieces;
}

} // namespace

::testing::AssertionResult is_numbered_by_first_face(const Labels& labels, std::size_t n)
{
  std::size_t next = 0;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    if (labels[f] > next)
      return ::testing::AssertionFailure()
             << "face " << f << " has label " << labels[f] << " where " << next << " is the next";
    next += labels[f] == next;
  }
  if (next != n)
    return ::testing::AssertionFailure() << next << " labels, not " << n;
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult is_connected(const Soup& soup, const Labels& labels,
                                        const std::set<Edge>& uncrossed)
{
  const std::size_t pieces = count_pieces(soup, labels, uncrossed);
  const std::size_t n = std::set<std::size_t>(labels.begin(), labels.end()).size();
  if (pieces != n)
    return ::testing::AssertionFailure() << n << " labels in " << pieces << " pieces";
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult nests(const Labels& fine, const Labels& coarse)
{
  std::map<std::size_t, std::size_t> parent;
  for (std::size_t f = 0; f < fine.size(); ++f)
    if (parent.emplace(fine[f], coarse[f]).first->second != coarse[f])
      return ::testing::AssertionFailure() << "label " << fine[f] << " lies in several";
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult separates(const Soup& soup, const std::set<Edge>& edges,
                                     const Labels& regions, const Labels& labels)
{
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (faces.size() == 2 && edges.count(edge) && regions[faces[0]] != regions[faces[1]] &&
        labels[faces[0]] == labels[faces[1]])
      return ::testing::AssertionFailure()
             << "edge " << edge.first << " " << edge.second << " has one label on both sides";
  return ::testing::AssertionSuccess();
}

Labels renumbered(const Labels& labels)
{
  Labels result;
  std::map<std::size_t, std::size_t> new_of_old;
  for (std::size_t label : labels)
    result.push_back(new_of_old.emplace(label, new_of_old.size()).first->second);
  return result;
}

std::map<Edge, std::vector<std::size_t>> faces_of_edges(const Soup& soup)
{
  std::map<Edge, std::vector<std::size_t>> result;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon& p = soup.polygons[f];
    for (std::size_t i = 0; i < p.size(); ++i)
      result[make_edge(p[i], p[(i + 1) % p.size()])].push_back(f);
  }
  return result;
}

std::size_t number_of_components(const Soup& soup)
{
  return count_pieces(soup, Labels(soup.polygons.size(), 0), {});
}

std::size_t number_of_proper_faces(const Soup& soup)
{
  std::size_t number = 0;
  for (const Polygon& polygon : soup.polygons) {
    const Point& origin = soup.points[polygon[0]];
    const auto from = [&](const Point& p, std::size_t v) {
      const Point& q = soup.points[polygon[v % polygon.size()]];
      return Point{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    };
    Point area{0, 0, 0};
    double longest = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point a = from(origin, i), b = from(origin, i + 1),
                  e = from(soup.points[polygon[i]], i + 1);
      area = {area[0] + a[1] * b[2] - a[2] * b[1], area[1] + a[2] * b[0] - a[0] * b[2],
              area[2] + a[0] * b[1] - a[1] * b[0]};
      longest = std::max(longest, e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    }
    number += std::sqrt(area[0] * area[0] + area[1] * area[1] + area[2] * area[2]) / 2 >
              1e-12 * longest;
  }
  return number;
}

std::size_t count(const Edge_flags& flags)
{
  return std::size_t(
    std::count_if(flags.begin(), flags.end(), [](const auto& f) { return f.second; }));
}

std::set<Edge> random_edges(const Soup& soup, std::size_t one_of, std::mt19937& random)
{
  std::set<Edge> result;
  for (const auto& entry : faces_of_edges(soup))
    if (random() % one_of == 0)
      result.insert(entry.first);
  return result;
}

Options random_options(std::mt19937& random)
{
  constexpr reference::Convexity convexities[] = {
    reference::Convexity::concave, reference::Convexity::convex, reference::Convexity::all};
  constexpr double angles[] = {180. - 3.12 * 180. / reference::pi, 10, 20, 35};
  const auto convexity = convexities[random() % 3];
  const double angle = angles[random() % 4];
  return Options(1 + random() % 12, convexity, angle);
}

Result run(const Soup& soup, const Options& options)
{
  return run(to_surface_mesh(soup), options);
}

} // namespace test
