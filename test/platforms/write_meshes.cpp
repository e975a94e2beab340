// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_meshes [FILE.off]...: prints meshes for hash_labels: procedural models and those of the
// files. A mesh is its name, its numbers of points and polygons, the coordinates, each as the 64
// bits of a double, and the polygons, each after its number of corners; all numbers are
// hexadecimal.

#include "read/errors.h"
#include "read/read_mesh.h"
#include "models/machine_parts.h"
#include "models/procedural_models.h"

#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

using segment_mesh::Polygon_soup;

namespace {

void print_mesh(const std::string& name, const Polygon_soup& soup)
{
  std::printf("%s %zx %zx\n", name.c_str(), soup.points.size(), soup.polygons.size());
  for (const segment_mesh::Point& p : soup.points)
    for (double x : p) {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      std::printf("%" PRIx64 "\n", bits);
    }
  for (const auto& polygon : soup.polygons) {
    std::printf("%zx", polygon.size());
    for (std::size_t v : polygon)
      std::printf(" %zx", v);
    std::puts("");
  }
}

void print_file(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  try {
    print_mesh(file.substr(file.rfind('/') + 1), segment_mesh::read_off(file, bytes).soup);
  } catch (const segment_mesh::Input_error& e) { // some are broken by intent
    std::fprintf(stderr, "%s\n", e.what());
  }
}

} // namespace

int main(int argc, char** argv)
{
  const auto& recipes = segment_mesh::procedural_models();
  for (std::size_t i = 0; i < recipes.size(); i += 2)
    print_mesh(recipes[i].name, recipes[i].make({0.5, 1}).soup);
  const auto& parts = segment_mesh::machine_parts();
  for (std::size_t i = 0; i < parts.size(); i += 5)
    print_mesh(parts[i].name, parts[i].make().soup);
  for (int i = 1; i < argc; ++i)
    print_file(argv[i]);
}
