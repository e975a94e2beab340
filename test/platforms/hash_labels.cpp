// SPDX-License-Identifier: GPL-3.0-or-later
//
// hash_labels [FILE.off]...: prints a line for each mesh and method: `MESH METHOD HASH`, where the
// method `mesh` is the input itself. The meshes are procedural models and those of the files. Equal
// lines are equal labels, of a chosen and of given numbers.

#include "io/errors.h"
#include "io/read_soup.h"
#include "models/machine_parts.h"
#include "models/procedural_models.h"

#include <CGAL/region_segmentation.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using segment_mesh::Polygon_soup;

namespace {

/// FNV-1a of values as 64 bits, the lowest byte first.
class Hash
{
public:
  void add(std::uint64_t value)
  {
    for (int i = 0; i < 8; ++i, value >>= 8)
      m_state = (m_state ^ (value & 255)) * 0x100000001b3u;
  }
  void add(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits);
  }
  std::uint64_t value() const { return m_state; }

private:
  std::uint64_t m_state = 0xcbf29ce484222325u;
};

void print(const std::string& mesh, const char* method, const Hash& hash)
{
  std::printf("%s %s %016llx\n", mesh.c_str(), method,
              static_cast<unsigned long long>(hash.value()));
  std::fflush(stdout);
}

template <typename Method>
void print_labels(const std::string& name, const Polygon_soup& soup, const char* method_name,
                  const Method& method)
{
  // Two_step takes its order of merges from the number.
  constexpr bool chooses = !std::is_same<Method, RS::Two_step>::value;
  RS::Segmenter segmenter(soup.points, soup.polygons, RS::parameters::method(method));
  std::vector<std::uint64_t> labels(soup.polygons.size());
  Hash hash;
  const auto add = [&](std::size_t number) {
    hash.add(std::uint64_t(number));
    for (std::uint64_t label : labels)
      hash.add(label);
  };
  if constexpr (chooses)
    add(segmenter.segment(labels));
  for (std::size_t k : {2, 5, 12, 40})
    add(segmenter.segment(labels, k));
  print(name, method_name, hash);
}

void print_mesh(const std::string& name, const Polygon_soup& soup)
{
  Hash hash;
  for (const segment_mesh::Point& p : soup.points)
    for (double x : p)
      hash.add(x);
  for (const auto& polygon : soup.polygons)
    for (std::size_t v : polygon)
      hash.add(std::uint64_t(v));
  print(name, "mesh", hash);
  print_labels(name, soup, "learned", RS::Learned_merging());
  print_labels(name, soup, "visibility", RS::Visibility_merging());
  print_labels(name, soup, "two-step", RS::Two_step());
  print_labels(name, soup, "smooth-faces", RS::Smooth_faces());
}

/// Models use sine and cosine, whose last bits belong to the platform: multiples of 2^-24 are mostly
/// the same everywhere.
void print_model(segment_mesh::Labelled_model model)
{
  for (segment_mesh::Point& p : model.soup.points)
    for (double& x : p)
      x = std::ldexp(std::round(std::ldexp(x, 24)), -24);
  print_mesh(model.name, model.soup);
}

void print_file(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  try {
    print_mesh(file.substr(file.rfind('/') + 1), segment_mesh::read_off(file, bytes));
  } catch (const segment_mesh::Input_error& e) { // some are broken by intent
    std::fprintf(stderr, "%s\n", e.what());
  }
}

} // namespace

int main(int argc, char** argv)
{
  for (const segment_mesh::Model_recipe& recipe : segment_mesh::procedural_models())
    print_model(recipe.make({0.5, 1}));
  const auto& parts = segment_mesh::machine_parts();
  for (std::size_t i = 0; i < parts.size(); i += 5)
    print_model(parts[i].make());
  for (int i = 1; i < argc; ++i)
    print_file(argv[i]);
  std::puts("done");
}
