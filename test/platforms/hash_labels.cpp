// SPDX-License-Identifier: GPL-3.0-or-later
//
// hash_labels MESHES STEP: prints a line `MESH METHOD HASH` for each STEP-th mesh of a file of
// write_meshes and each method, and `done` after the last. Equal lines are equal labels, of a
// chosen and of given numbers.

#include "../Digest.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/region_segmentation.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace {

struct Mesh
{
  std::string name;
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> polygons;
};

std::istream& operator>>(std::istream& in, Mesh& mesh)
{
  std::size_t number_of_points = 0, number_of_polygons = 0, number_of_corners = 0;
  in >> std::hex >> mesh.name >> number_of_points >> number_of_polygons;
  mesh.points.resize(number_of_points);
  for (auto& p : mesh.points)
    for (double& x : p) {
      std::uint64_t bits = 0;
      in >> bits;
      std::memcpy(&x, &bits, sizeof x);
    }
  mesh.polygons.resize(number_of_polygons);
  for (auto& polygon : mesh.polygons) {
    in >> number_of_corners;
    polygon.resize(number_of_corners);
    for (std::size_t& v : polygon)
      in >> v;
  }
  return in;
}

template <typename Method>
void print_labels(const Mesh& mesh, const char* method_name, const Method& method)
{
  // Two_step takes its order of merges from the number.
  constexpr bool chooses = !std::is_same<Method, RS::Two_step>::value;
  RS::Polygon_soup_segmenter segmenter(mesh.points, mesh.polygons, RS::parameters::method(method));
  std::vector<std::uint64_t> labels(mesh.polygons.size());
  test::Digest digest;
  const auto add = [&](std::size_t number) {
    digest.add(number);
    for (std::uint64_t label : labels)
      digest.add(label);
  };
  if constexpr (chooses)
    add(segmenter.segment(labels));
  for (std::size_t k : {2, 5, 12, 40})
    add(segmenter.segment(labels, k));
  std::printf("%s %s %016llx\n", mesh.name.c_str(), method_name,
              static_cast<unsigned long long>(digest.value()));
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3)
    return 2;
  const int step = std::atoi(argv[2]);
  std::ifstream in(argv[1]);
  int number = 0;
  for (Mesh mesh; in >> mesh; ++number) {
    if (number % step != 0)
      continue;
    print_labels(mesh, "learned", RS::Learned_merging());
    print_labels(mesh, "visibility", RS::Visibility_merging());
    print_labels(mesh, "two-step", RS::Two_step());
    print_labels(mesh, "smooth-faces", RS::Smooth_faces());
  }
  std::puts("done");
}
