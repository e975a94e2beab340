// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Machine_part.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Part_faces/find_common_surfaces.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>

#include <limits>
#include <utility>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

Machine_part::Machine_part(RS::Surface surface, double tolerance)
  : m_surface(std::move(surface))
  , m_faces(RS::find_surface_faces(m_surface, tolerance))
  , m_common_surfaces(RS::find_common_surfaces(m_surface, m_faces))
  , m_common_axes(RS::find_common_axes(m_faces))
{}

std::map<std::size_t, Surface_face>
Machine_part::faces(const std::vector<std::size_t>& labels) const
{
  constexpr std::size_t several = (std::numeric_limits<std::size_t>::max)();
  std::map<std::size_t, std::size_t> parts; // by label
  for (std::size_t f = 0; f < labels.size(); ++f) {
    std::size_t& part = parts.emplace(labels[f], m_faces.partition[f]).first->second;
    if (part != m_faces.partition[f])
      part = several;
  }
  std::map<std::size_t, Surface_face> result;
  std::map<std::size_t, std::size_t> labels_of_surfaces, labels_of_axes;
  for (const auto& [label, part] : parts)
    if (part != several)
      result[label] = {RS::scaled<Kernel>(m_faces.surfaces[part], m_surface.unit()),
                       m_faces.roles[part],
                       labels_of_surfaces.emplace(m_common_surfaces[part], label).first->second,
                       labels_of_axes.emplace(m_common_axes[part], label).first->second};
  return result;
}

std::vector<std::vector<std::size_t>>
Machine_part::smooth_neighbors(const std::vector<std::size_t>& labels, std::size_t n) const
{
  const RS::Partition segments = RS::Partition::from_labels(labels);
  std::vector<std::size_t> label_of_vertex(segments.number_of_parts());
  for (std::size_t f = 0; f < labels.size(); ++f)
    label_of_vertex[segments[f]] = labels[f];
  auto graph = RS::build_region_adjacency_graph<RS::Surface_face_region_data,
                                                RS::Surface_face_section_data>(m_surface, segments);
  RS::annotate_surface_faces(graph, m_surface, segments, m_faces);
  std::vector<std::vector<std::size_t>> result(n);
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto section = *range.first;
    if (!graph[section].is_smooth())
      continue;
    const std::size_t a = label_of_vertex[source(section, graph)],
                      b = label_of_vertex[target(section, graph)];
    result[a].push_back(b);
    result[b].push_back(a);
  }
  return result;
}

} // namespace segment_mesh
