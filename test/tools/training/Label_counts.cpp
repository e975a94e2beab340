// SPDX-License-Identifier: GPL-3.0-or-later

#include "Label_counts.h"

#include <algorithm>

namespace train_merge_cost {

namespace {

double pairs_in(double n)
{
  return n * (n - 1) / 2;
}

} // namespace

Label_counts::Label_counts(const std::vector<std::size_t>& region_of, std::size_t number_of_regions,
                           const std::vector<std::vector<int>>& people)
  : m_first_column{0}
  , m_faces(number_of_regions)
  , m_pairs(pairs_in(double(region_of.size())))
{
  for (const std::vector<int>& labels : people)
    m_first_column.push_back(m_first_column.back() + 1 +
                             std::size_t(*std::max_element(labels.begin(), labels.end())));
  m_counts.resize(number_of_regions * m_first_column.back());
  for (std::size_t f = 0; f < region_of.size(); ++f) {
    ++m_faces[region_of[f]];
    for (std::size_t i = 0; i < people.size(); ++i)
      ++row(region_of[f])[m_first_column[i] + std::size_t(people[i][f])];
  }
}

double Label_counts::probability(std::size_t a, std::size_t b) const
{
  const double *row_a = row(a), *row_b = row(b);
  double sum = 0;
  for (std::size_t j = 0; j < m_first_column.back(); ++j)
    sum += row_a[j] * row_b[j];
  return sum / (double(number_of_people()) * m_faces[a] * m_faces[b]);
}

void Label_counts::merge(std::size_t kept, std::size_t removed)
{
  m_faces[kept] += m_faces[removed];
  m_faces[removed] = 0;
  double *to = row(kept), *from = row(removed);
  for (std::size_t j = 0; j < m_first_column.back(); ++j) {
    to[j] += from[j];
    from[j] = 0;
  }
}

std::vector<double> Label_counts::distances() const
{
  double in_regions = 0;
  for (double n : m_faces)
    in_regions += pairs_in(n);
  std::vector<double> result;
  for (std::size_t i = 0; i < number_of_people(); ++i) {
    double in_both = 0, in_labels = 0;
    for (std::size_t j = m_first_column[i]; j < m_first_column[i + 1]; ++j) {
      double faces = 0;
      for (std::size_t r = 0; r < m_faces.size(); ++r) {
        faces += row(r)[j];
        if (m_faces[r] > 0)
          in_both += pairs_in(row(r)[j]);
      }
      in_labels += pairs_in(faces);
    }
    result.push_back((in_regions + in_labels - 2 * in_both) / m_pairs);
  }
  return result;
}

} // namespace train_merge_cost
