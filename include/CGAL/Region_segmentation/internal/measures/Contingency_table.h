// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_CONTINGENCY_TABLE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_CONTINGENCY_TABLE_H

#include <CGAL/Region_segmentation/internal/support/read_face_labels.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The number of a set of faces.
struct Face_count
{
  std::uint64_t count = 0;

  void add(double) { ++count; }
};

/// The number and the area of a set of faces.
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

/// Replaces the areas if faces are only counted: half the memory.
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
std::vector<typename Areas::Total> segment_totals(const Partition& labels, const Areas& areas)
{
  std::vector<typename Areas::Total> totals(labels.number_of_parts());
  for (std::size_t f = 0; f < labels.size(); ++f)
    totals[labels[f]].add(areas[f]);
  return totals;
}

/// The faces of each label, in order.
inline Grouped_items<Partition::Index> faces_by_label(const Partition& labels)
{
  using Index = Partition::Index;
  Grouped_items<Index> faces(labels.number_of_parts());
  for (Index label : labels)
    faces.count(label);
  faces.end_counting();
  for (std::size_t f = 0; f < labels.size(); ++f)
    faces.add(labels[f], Index(f));
  return faces;
}

/// The cells of a table that is small enough to be stored, and to stay in the cache.
template <typename Areas, typename Visit>
void for_each_cell_of_small_table(const Partition& rows, const Partition& columns,
                                  const Areas& areas, Visit visit)
{
  const std::size_t width = columns.number_of_parts();
  std::vector<typename Areas::Total> table(rows.number_of_parts() * width);
  for (std::size_t f = 0; f < rows.size(); ++f)
    table[rows[f] * width + columns[f]].add(areas[f]);
  for (std::size_t i = 0; i < rows.number_of_parts(); ++i)
    for (std::size_t j = 0; j < width; ++j)
      if (table[i * width + j].count > 0)
        visit(i, j, table[i * width + j]);
}

/// The cells of a table of any size, a row at a time: O(F) for any number of labels.
template <typename Areas, typename Visit>
void for_each_cell_by_rows(const Partition& rows, const Partition& columns,
                           const Areas& areas, Visit visit)
{
  using Index = Partition::Index;
  const Grouped_items<Index> faces = faces_by_label(rows);
  std::vector<typename Areas::Total> row(columns.number_of_parts()); // all 0 between two rows
  std::vector<Index> columns_met;
  for (std::size_t i = 0; i < rows.number_of_parts(); ++i) {
    columns_met.clear();
    for (Index f : faces[i]) {
      const Index j = columns[f];
      if (row[j].count == 0)
        columns_met.push_back(j);
      row[j].add(areas[f]);
    }
    for (Index j : columns_met) {
      visit(i, std::size_t(j), row[j]);
      row[j] = {};
    }
  }
}

/// Calls `visit(i, j, total)` for each cell of the contingency table of two labelings that is not
/// empty: n_ij faces, of area a_ij, have label i in the first and j in the second. The order
/// depends only on the segments. O(F) time and memory.
template <typename Areas, typename Visit>
void for_each_cell(const Partition& rows, const Partition& columns, const Areas& areas,
                   Visit visit)
{
  CGAL_precondition(rows.size() == columns.size());
  constexpr std::uint64_t largest_small_table = 1 << 14;
  const std::uint64_t size = std::uint64_t(rows.number_of_parts()) * columns.number_of_parts();
  if (size <= (std::min<std::uint64_t>)(largest_small_table, rows.size()))
    for_each_cell_of_small_table(rows, columns, areas, visit);
  else
    for_each_cell_by_rows(rows, columns, areas, visit);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_CONTINGENCY_TABLE_H
