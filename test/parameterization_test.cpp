// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's parameterizers accept the segments of real meshes: opened by seams, as charts and as
// pieces.

#include "real_meshes.h"

#include <CGAL/Region_segmentation/Segments/mark_segment_seams.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
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
  std::size_t number;

  explicit Segmented(const Surface_mesh& original)
    : mesh(original)
  {
    CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
    segment = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
    number = RS::segment(mesh, segment);
  }
};

TEST(Parameterization_of_Real_meshes, accepts_segments_opened_by_seams)
{
  check_real_meshes(10000, [](const Surface_mesh& original) {
    Segmented s(original);
    Surface_mesh& mesh = s.mesh;
    auto is_seam = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:seam").first;
    auto is_on_seam = mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:on_seam", false)
                        .first;
    auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first;
    RS::mark_segment_seams(mesh, s.segment, is_seam);
    for (auto e : edges(mesh))
      if (is_seam[e])
        is_on_seam[source(e, mesh)] = is_on_seam[target(e, mesh)] = true;
    using Seam_mesh = CGAL::Seam_mesh<Surface_mesh, decltype(is_seam), decltype(is_on_seam)>;
    Seam_mesh charts(mesh, is_seam, is_on_seam);
    std::vector<char> is_done(s.number, false);
    for (auto h : halfedges(mesh)) { // segments of the default method are connected
      if (mesh.is_border(h) || is_done[s.segment[mesh.face(h)]] ||
          !(is_seam[mesh.edge(h)] || mesh.is_border(mesh.opposite(h))))
        continue;
      is_done[s.segment[mesh.face(h)]] = true;
      EXPECT_EQ(SMP::parameterize(charts, SMP::LSCM_parameterizer_3<Seam_mesh>(),
                                  opposite(Seam_mesh::halfedge_descriptor(h), charts), uv),
                SMP::OK)
        << "segment " << s.segment[mesh.face(h)];
    }
    EXPECT_EQ(std::count(is_done.begin(), is_done.end(), true), std::ptrdiff_t(s.number))
      << "segments have a border";
    return true;
  });
}

} // namespace
