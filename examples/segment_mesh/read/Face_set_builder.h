// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_SET_BUILDER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_SET_BUILDER_H

#include "soup/Mesh_properties.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

/// Collects sets of faces from a file, which names a set before its faces.
class Face_set_builder
{
public:
  /// The faces from `next_face` on are of the set of this name.
  void start(const std::string& name, std::size_t next_face)
  {
    if (!m_starts.empty() && m_starts.back().second == next_face)
      m_starts.pop_back(); // it has no face
    m_starts.push_back({name.empty() ? unnamed : name, next_face});
  }

  /// The same, of a set of its own: it gets a number if there is another one of this name.
  void start_new(const std::string& name, std::size_t next_face)
  {
    const std::size_t count = ++m_counts[name];
    start(count == 1 ? name : (name.empty() ? unnamed : name) + "_" + std::to_string(count),
          next_face);
  }

  /// Empty if no set was named.
  Face_sets build(std::size_t number_of_faces) const
  {
    Face_sets result;
    if (m_starts.empty())
      return result;
    std::map<std::string, std::size_t> numbers;
    const auto add = [&](const std::string& name, std::size_t end) {
      if (end <= result.set_of_face.size())
        return;
      const auto [set, is_new] = numbers.emplace(name, result.names.size());
      if (is_new)
        result.names.push_back(name);
      result.set_of_face.resize(end, Polygons::Index(set->second));
    };
    add(unnamed, m_starts.front().second);
    for (std::size_t i = 0; i < m_starts.size(); ++i)
      add(m_starts[i].first, i + 1 < m_starts.size() ? m_starts[i + 1].second : number_of_faces);
    return result;
  }

private:
  static inline const std::string unnamed = "unnamed";

  std::vector<std::pair<std::string, std::size_t>> m_starts;
  std::map<std::string, std::size_t> m_counts;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_SET_BUILDER_H
