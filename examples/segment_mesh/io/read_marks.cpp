// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_marks.h"

#include "io/Text_scanner.h"
#include "io/load_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>

namespace segment_mesh {

namespace {

/// The value of a word that is the index of one of `number` elements.
std::size_t index_below(const Text_scanner& scan, std::string_view word, std::size_t number, const std::string& what)
{
  const std::int64_t index = scan.integer(word, ("the index of a " + what).c_str());
  if (index < 0 || std::uint64_t(index) >= number)
    scan.fail(in_quotes(word) + " is out of range: there are " + counted(number, what));
  return std::size_t(index);
}

Vertex_pair sorted_pair(std::size_t a, std::size_t b)
{
  const auto [low, high] = std::minmax(a, b);
  return {low, high};
}

/// For each point of the file the one that stands for it in `point_of_mesh_point`: another one where repair has merged
/// equal points.
std::vector<std::size_t> representatives(const Input_mesh& input)
{
  std::vector<std::size_t> result(input.soup.points.size());
  std::iota(result.begin(), result.end(), std::size_t(0));
  if (!input.other_soup)
    return result;
  std::map<Point, std::size_t> by_coordinates;
  for (std::size_t point : input.point_of_mesh_point)
    by_coordinates.emplace(input.soup.points[point], point);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (const auto found = by_coordinates.find(input.soup.points[i]); found != by_coordinates.end())
      result[i] = found->second;
  return result;
}

/// The edges of the mesh, by the points of the file that stand for their ends.
class Mesh_edges
{
public:
  explicit Mesh_edges(const Input_mesh& input) : m_representative(representatives(input))
  {
    for (const Polygon_soup::Polygon& polygon : input.mesh_soup().polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        m_edges.push_back({sorted_pair(input.point_of_mesh_point[a], input.point_of_mesh_point[b]), sorted_pair(a, b)});
      }
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
  }

  /// The edges between two points of the file, as points of the mesh: several where repair has cut the surface.
  std::vector<Vertex_pair> between(std::size_t a, std::size_t b) const
  {
    const Vertex_pair ends = sorted_pair(m_representative[a], m_representative[b]);
    std::vector<Vertex_pair> result;
    for (auto edge = std::lower_bound(m_edges.begin(), m_edges.end(), Edge{ends, {0, 0}});
         edge != m_edges.end() && (*edge)[0] == ends; ++edge)
      result.push_back((*edge)[1]);
    return result;
  }

private:
  using Edge = std::array<Vertex_pair, 2>; // by points of the file, and of the mesh

  std::vector<std::size_t> m_representative;
  std::vector<Edge> m_edges;
};

std::vector<Vertex_pair> read_constraints(const std::string& file, const Input_mesh& input)
{
  const std::string bytes = load_bytes(file);
  const Mesh_edges mesh_edges(input);
  Text_scanner scan(file, bytes, '#');
  const auto next_point = [&] { return index_below(scan, scan.word(), input.soup.points.size(), "point"); };
  std::vector<Vertex_pair> result;
  while (scan.next_line()) {
    std::size_t from = next_point();
    if (!scan.has_word())
      scan.fail("a line of 1 point");
    while (scan.has_word()) {
      const std::size_t to = next_point();
      const std::vector<Vertex_pair> edges = mesh_edges.between(from, to);
      if (edges.empty())
        scan.fail("no edge joins the points " + std::to_string(from) + " and " + std::to_string(to));
      result.insert(result.end(), edges.begin(), edges.end());
      from = to;
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<std::size_t> read_seeds(const std::string& file, const Input_mesh& input)
{
  const std::string bytes = load_bytes(file);
  Text_scanner scan(file, bytes, '#');
  std::vector<std::size_t> result(input.mesh_soup().polygons.size(), no_seed);
  while (scan.next_line()) {
    const std::size_t face = index_below(scan, scan.word(), input.soup.polygons.size(), "face");
    if (!scan.has_word())
      scan.fail("a face without a seed");
    const std::int64_t seed = scan.integer(scan.word(), "a seed");
    if (seed < 0)
      scan.fail("a seed is at least 0");
    if (scan.has_word())
      scan.fail("more than a face and a seed on a line");
    std::size_t& seed_of_face = result[input.mesh_face_of_face[face]];
    if (seed_of_face != no_seed && seed_of_face != std::size_t(seed))
      scan.fail("face " + std::to_string(face) + " has the seed " + std::to_string(seed_of_face) + " already");
    seed_of_face = std::size_t(seed);
  }
  return result;
}

} // namespace

Marks read_marks(const Side_files& files, const Input_mesh& input)
{
  Marks marks;
  if (!files.constraints.empty())
    marks.constrained_edges = read_constraints(files.constraints, input);
  if (!files.seeds.empty())
    marks.seed_of_face = read_seeds(files.seeds, input);
  return marks;
}

std::vector<Vertex_pair> lines_of_marks(const Marks& marks, const Input_mesh& input)
{
  std::vector<Vertex_pair> lines;
  for (const Vertex_pair& edge : marks.constrained_edges)
    lines.push_back({input.point_of_mesh_point[edge[0]], input.point_of_mesh_point[edge[1]]});
  for (std::size_t f = 0; f < input.soup.polygons.size() && !marks.seed_of_face.empty(); ++f) {
    const Polygon_soup::Polygon& polygon = input.soup.polygons[f];
    if (marks.seed_of_face[input.mesh_face_of_face[f]] != no_seed)
      for (std::size_t i = 0; i < polygon.size(); ++i)
        lines.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  return lines;
}

} // namespace segment_mesh
