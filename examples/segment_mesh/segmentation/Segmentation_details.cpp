// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Segmentation_details.h"

#include <CGAL/number_type_config.h>

#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/Segments/extract_segment_borders.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/detect_feature_edges.h>
#include <CGAL/Region_segmentation/extract_feature_lines.h>
#include <CGAL/Region_segmentation/grow_regions.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

namespace {

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// The merge tree with its nodes numbered: regions first, then the result of each merge.
class Numbered_tree
{
public:
  explicit Numbered_tree(const RS::Merge_tree& tree)
      : m_number_of_regions(tree.number_of_regions()),
        m_parents(m_number_of_regions + tree.merges().size(), none), m_heights(m_parents.size())
  {
    std::vector<std::size_t> node_of_region(m_number_of_regions);
    for (std::size_t r = 0; r < m_number_of_regions; ++r)
      node_of_region[r] = r;
    std::size_t node = m_number_of_regions;
    for (const RS::Merge_tree::Merge& merge : tree.merges()) {
      for (std::size_t child : {node_of_region[merge.kept], node_of_region[merge.removed]})
        m_parents[child] = node;
      node_of_region[merge.kept] = node++;
    }
  }

  /// The nodes of all partitions into at most `number_of_segments`, if there are any, in groups of disjoint ones: of one height
  /// above those of them that have no child among them. Groups are small, so that several threads have some.
  std::vector<std::vector<std::size_t>> disjoint_groups(std::size_t number_of_segments)
  {
    constexpr std::size_t greatest_group = 8;
    std::vector<std::vector<std::size_t>> groups;
    const std::size_t number_of_roots = 2 * m_number_of_regions - m_parents.size();
    if (number_of_roots > number_of_segments)
      return groups;
    std::map<std::size_t, std::size_t> open_groups; // by height
    std::fill(m_heights.begin(), m_heights.end(), 0);
    for (std::size_t node = 0; node < m_parents.size(); ++node) {
      // Merge i gives the node R + i and leaves R - i - 1 segments, so its children are segments of R - i.
      const std::size_t parent = m_parents[node];
      if (parent != none && 2 * m_number_of_regions - parent > number_of_segments)
        continue;
      const auto [group, is_new] = open_groups.emplace(m_heights[node], groups.size());
      if (is_new || groups[group->second].size() == greatest_group) {
        group->second = groups.size();
        groups.emplace_back();
      }
      groups[group->second].push_back(node);
      if (parent != none)
        m_heights[parent] = (std::max)(m_heights[parent], m_heights[node] + 1);
    }
    return groups;
  }

  /// For each region the one of `nodes` that contains it, or `no_segment`.
  std::vector<std::size_t> nodes_of_regions(const std::vector<std::size_t>& nodes) const
  {
    std::vector<std::size_t> result(m_parents.size(), std::size_t(RS::no_segment));
    for (std::size_t node : nodes)
      result[node] = node;
    for (std::size_t node = m_parents.size(); node-- > 0;)
      if (result[node] == RS::no_segment && m_parents[node] != none)
        result[node] = result[m_parents[node]];
    result.resize(m_number_of_regions);
    return result;
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  std::size_t m_number_of_regions;
  std::vector<std::size_t> m_parents;
  std::vector<std::size_t> m_heights;
};

} // namespace

class Segmentation_details::Mesh_with_labels
{
public:
  Mesh_with_labels(const Polygon_soup& soup, const Segmentation& segmentation) : m_segmentation(segmentation)
  {
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, m_mesh);
  }

  const Mesh& mesh() const { return m_mesh; }

  auto map_of(const std::vector<std::size_t>& labels) const
  {
    return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, m_mesh));
  }
  auto segment_map() const { return map_of(m_segmentation.segment_of_face); }
  auto region_map() const { return map_of(m_segmentation.region_of_face); }

  std::vector<Segment_description> describe(const std::vector<std::size_t>& labels) const
  {
    std::vector<Segment_description> result;
    RS::describe_segments(m_mesh, map_of(labels), std::back_inserter(result));
    return result;
  }

private:
  const Segmentation& m_segmentation;
  Mesh m_mesh;
};

Segmentation_details::Segmentation_details(const Polygon_soup& soup, const Segmentation& segmentation)
    : m_soup(soup), m_segmentation(segmentation)
{
}

