// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Segmentation_details.h"

#include "segmentation/Manifold.h"
#include "segmentation/segment_attributes.h"

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Part_faces/find_common_surfaces.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

namespace {

using Mesh = Manifold::Mesh;

/// A segment that begins with a region, and its number as a node of the merge tree.
struct First_region
{
  std::size_t region, node;
};

/// For each merge the two segments that it joins, and at last those that are left. Nodes are the
/// regions, then the results of the merges.
std::vector<std::vector<First_region>> joined_segments(const RS::Merge_tree& tree)
{
  std::vector<std::vector<First_region>> result;
  std::vector<std::size_t> node(tree.number_of_regions());
  std::iota(node.begin(), node.end(), std::size_t(0));
  std::set<std::size_t> left(node.begin(), node.end());
  for (const auto& [kept, removed, cost] : tree.merges()) {
    result.push_back({{kept, node[kept]}, {removed, node[removed]}});
    node[kept] = node.size() + result.size() - 1;
    left.erase(removed);
  }
  result.emplace_back();
  for (const std::size_t region : left)
    result.back().push_back({region, node[region]});
  return result;
}

/// Of a segment that is a face of a machine part.
std::string name_of_face(const Surface_face& face, std::size_t segment)
{
  using RS::Face_role;
  const Face_role role = face.role;
  const std::string name = role == Face_role::NONE    ? name_of(face.surface.kind)
                           : role == Face_role::BLEND ? "fillet"
                                                      : name_of(role);
  std::ostringstream result;
  result << name << '_' << segment << std::setprecision(4);
  if ((role == Face_role::HOLE || role == Face_role::BOSS) &&
      face.surface.kind == RS::Surface_kind::CYLINDER)
    result << "_r" << face.surface.radius;
  return result.str();
}

RS::Surface surface_of(const Polygon_soup& soup, const Segmentation_settings& settings)
{
  return RS::make_surface_of_polygon_soup(
    soup.points, soup.polygons,
    RS::parameters::component_links(settings.links == Component_links::FOUND));
}

} // namespace

std::string clean_name(const std::string& name)
{
  constexpr std::size_t longest = 100; // gmsh cannot read longer names
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xc0)
      continue; // of UTF-8, within a character
    const bool stays = byte < 0x80 && (std::isalnum(byte) ||
                                       std::string_view("_.+-").find(c) != std::string_view::npos);
    result += stays ? c : '_';
  }
  return result.substr(0, longest);
}

/// The graph of the regions, whose vertices are numbered by their first faces.
struct Segmentation_details::Region_graph
{
  RS::Region_adjacency_graph<> graph;
  std::vector<std::size_t> region_of_vertex;
};

/// A mesh with its faces as the method smooth-faces finds them. Labels are of the faces of the
/// mesh.
class Segmentation_details::Machine_part
{
public:
  Machine_part(RS::Surface surface, const RS::Surface_faces& faces);

  /// Of each label that is of one face, or of a piece of it, alone.
  std::map<std::size_t, Surface_face> faces(const std::vector<std::size_t>& labels) const;

  /// The labels that each label meets smoothly. \pre labels are numbered from 0 to n - 1
  std::vector<std::vector<std::size_t>> smooth_neighbors(const std::vector<std::size_t>& labels,
                                                         std::size_t n) const;

private:
  RS::Surface m_surface;
  const RS::Surface_faces& m_faces;
  std::vector<RS::Partition::Index> m_common_surfaces, m_common_axes;
};

Segmentation_details::Machine_part::Machine_part(RS::Surface surface,
                                                 const RS::Surface_faces& faces)
  : m_surface(std::move(surface))
  , m_faces(faces)
  , m_common_surfaces(RS::find_common_surfaces(m_surface, m_faces))
  , m_common_axes(RS::find_common_axes(m_faces))
{}

std::map<std::size_t, Surface_face>
Segmentation_details::Machine_part::faces(const std::vector<std::size_t>& labels) const
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
Segmentation_details::Machine_part::smooth_neighbors(const std::vector<std::size_t>& labels,
                                                     std::size_t n) const
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

Segmentation_details::Segmentation_details(const Polygon_soup& soup,
                                           const Segmentation_settings& settings,
                                           const Segmentation& segmentation)
  : m_soup(soup)
  , m_settings(settings)
  , m_segmentation(segmentation)
{}

