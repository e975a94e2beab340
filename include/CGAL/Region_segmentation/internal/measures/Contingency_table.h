// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_CONTINGENCY_TABLE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_CONTINGENCY_TABLE_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Key_numbering.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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

/// The table of two partitions of the faces: n_ij faces, of area a_ij, are in part i of the first
/// and part j of the second; n_i. and n_.j, a_i. and a_.j are the totals of its rows and columns.
///
/// Areas are added by faces in order everywhere. Rounding is monotone, so a cell is never above its
/// row or its column, and equal to it where it has all of its faces: a_i. - a_ij is never negative,
/// and 0 where it should be.
struct Contingency_table
{
  struct Cell
  {
    Partition::Index row, column;
    Face_total total;
  };
  std::vector<Face_total> rows, columns;
  std::vector<Cell> cells; // those that are not empty, by their first faces

  /// `area(face)`: of each face. O(F) time and memory.
  template <typename Area>
  Contingency_table(const Partition& a, const Partition& b, const Area& area)
    : rows(a.number_of_parts())
    , columns(b.number_of_parts())
  {
    CGAL_precondition(a.size() == b.size());
    Key_numbering number(2 * a.size() + 1024);
    for (std::size_t f = 0; f < a.size(); ++f) {
      const std::size_t cell = number(a[f] * std::uint64_t(columns.size()) + b[f]);
      if (cell == cells.size())
        cells.push_back({a[f], b[f], {}});
      for (Face_total* total : {&rows[a[f]], &columns[b[f]], &cells[cell].total})
        total->add(area(f));
    }
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_CONTINGENCY_TABLE_H
