// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NUMBER_LABELS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NUMBER_LABELS_H

#include <CGAL/Region_segmentation/internal/support/Key_numbering.h>

#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The numbers of the labels of elements, by their first elements; the highest number for the label
/// -1 of their type, which is none (there is none of `bool`). `label_of` receives the labels by
/// number.
template <typename Label, typename Value>
std::vector<std::uint32_t> number_labels(const std::vector<Label>& labels,
                                         std::vector<Value>& label_of)
{
  std::vector<std::uint32_t> result;
  result.reserve(labels.size());
  Key_numbering number(2 * labels.size() + 1024);
  for (const Label label : labels) {
    const bool is_none = !std::is_same<Label, bool>::value && label == Label(-1);
    result.push_back(is_none ? (std::numeric_limits<std::uint32_t>::max)()
                             : number(static_cast<std::uint64_t>(label)));
    if (label_of.size() < number.size())
      label_of.push_back(Value(label));
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NUMBER_LABELS_H
