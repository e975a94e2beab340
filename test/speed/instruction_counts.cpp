// SPDX-License-Identifier: GPL-3.0-or-later

// Segments meshes that are made here, for callgrind, which counts and dumps each call by its name.

#include "make_mesh.h"
#include "make_triangles.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/function_property_map.hpp>

#include <valgrind/callgrind.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>

namespace {

namespace RS = CGAL::Region_segmentation;
using speed_benchmark::make_mesh;
using speed_benchmark::Mesh;

/// \returns whether there are 8 segments
template <typename SegmentationMethod>
bool count(const char* name, const Mesh& mesh, const SegmentationMethod& method)
{
  std::vector<std::uint32_t> segments(num_faces(mesh));
  const auto map = boost::make_iterator_property_map(segments.begin(), get(CGAL::face_index, mesh));
  const auto np = RS::parameters::number_of_segments(8).method(method);
  CALLGRIND_START_INSTRUMENTATION;
  const std::size_t number = RS::segment(mesh, map, np);
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT(name);
  std::cout << name << ": " << number << " segments\n";
  return number == 8;
}

/// \returns whether they are adjacent across three edges each
bool count_reading(const speed_benchmark::Triangles& polygons)
{
  CALLGRIND_START_INSTRUMENTATION;
  const RS::Surface surface = RS::make_surface_of_polygon_soup(polygons.points, polygons.corners);
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT("reading polygons");
  return 2 * surface.number_of_adjacencies() == 3 * polygons.corners.size();
}

/// A number of segments, and a drawn line, of a mesh that is prepared.
/// \returns whether there are 8 segments, and the line is a border
bool count_segmenter(const Mesh& mesh)
{
  std::vector<std::uint32_t> segments(num_faces(mesh));
  const auto map = boost::make_iterator_property_map(segments.begin(), get(CGAL::face_index, mesh));
  RS::Segmenter segmenter(mesh);
  CALLGRIND_START_INSTRUMENTATION;
  const std::size_t number = segmenter.segment(map, 8);
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT("number of a segmenter");
  const auto is_right = [&](Mesh::Face_index f) {
    double x = 0;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      x += mesh.point(v).x();
    return x > 0;
  };
  const auto line = boost::make_function_property_map<Mesh::Edge_index>([&](Mesh::Edge_index e) {
    const auto h = halfedge(e, mesh);
    return is_right(face(h, mesh)) != is_right(face(opposite(h, mesh), mesh));
  });
  CALLGRIND_START_INSTRUMENTATION;
  segmenter.add_constraints(line);
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT("line in a segmenter");
  segmenter.segment(map, 8);
  std::size_t crossed = 0;
  for (const auto e : edges(mesh))
    crossed += get(line, e) && get(map, face(halfedge(e, mesh), mesh)) ==
                                 get(map, face(opposite(halfedge(e, mesh), mesh), mesh));
  std::cout << "drawn line: " << crossed << " of its edges inside a segment\n";
  return number == 8 && crossed == 0;
}

} // namespace

int main()
{
  // 20,000 faces with the creases of 1,250; and with a crease at every edge.
  const auto torus = subdivided(subdivided(speed_benchmark::wavy_torus(1250)));
  const Mesh smooth = make_mesh(torus), noisy = make_mesh(roughened(torus, 0.2));
  const bool is_right = count("two-step smooth", smooth, RS::Two_step()) &
                        count("two-step noisy", noisy, RS::Two_step()) &
                        count("visibility smooth", smooth, RS::Visibility_merging()) &
                        count("learned smooth", smooth, RS::Learned_merging()) &
                        count_reading(torus) & count_segmenter(smooth);
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}