Segmentation_details::~Segmentation_details() = default;

const Manifold& Segmentation_details::manifold() const
{
  if (!m_manifold)
    m_manifold = std::make_unique<const Manifold>(make_manifold(m_soup));
  return *m_manifold;
}

const Segmentation_details::Machine_part* Segmentation_details::machine_part() const
{
  if (!m_machine_part && m_segmentation.part_faces)
    m_machine_part = std::make_unique<const Machine_part>(surface_of(m_soup, m_settings),
                                                          *m_segmentation.part_faces);
  return m_machine_part.get();
}

const Segmentation_details::Region_graph& Segmentation_details::region_graph() const
{
  if (m_region_graph)
    return *m_region_graph;
  const RS::Surface surface = surface_of(m_soup, m_settings);
  const std::vector<std::size_t>& labels = m_segmentation.region_of_face;
  const RS::Partition regions = RS::Partition::from_labels(labels);
  Region_graph result = {RS::build_region_adjacency_graph(surface, regions),
                         std::vector<std::size_t>(regions.number_of_parts())};
  for (std::size_t f = 0; f < labels.size(); ++f)
    result.region_of_vertex[regions[f]] = labels[f];
  m_region_graph = std::make_unique<const Region_graph>(std::move(result));
  return *m_region_graph;
}

std::vector<Segment_description>
Segmentation_details::describe(const std::vector<std::size_t>& labels) const
{
  const Mesh& mesh = manifold().mesh;
  const std::vector<std::size_t> labels_of_mesh = manifold().values_of_mesh_faces(labels);
  std::vector<RS::Segment_description<std::size_t, Kernel>> descriptions;
  RS::describe_segments(mesh, face_map(mesh, labels_of_mesh), std::back_inserter(descriptions));
  std::map<std::size_t, Surface_face> faces;
  if (machine_part())
    faces = machine_part()->faces(labels);
  std::vector<Segment_description> result;
  for (auto& description : descriptions) {
    Segment_description& d = result.emplace_back();
    static_cast<decltype(descriptions)::value_type&>(d) = std::move(description);
    const auto face = faces.find(d.segment);
    if (face != faces.end())
      d.face = face->second;
  }
  return result;
}

std::vector<Region> Segmentation_details::regions() const
{
  const auto& [graph, region_of_vertex] = region_graph();
  std::vector<Region> result(m_segmentation.number_of_regions);
  for (std::size_t f = 0; f < m_segmentation.region_of_face.size(); ++f) {
    Region& region = result[m_segmentation.region_of_face[f]];
    ++region.number_of_faces;
    region.segment = m_segmentation.segment_of_face[f];
  }
  for (auto range = vertices(graph); range.first != range.second; ++range.first) {
    Region& region = result[region_of_vertex[*range.first]];
    region.area = graph[*range.first].area;
    region.perimeter = graph[*range.first].perimeter;
  }
  return result;
}

std::vector<Section> Segmentation_details::sections() const
{
  const auto& [graph, region_of_vertex] = region_graph();
  std::vector<Section> result;
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto section = *range.first;
    result.push_back(
      {{region_of_vertex[source(section, graph)], region_of_vertex[target(section, graph)]},
       graph[section].number_of_adjacencies,
       graph[section].length,
       graph[section].mean_angle()});
  }
  return result;
}

std::vector<Segment_description> Segmentation_details::segments() const
{
  std::vector<Segment_description> result(m_segmentation.number_of_segments);
  for (std::size_t s = 0; s < result.size(); ++s)
    result[s].segment = s;
  for (Segment_description& description : describe(m_segmentation.segment_of_face))
    result[description.segment] = std::move(description);
  for (Segment_description& description : result)
    description.number_of_faces = 0;
  for (std::size_t segment : m_segmentation.segment_of_face) // of the soup
    if (segment != RS::no_segment)
      ++result[segment].number_of_faces;
  if (machine_part()) {
    auto neighbors = machine_part()->smooth_neighbors(m_segmentation.segment_of_face,
                                                      result.size());
    for (std::size_t s = 0; s < result.size(); ++s)
      result[s].smooth_neighbors = std::move(neighbors[s]);
  }
  return result;
}