Segmentation_details::~Segmentation_details() = default;

const Segmentation_details::Mesh_with_labels& Segmentation_details::mesh() const
{
  if (!m_mesh)
    m_mesh = std::make_unique<Mesh_with_labels>(m_soup, m_segmentation);
  return *m_mesh;
}

std::vector<Polyline> Segmentation_details::feature_lines() const
{
  const std::optional<Feature_settings>& features = m_segmentation.features;
  if (!features)
    return {};
  const Mesh& m = mesh().mesh();
  std::vector<char> marks(m.number_of_edges());
  const auto is_feature = boost::make_iterator_property_map(marks.begin(), get(boost::edge_index, m));
  std::vector<std::size_t> regions(m.number_of_faces());
  RS::detect_feature_edges(
    m, is_feature,
    RS::parameters::maximum_angle(features->maximum_angle).feature_convexity(features->convexity));
  RS::grow_regions(m, is_feature,
                   boost::make_iterator_property_map(regions.begin(), get(boost::face_index, m)));

  std::vector<std::vector<CGAL::SM_Vertex_index>> lines;
  RS::extract_feature_lines(m, is_feature, std::back_inserter(lines));
  std::vector<Polyline> result;
  for (const auto& line : lines)
    result.emplace_back(line.begin(), line.end());
  return result;
}

std::vector<Region> Segmentation_details::regions() const
{
  const auto graph = RS::build_region_adjacency_graph(mesh().mesh(), mesh().region_map());
  std::vector<Region> result(m_segmentation.number_of_regions);
  for (std::size_t f = 0; f < m_segmentation.region_of_face.size(); ++f) {
    Region& region = result[m_segmentation.region_of_face[f]];
    ++region.number_of_faces;
    region.segment = m_segmentation.segment_of_face[f];
  }
  for (auto range = vertices(graph); range.first != range.second; ++range.first) {
    result[*range.first].area = graph[*range.first].area;
    result[*range.first].perimeter = graph[*range.first].perimeter;
  }
  return result;
}

std::vector<Section> Segmentation_details::sections() const
{
  const auto graph = RS::build_region_adjacency_graph(mesh().mesh(), mesh().region_map());
  std::vector<Section> result;
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto section = *range.first;
    result.push_back({{source(section, graph), target(section, graph)},
                      graph[section].number_of_edges,
                      graph[section].length,
                      graph[section].mean_angle()});
  }
  return result;
}

std::vector<Segment_description> Segmentation_details::segments() const
{
  std::vector<Segment_description> result = mesh().describe(m_segmentation.segment_of_face);
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.segment < b.segment; });
  return result;
}

std::vector<Border> Segmentation_details::borders() const
{
  const Mesh& m = mesh().mesh();
  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(m, mesh().segment_map(), std::back_inserter(borders));
  std::vector<Border> result;
  for (const auto& border : borders) {
    Border& line = result.emplace_back(Border{{border.segment, border.opposite_segment}, {}});
    line.points.push_back(source(border.halfedges.front(), m));
    for (const auto h : border.halfedges)
      line.points.push_back(target(h, m));
  }
  return result;
}

std::vector<Node_description> Segmentation_details::nodes(std::size_t number_of_segments) const
{
  Numbered_tree tree(m_segmentation.tree);
  const std::vector<std::vector<std::size_t>> groups = tree.disjoint_groups(number_of_segments);
  const Mesh_with_labels& labelled = mesh();
  std::vector<std::vector<Segment_description>> shapes(groups.size());
  tbb::parallel_for(std::size_t(0), groups.size(), [&](std::size_t i) {
    const std::vector<std::size_t> node_of_region = tree.nodes_of_regions(groups[i]);
    std::vector<std::size_t> node_of_face;
    node_of_face.reserve(m_segmentation.region_of_face.size());
    for (std::size_t region : m_segmentation.region_of_face)
      node_of_face.push_back(node_of_region[region]);
    shapes[i] = labelled.describe(node_of_face);
  });
  std::vector<Node_description> result;
  for (std::vector<Segment_description>& group : shapes)
    for (Segment_description& shape : group) {
      const std::size_t node = shape.segment;
      result.push_back({node, std::move(shape)});
    }
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
  return result;
}

} // namespace segment_mesh
