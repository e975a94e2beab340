// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much the labels of copies of a mesh differ by the default method: renumbered, moved, written
// with fewer digits, with noise in the last digits. A line of CSV for each copy.

#include "copies.h"

#include <CGAL/Region_segmentation/Evaluation/overlap_measures.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace princeton_benchmark {

namespace {

namespace RS = CGAL::Region_segmentation;

struct Segmentations
{
  std::vector<std::size_t> given, chosen;
  std::size_t number; ///< that is chosen
};

Segmentations segmentations(const Soup& soup, std::size_t k, const RS::Learned_merging& method)
{
  const RS::Polygon_soup_segmenter<RS::Learned_merging> segmenter(soup.points, soup.triangles,
                                                                  RS::parameters::method(method));
  const std::vector<std::size_t> labels(soup.triangles.size());
  Segmentations result{labels, labels, 0};
  segmenter.segment(result.given, k);
  result.number = segmenter.segment(result.chosen);
  return result;
}

/// Between the labels of a mesh and of its copy.
double distance(const std::vector<std::size_t>& labels, const Copy& copy,
                const std::vector<std::size_t>& labels_of_copy)
{
  std::vector<std::size_t> expected;
  for (const std::size_t face : copy.source)
    expected.push_back(labels[face]);
  return RS::rand_index_distance(expected, labels_of_copy);
}

void compare_copies(const Model_source& source, const RS::Learned_merging& method)
{
  const Model model = source.load();
  const std::size_t k = model.number_of_segments;
  const Segmentations original = segmentations(model.soup, k, method);
  for (const Copying& kind : equal_copies()) {
    const Copy copy = kind.copy(model, unsigned(source.number));
    const Segmentations of_copy = segmentations(copy.soup, k, method);
    std::cout << kind.name << ',' << source.name << ',' << method.number_of_draws << ','
              << distance(original.given, copy, of_copy.given) << ','
              << distance(original.chosen, copy, of_copy.chosen) << ',' << original.number << ','
              << of_copy.number << '\n';
  }
}

int run_program(int argc, char** argv)
{
  std::string folder;
  std::size_t step = 1;
  RS::Learned_merging method;
  CLI::App app("Compares the labels of copies of meshes. Writes CSV to stdout, for tables.py.",
               "label_stability");
  app.add_option("--data", folder, "The Princeton benchmark in its own layout")
    ->required()
    ->check(CLI::ExistingDirectory);
  app.add_option("--every", step, "One of so many models")->check(CLI::Range(1, 1000));
  app.add_option("--draws", method.number_of_draws, "Of the method")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  const std::vector<Model_source> sources = find_models(folder, {});
  std::cout << "copy,model,draws,given,chosen,number,number_of_copy\n";
  for (std::size_t i = 0; i < sources.size(); i += step)
    compare_copies(sources[i], method);
  return 0;
}

} // namespace

} // namespace princeton_benchmark

int main(int argc, char** argv)
{
  try {
    return princeton_benchmark::run_program(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "label_stability: " << error.what() << "\n";
    return 1;
  }
}
