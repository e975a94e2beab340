// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/read_marks.h"

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/load_bytes.h"
#include "soup/Edge_list.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace segment_mesh {

namespace {

/// The value of a word that is the index of one of `number` elements.
std::size_t index_below(const Text_scanner& scan, std::string_view word, std::size_t number,
                        const std::string& what)
{
  const std::int64_t index = scan.integer(word, ("the index of a " + what).c_str());
  if (index < 0 || std::uint64_t(index) >= number)
    scan.fail(out_of_range(index, number, what, 0));
  return std::size_t(index);
}

std::vector<Vertex_pair> read_constraints(const std::string& file, const Input_mesh& input)
{
  const std::string bytes = load_bytes(file);
  const Edge_list edges(input.soup);
  Text_scanner scan(file, bytes, '#');
  const auto next_point = [&] {
    return index_below(scan, scan.word(), input.soup.points.size(), "point");
  };
  std::vector<Vertex_pair> result;
  while (scan.next_line()) {
    std::size_t from = next_point();
    if (!scan.has_word())
      scan.fail("a line of 1 point");
    while (scan.has_word()) {
      const std::size_t to = next_point();
      if (!edges.has(from, to))
        scan.fail("no edge joins the points " + std::to_string(from) + " and " +
                  std::to_string(to));
      result.push_back({(std::min)(from, to), (std::max)(from, to)});
      from = to;
    }
  }
  return result;
}

std::vector<std::size_t> read_seeds(const std::string& file, const Input_mesh& input)
{
  const std::string bytes = load_bytes(file);
  Text_scanner scan(file, bytes, '#');
  std::vector<std::size_t> result(input.soup.polygons.size(), no_seed);
  while (scan.next_line()) {
    const std::size_t face = index_below(scan, scan.word(), input.soup.polygons.size(), "face");
    if (!scan.has_word())
      scan.fail("a face without a seed");
    const std::int64_t seed = scan.integer(scan.word(), "a seed");
    if (seed < 0)
      scan.fail("a seed is at least 0");
    if (scan.has_word())
      scan.fail("more than a face and a seed on a line");
    std::size_t& seed_of_face = result[face];
    if (seed_of_face != no_seed && seed_of_face != std::size_t(seed))
      scan.fail("face " + std::to_string(face) + " has the seed " + std::to_string(seed_of_face) +
                " already");
    seed_of_face = std::size_t(seed);
  }
  return result;
}

} // namespace

const Face_sets& sets_of_input(const std::string& file, const Input_mesh& input, Set_kind kind)
{
  if (!input.properties.of(kind).empty())
    return input.properties.of(kind);
  std::string others;
  for (Set_kind other : input.properties.kinds())
    others += (others.empty() ? "; it has " : " and ") +
              std::string(set_kind_names[std::size_t(other)]);
  throw Input_error(file, std::string("has no ") + set_kind_names[std::size_t(kind)] + others);
}

Marks read_marks(const Side_files& files, const std::string& file, const Input_mesh& input)
{
  Marks marks;
  if (!files.constraints.empty())
    marks.constrained_edges = read_constraints(files.constraints, input);
  if (files.constraints_from)
    for (const Vertex_pair& edge : borders_of_labels(
           input.soup, sets_of_input(file, input, *files.constraints_from).set_of_face))
      marks.constrained_edges.push_back(edge);
  std::vector<Vertex_pair>& edges = marks.constrained_edges;
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  if (!files.seeds.empty())
    marks.seed_of_face = read_seeds(files.seeds, input);
  return marks;
}

} // namespace segment_mesh
