// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CONTINGENCY_TABLE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CONTINGENCY_TABLE_H

#include <CGAL/Region_segmentation/internal/Dense_labels.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The number of some faces.
struct Face_count
{
  std::uint64_t count = 0;

  void add(double) { ++count; }
};

/// The number and the area of some faces.
struct Face_total
{
  std::uint64_t count = 0;
  double area = 0;

  void add(double face_area)
  {
    ++count;
    area += face_area;
  }
};

/// The areas of the faces, by iteration order.
struct Face_areas
{
  using Total = Face_total;
  std::vector<double> of_face;

  double operator[](std::size_t face) const { return of_face[face]; }
};

/// Stands for the areas where faces are only counted: half the memory.
struct No_areas
{
  using Total = Face_count;

  double operator[](std::size_t) const { return 0; }
};

/// n_i. and a_i.: the total of each segment. Areas are added by faces in order, here as in the
/// cells of the table. Rounding is monotone, so a cell is never above its row or its column, and
/// equal to it where it has all of its faces: a_i. - a_ij is never negative, and 0 where it should
/// be.
template <typename Areas>
std::vector<typename Areas::Total> segment_totals(const Dense_labels& labels, const Areas& areas)
{
  std::vector<typename Areas::Total> totals(labels.number_of_labels);
  for (std::size_t f = 0; f < labels.of_face.size(); ++f)
    totals[labels.of_face[f]].add(areas[f]);
  return totals;
}

/// The faces sorted by their label, those of one label in order, and where each label starts.
class Faces_by_label
{
public:
  using Index = Dense_labels::Index;

  explicit Faces_by_label(const Dense_labels& labels)
      : m_starts(labels.number_of_labels + 2), m_faces(labels.of_face.size())
  {
    // m_starts[i + 2] counts label i, then holds its end; filling moves m_starts[i + 1] from the
    // label's start to its end, which is the start of the next one.
    for (Index label : labels.of_face)
      ++m_starts[label + 2];
    for (std::size_t i = 2; i < m_starts.size(); ++i)
      m_starts[i] += m_starts[i - 1];
    for (std::size_t f = 0; f < labels.of_face.size(); ++f)
      m_faces[m_starts[labels.of_face[f] + 1]++] = Index(f);
  }

  const Index* begin(std::size_t label) const { return m_faces.data() + m_starts[label]; }
  const Index* end(std::size_t label) const { return m_faces.data() + m_starts[label + 1]; }

private:
  std::vector<Index> m_starts;
  std::vector<Index> m_faces;
};

/// The cells of a table that is small enough to be stored, and to stay in the cache.
template <typename Areas, typename Visit>
void for_each_cell_of_small_table(const Dense_labels& rows, const Dense_labels& columns,
                                  const Areas& areas, Visit visit)
{
  const std::size_t width = columns.number_of_labels;
  std::vector<typename Areas::Total> table(rows.number_of_labels * width);
  for (std::size_t f = 0; f < rows.of_face.size(); ++f)
    table[rows.of_face[f] * width + columns.of_face[f]].add(areas[f]);
  for (std::size_t i = 0; i < rows.number_of_labels; ++i)
    for (std::size_t j = 0; j < width; ++j)
      if (table[i * width + j].count > 0)
        visit(i, j, table[i * width + j]);
}

/// The cells of a table of any size, a row at a time: O(F), however many labels there are.
template <typename Areas, typename Visit>
void for_each_cell_by_rows(const Dense_labels& rows, const Dense_labels& columns,
                           const Areas& areas, Visit visit)
{
  using Index = Dense_labels::Index;
  const Faces_by_label faces(rows);
  std::vector<typename Areas::Total> row(columns.number_of_labels); // all 0 between two rows
  std::vector<Index> columns_met;
  for (std::size_t i = 0; i < rows.number_of_labels; ++i) {
    columns_met.clear();
    for (const Index* f = faces.begin(i); f != faces.end(i); ++f) {
      const Index j = columns.of_face[*f];
      if (row[j].count == 0)
        columns_met.push_back(j);
      row[j].add(areas[*f]);
    }
    for (Index j : columns_met) {
      visit(i, std::size_t(j), row[j]);
      row[j] = {};
    }
  }
}

/// Calls `visit(i, j, total)` for each cell of the contingency table of two labelings that is not
/// empty: n_ij faces, of area a_ij, have label i in the first and j in the second. The order
/// depends on the segments alone. O(F) time and memory.
template <typename Areas, typename Visit>
void for_each_cell(const Dense_labels& rows, const Dense_labels& columns, const Areas& areas,
                   Visit visit)
{
  CGAL_precondition(rows.of_face.size() == columns.of_face.size());
  constexpr std::uint64_t largest_small_table = 1 << 14;
  const std::uint64_t size = std::uint64_t(rows.number_of_labels) * columns.number_of_labels;
  if (size <= (std::min<std::uint64_t>)(largest_small_table, rows.of_face.size()))
    for_each_cell_of_small_table(rows, columns, areas, visit);
  else
    for_each_cell_by_rows(rows, columns, areas, visit);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CONTINGENCY_TABLE_H
