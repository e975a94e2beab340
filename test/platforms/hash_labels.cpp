// SPDX-License-Identifier: GPL-3.0-or-later
//
// hash_labels FILE.off...: prints a line `FILE METHOD HASH` for each mesh and each method, and
// `done` after the last. Equal lines are equal labels, of a chosen and of given numbers. Files in
// which there is more than points and polygons are left out.

#include "../Digest.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/region_segmentation.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
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

/// Decimal numbers are read with correct rounding everywhere.
bool read_off(const std::string& file, Mesh& mesh)
{
  std::ifstream in(file);
  std::string magic;
  std::size_t number_of_points = 0, number_of_polygons = 0, number_of_edges = 0, size = 0;
  in >> magic >> number_of_points >> number_of_polygons >> number_of_edges;
  if (!in || magic != "OFF")
    return false;
  mesh.name = file.substr(file.rfind('/') + 1);
  mesh.points.resize(number_of_points);
  for (auto& p : mesh.points)
    in >> p[0] >> p[1] >> p[2];
  for (std::size_t i = 0; i < number_of_polygons && in >> size; ++i) {
    mesh.polygons.emplace_back(size);
    for (std::size_t& v : mesh.polygons.back())
      if (!(in >> v) || v >= number_of_points)
        return false;
  }
  return bool(in) && (in >> magic).eof();
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
  for (int i = 1; i < argc; ++i) {
    Mesh mesh;
    if (!read_off(argv[i], mesh))
      continue;
    print_labels(mesh, "learned", RS::Learned_merging());
    print_labels(mesh, "visibility", RS::Visibility_merging());
    print_labels(mesh, "two-step", RS::Two_step());
    print_labels(mesh, "smooth-faces", RS::Smooth_faces());
  }
  std::puts("done");
}
