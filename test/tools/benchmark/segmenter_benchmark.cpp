// SPDX-License-Identifier: GPL-3.0-or-later

// segmenter_benchmark [FACES]: what a Segmenter that is prepared takes, beside preparing it: any
// number of segments, against writing the map alone; a drawn loop and seeds, against preparing.
// Medians, processor time.

#include "make_mesh.h"
#include "make_triangles.h"
#include "seconds.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
using speed_benchmark::make_mesh;
using speed_benchmark::Mesh;
using Face = Mesh::Face_index;

template <typename F>
double median_seconds(std::size_t rounds, const F& f)
{
  std::vector<double> times;
  for (std::size_t i = 0; i < rounds; ++i)
    times.push_back(speed_benchmark::seconds_of(speed_benchmark::Clock::PROCESSOR, f));
  std::nth_element(times.begin(), times.begin() + std::ptrdiff_t(rounds / 2), times.end());
  return times[rounds / 2];
}

/// A few repetitions in one measurement: writing labels takes less than the clock's resolution may
/// be.
template <typename F>
double median_seconds_of_short(const F& f)
{
  constexpr std::size_t repetitions = 10;
  return median_seconds(15,
                        [&] {
                          for (std::size_t i = 0; i < repetitions; ++i)
                            f();
                        }) /
         double(repetitions);
}

/// The edges between the faces near the first one, and the others.
std::vector<bool> draw_loop(const Mesh& mesh)
{
  const auto point = [&](Face f) { return mesh.point(target(mesh.halfedge(f), mesh)); };
  double farthest = 0;
  for (Face f : mesh.faces())
    farthest = (std::max)(farthest, squared_distance(point(f), point(Face(0))));
  const auto is_near = [&](Face f) {
    return squared_distance(point(f), point(Face(0))) < 0.04 * farthest;
  };
  std::vector<bool> is_drawn(num_edges(mesh));
  for (auto e : mesh.edges())
    is_drawn[e] = is_near(mesh.face(mesh.halfedge(e, 0))) !=
                  is_near(mesh.face(mesh.halfedge(e, 1)));
  return is_drawn;
}

template <typename Method>
void measure(const char* name, const Mesh& mesh, const Method& method)
{
  std::vector<std::uint32_t> labels(num_faces(mesh)), values(num_faces(mesh), 3),
    expected(num_faces(mesh));
  const auto map = boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh));
  const auto expected_map = boost::make_iterator_property_map(expected.begin(),
                                                              get(CGAL::face_index, mesh));
  const auto np = RS::parameters::method(method);
  const double preparing = median_seconds(5, [&] { RS::Segmenter(mesh, np); });
  const RS::Segmenter segmenter(mesh, np);
  const double writing = median_seconds_of_short([&] { RS::write_face_values(mesh, values, map); });
  double slowest = 0;
  bool is_equal = true;
  for (std::size_t k = 2; k <= 40; ++k) {
    slowest = (std::max)(slowest, median_seconds_of_short([&] { segmenter.segment(map, k); }));
    RS::segment(mesh, expected_map, np.number_of_segments(k));
    is_equal &= labels == expected;
  }

  const auto copying = median_seconds(5, [&] { auto copy = segmenter; });
  const std::vector<bool> is_drawn = draw_loop(mesh);
  const double drawing = median_seconds(5, [&] {
    auto copy = segmenter;
    copy.add_constraints(boost::make_function_property_map<Mesh::Edge_index>(
      [&](Mesh::Edge_index e) { return is_drawn[e]; }));
  });
  std::vector<std::size_t> seed_of_face(num_faces(mesh), std::size_t(-1));
  seed_of_face[num_faces(mesh) / 7] = seed_of_face[num_faces(mesh) / 2] = 1;
  seed_of_face[num_faces(mesh) / 3] = 2;
  const auto seeds = boost::make_iterator_property_map(seed_of_face.begin(),
                                                       get(CGAL::face_index, mesh));
  const double seeding = median_seconds(5, [&] {
    auto copy = segmenter;
    copy.set_seeds(seeds);
  });
  std::cout << name << ", " << num_faces(mesh) << " faces: preparing " << 1e3 * preparing
            << " ms; writing a map " << 1e3 * writing << " ms, the slowest of 2 to 40 segments "
            << slowest / writing
            << " times that, labels of segment(): " << (is_equal ? "equal" : "DIFFERENT")
            << "; of preparing, a drawn loop takes " << (drawing - copying) / preparing
            << ", seeds " << (seeding - copying) / preparing << '\n';
}

} // namespace

int main(int argc, char* argv[])
{
  const std::size_t wanted = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;
  const Mesh mesh = make_mesh(subdivided(speed_benchmark::wavy_torus(wanted / 4)));
  measure("learned", mesh, RS::Learned_merging());
  measure("two-step", mesh, RS::Two_step());
}
