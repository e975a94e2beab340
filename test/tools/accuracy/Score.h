// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_H

#include "models.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// A segmentation of a model, whatever made it.
struct Segmentation
{
  std::string way;                ///< a method or a training
  std::string number;             ///< where the number of segments comes from: "given", "chosen"
  std::size_t number_of_segments; ///< of the segmentation
  double seconds;                 ///< processor time; 0: not measured
};

/// The names of the columns of the table that `tables.py` reads.
void write_header_of_scores(std::ostream& out);

/// Writes a line: the comparison of a segmentation with that by a person.
/// `measures`: the Rand index distance, and maybe cut discrepancy (not a number where it is not
/// defined), Hamming distance, global and local consistency error
void write_score(std::ostream& out, const Model_source& source, const Model& model,
                 const Segmentation& segmentation, std::size_t person,
                 const std::vector<double>& measures);

/// Compares labels of the faces with those by a person in all measures.
std::vector<double> compare(const Mesh& mesh, const std::vector<int>& labels, const Person& person);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_H
