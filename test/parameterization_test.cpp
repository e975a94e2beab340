// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's parameterizers accept the segments of real meshes that are discs: as charts, and as
// pieces.

#include "real_meshes.h"

#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
namespace SMP = CGAL::Surface_mesh_parameterization;
using namespace test;
using Point_2 = Kernel::Point_2;

/// A segmentation of a real mesh.
struct Segmented
{
  Surface_mesh mesh;
  Surface_mesh::Property_map<Surface_mesh::Face_index, std::size_t> segment;
  std::vector<RS::Segment_topology<std::size_t>> topologies;

  explicit Segmented(const Surface_mesh& original)
    : mesh(original)
  {
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    segment = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
    RS::segment(mesh, segment);
    RS::compute_segment_topology(mesh, segment, std::back_inserter(topologies));
  }
};

/// Parameterizes the segments that are discs as charts of one mesh, whose seams are the borders of
/// segments. Returns their number.
std::size_t parameterize_charts(Segmented& s)
{
  Surface_mesh& mesh = s.mesh;
  auto is_border = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:border").first;
  auto is_on_border = mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:border", false)
                        .first;
  auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first;
  RS::mark_segment_borders(mesh, s.segment, is_border);
  for (auto e : edges(mesh))
    if (is_border[e])
      is_on_border[source(e, mesh)] = is_on_border[target(e, mesh)] = true;
  using Seam_mesh = CGAL::Seam_mesh<Surface_mesh, decltype(is_border), decltype(is_on_border)>;
  Seam_mesh charts(mesh, is_border, is_on_border);
  std::set<std::size_t> discs;
  for (const auto& topology : s.topologies)
    if (topology.is_disc())
      discs.insert(topology.segment);
  const std::size_t number = discs.size();
  for (auto h : halfedges(mesh)) {
    if (mesh.is_border(h) || !(is_border[mesh.edge(h)] || mesh.is_border(mesh.opposite(h))) ||
        discs.erase(s.segment[mesh.face(h)]) == 0)
      continue;
    EXPECT_EQ(SMP::parameterize(charts, SMP::LSCM_parameterizer_3<Seam_mesh>(),
                                opposite(Seam_mesh::halfedge_descriptor(h), charts), uv),
              SMP::OK)
      << "segment " << s.segment[mesh.face(h)];
  }
  EXPECT_TRUE(discs.empty()) << "a disc has a border";
  return number;
}

/// Parameterizes the segments that are discs, each as a mesh of its own.
void parameterize_pieces(const Segmented& s)
{
  std::vector<RS::Segment_piece<Surface_mesh, Surface_mesh, std::size_t>> pieces;
  RS::split_into_segments(s.mesh, s.segment, std::back_inserter(pieces));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!s.topologies[i].is_disc())
      continue;
    Surface_mesh& disc = pieces[i].mesh;
    auto uv = disc.add_property_map<Surface_mesh::Vertex_index, Point_2>("v:uv").first;
    const auto all = halfedges(disc);
    const auto border = std::find_if(all.begin(), all.end(),
                                     [&](auto h) { return disc.is_border(h); });
    ASSERT_NE(border, all.end());
    EXPECT_EQ(SMP::parameterize(disc, SMP::LSCM_parameterizer_3<Surface_mesh>(), *border, uv),
              SMP::OK)
      << "segment " << pieces[i].segment;
  }
}

TEST(Parameterization_of_Real_meshes, accepts_segments_that_are_discs)
{
  std::size_t number_of_meshes = 0, number_of_discs = 0;
  check_real_meshes(10000, [&](const Surface_mesh& original) {
    Segmented s(original);
    number_of_discs += parameterize_charts(s);
    parameterize_pieces(s);
    ++number_of_meshes;
    return true;
  });
  EXPECT_GE(number_of_discs, number_of_meshes);
}

} // namespace
