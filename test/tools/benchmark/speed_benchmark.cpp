// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the speed and the memory of methods and stages, of the library and of others, against
// one pass of `PMP::compute_face_normals`, the floor: a line of CSV for each number. See
// doc/performance.md.

#include "seconds.h"
#include "subjects.h"

#include "allocated_bytes.h"

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace speed_benchmark;

struct Options
{
  std::string meshes;
  std::vector<std::string> shapes = {"smooth", "noisy", "loop", "shuffled", "torus"}, names;
  std::vector<std::size_t> sizes = {160000, 1000000, 4000000};
  std::size_t rounds = 3;
  std::size_t threads = std::thread::hardware_concurrency();
};

void add_options(CLI::App& app, Options& options)
{
  app.add_option("--meshes", options.meshes, "Folder of the meshes of CGAL's demos");
  app.add_option("--shapes", options.shapes, "smooth, noisy, loop, shuffled, torus")
    ->delimiter(',');
  app.add_option("--sizes", options.sizes, "Numbers of faces, about")->delimiter(',');
  app.add_option("--what", options.names, "What is measured; default: all")->delimiter(',');
  app.add_option("--rounds", options.rounds, "At least 1")->check(CLI::Range(1, 1000));
  app.add_option("--threads", options.threads, "Of the parallel runs; 1: there are none")
    ->check(CLI::Range(1, 1000));
}

/// Writes lines of the table that `tables.py` reads: times and bytes are those of a face.
class Lines
{
public:
  Lines(const std::string& shape, std::size_t faces, const Subject& subject)
    : m_head(shape + "," + std::to_string(faces) + "," + std::to_string(subject.threads) + "," +
             subject.name + ",")
    , m_faces(double(faces))
  {}

  void write(std::size_t round, const std::string& quantity, double value) const
  {
    std::cout << m_head << round << ',' << quantity << ',' << value / m_faces << std::endl;
  }

private:
  std::string m_head;
  double m_faces;
};

/// Once without timing, with the memory counted; then the floor and the subject in turns.
void measure(const std::string& shape, Input& input, const Subject& subject, std::size_t rounds)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, subject.threads);
  const Lines lines(shape, input.triangles.corners.size(), subject);
  lines.write(0, "bytes", double(peak_of_allocated_bytes([&] { subject.run(input); })));
  for (std::size_t round = 1; round <= rounds; ++round) {
    if (subject.threads == 1 && !subject.takes_polygons)
      lines.write(round, "floor", 1e9 * seconds_of_face_normals(input.mesh));
    std::fill(input.is_sharp.begin(), input.is_sharp.end(), std::uint8_t(0)); // CGAL does not
    const Timing timing = subject.run(input);
    for (const auto& [stage, seconds] : timing.stages)
      lines.write(round, stage, 1e9 * seconds);
    lines.write(round, "all", 1e9 * timing.seconds);
  }
}

void measure_all(const Options& options)
{
  std::vector<Subject> wanted;
  for (const Subject& subject : subjects(options.threads))
    if (options.names.empty() ||
        std::count(options.names.begin(), options.names.end(), subject.name) > 0)
      wanted.push_back(subject);
  const bool takes_mesh = std::any_of(wanted.begin(), wanted.end(),
                                      [](const Subject& s) { return !s.takes_polygons; });
  std::cout << "mesh,faces,threads,what,round,quantity,value\n";
  for (const std::size_t size : options.sizes)
    for (const std::string& shape : options.shapes) {
      Input input{make_shape(shape, size, options.meshes), {}, {}, {}};
      if (takes_mesh)
        input.mesh = make_surface_mesh(input.triangles);
      input.ids.resize(input.triangles.corners.size());
      input.is_sharp.resize(num_edges(input.mesh));
      for (const Subject& subject : wanted)
        if (input.ids.size() <= subject.most_faces)
          measure(shape, input, subject, options.rounds);
    }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Measures the speed and the memory of mesh segmentation. Writes CSV to stdout, for "
               "tables.py.",
               "speed_benchmark");
  Options options;
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    measure_all(options);
  } catch (const std::exception& error) {
    std::cerr << "speed_benchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