std::vector<std::string> Segmentation_details::names() const
{
  std::vector<std::string> result;
  std::set<std::string> used;
  for (const std::string& name : m_segmentation.names) {
    std::string unique = clean_name(name);
    for (int number = 2; !used.insert(unique).second; ++number)
      unique = clean_name(name) + "_" + std::to_string(number);
    result.push_back(unique);
  }
  while (result.size() < m_segmentation.number_of_segments)
    result.push_back(name_of_segment(result.size()));
  if (machine_part())
    for (const auto& [segment, face] : machine_part()->faces(m_segmentation.segment_of_face))
      if (segment != RS::no_segment)
        result[segment] = name_of_face(face, segment);
  return result;
}

std::vector<Border> Segmentation_details::borders() const
{
  const Mesh& m = manifold().mesh;
  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  const std::vector<std::size_t> labels = manifold().values_of_mesh_faces(
    m_segmentation.segment_of_face);
  RS::extract_segment_borders(m, face_map(m, labels), std::back_inserter(borders));
  const std::vector<std::size_t>& points = manifold().point_of_mesh_point;
  std::vector<Border> result;
  for (const auto& border : borders) {
    Border& line = result.emplace_back(Border{{border.segment, border.opposite_segment}, {}});
    line.points.push_back(points[source(border.halfedges.front(), m)]);
    for (const auto h : border.halfedges)
      line.points.push_back(points[target(h, m)]);
  }
  return result;
}

Solids Segmentation_details::solids() const
{
  const Mesh& m = manifold().mesh;
  const std::vector<std::size_t> labels = manifold().values_of_mesh_faces(
    m_segmentation.segment_of_face);
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::close_segments(m, face_map(m, labels), std::back_inserter(pieces));
  Solids result;
  for (const auto& piece : pieces) {
    const std::size_t first = result.soup.points.size();
    for (const auto v : piece.mesh.vertices())
      result.soup.points.push_back(
        {piece.mesh.point(v).x(), piece.mesh.point(v).y(), piece.mesh.point(v).z()});
    for (const auto f : piece.mesh.faces()) {
      for (const auto v : CGAL::vertices_around_face(piece.mesh.halfedge(f), piece.mesh))
        result.soup.polygons.add_corner(first + v);
      result.soup.polygons.close_polygon();
      result.segment_of_face.push_back(piece.segment);
    }
  }
  return result;
}

std::vector<std::size_t> Segmentation_details::colors(Coloring coloring,
                                                      const std::vector<std::size_t>& labels,
                                                      std::size_t n) const
{
  std::vector<std::size_t> result(n, color_of_no_kind);
  if (coloring == Coloring::SEGMENTS)
    std::iota(result.begin(), result.end(), std::size_t(0));
  else if (machine_part())
    for (const auto& [label, face] : machine_part()->faces(labels))
      result[label] = std::size_t(face.surface.kind);
  return result;
}

std::vector<Segment_description> Segmentation_details::nodes(std::size_t number_of_segments) const
{
  const RS::Merge_tree& tree = m_segmentation.tree;
  const std::size_t number_of_regions = tree.number_of_regions(),
                    number_of_merges = tree.merges().size(),
                    first = number_of_regions - (std::min)(number_of_segments, number_of_regions);
  if (first > number_of_merges) // even the segments that are left are more
    return {};
  const std::vector<std::vector<First_region>> joined = joined_segments(tree);
  manifold(), machine_part(); // made by this thread
  std::vector<std::vector<Segment_description>> shapes(number_of_merges + 1);
  const RS::Execution execution = RS::internal::make_execution<CGAL::Parallel_if_available_tag>(
    RS::parameters::default_values());
  execution.for_each(first, shapes.size(), [&](std::size_t i) {
    const RS::Partition segments = tree.partition_at_count(number_of_regions - i);
    std::vector<std::size_t> node_of_segment(segments.number_of_parts(),
                                             std::size_t(RS::no_segment)),
      node_of_face;
    for (const First_region& segment : joined[i])
      node_of_segment[segments[segment.region]] = segment.node;
    for (std::size_t region : m_segmentation.region_of_face)
      node_of_face.push_back(node_of_segment[segments[region]]);
    shapes[i] = describe(node_of_face);
  });
  std::vector<Segment_description> result;
  for (std::vector<Segment_description>& of_merge : shapes)
    std::move(of_merge.begin(), of_merge.end(), std::back_inserter(result));
  return result;
}

} // namespace segment_mesh
