// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_SET_BUILDER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_SET_BUILDER_H

#include "soup/Mesh_properties.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

/// Collects sets of faces from a file, which names a set before its faces.
class Face_set_builder
{
public:
  /// The faces from `next_face` on are of the set of this name.
  void start(const std::string& name, std::size_t next_face) { add(set_of(name), next_face); }

  /// The same, of a set of its own, whatever the names of others.
  void start_new(const std::string& name, std::size_t next_face)
  {
    m_names.push_back(name.empty() ? unnamed : name);
    add(m_names.size() - 1, next_face);
  }

  /// Empty if no set was named. Faces before the first one are in that without a name.
  Face_sets build(std::size_t number_of_faces)
  {
    Face_sets result;
    if (m_starts.empty())
      return result;
    if (m_starts.front().second > 0)
      m_starts.insert(m_starts.begin(), {set_of(""), 0});
    for (std::size_t i = 0; i < m_starts.size(); ++i)
      result.set_of_face.resize(i + 1 < m_starts.size() ? m_starts[i + 1].second : number_of_faces,
                                Polygons::Index(m_starts[i].first));
    result.names = std::make_shared<const std::vector<std::string>>(std::move(m_names));
    return result;
  }

private:
  static inline const std::string unnamed = "unnamed";

  std::size_t set_of(const std::string& name)
  {
    const auto [set, is_new] = m_sets.emplace(name, m_names.size());
    if (is_new)
      m_names.push_back(name.empty() ? unnamed : name);
    return set->second;
  }

  void add(std::size_t set, std::size_t next_face)
  {
    if (!m_starts.empty() && m_starts.back().second == next_face)
      m_starts.pop_back(); // it has no face
    m_starts.push_back({set, next_face});
  }

  std::vector<std::string> m_names;
  std::map<std::string, std::size_t> m_sets;
  std::vector<std::pair<std::size_t, std::size_t>> m_starts; // a set, and its next face
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FACE_SET_BUILDER_H
