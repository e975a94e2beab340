// SPDX-License-Identifier: GPL-3.0-or-later

#include "Score.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>

#include <limits>
#include <ostream>

namespace princeton_benchmark {

void write_header_of_scores(std::ostream& out)
{
  out << "way,number,collection,category,model,k,segments,seconds,person,person_segments,"
         "rand_index_distance,cut_discrepancy,hamming_distance,gce,lce\n";
}

void write_score(std::ostream& out, const Model_source& source, const Model& model,
                 const Segmentation& segmentation, std::size_t person,
                 const std::vector<double>& measures)
{
  out.precision(9);
  out << segmentation.way << ',' << segmentation.number << ',' << source.collection << ','
      << source.category << ',' << source.name << ',' << model.number_of_segments << ','
      << segmentation.number_of_segments << ',' << segmentation.seconds << ',' << person << ','
      << model.people[person].number_of_segments;
  for (const double value : measures)
    out << ',' << value;
  out << '\n';
}

std::vector<double> compare(const Mesh& mesh, const std::vector<int>& labels, const Person& person)
{
  namespace RS = CGAL::Region_segmentation;
  const auto a = face_map(mesh, labels);
  const auto b = face_map(mesh, person.labels);
  const RS::Consistency_error error = RS::consistency_error(mesh, a, b);
  return {RS::rand_index_distance(mesh, a, b),
          RS::cut_discrepancy(mesh, a, b).value_or(std::numeric_limits<double>::quiet_NaN()),
          RS::hamming_distance(mesh, a, b).distance, error.global, error.local};
}

} // namespace princeton_benchmark
