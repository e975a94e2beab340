// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_SECTION_DESCRIPTOR_H
#define CGAL_REGION_SEGMENTATION_GRAPH_SECTION_DESCRIPTOR_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// A section as seen from one of its two regions. The two views of a section are equal.
class Section_descriptor
{
public:
  Section_descriptor() = default;
  explicit Section_descriptor(std::uint32_t half)
    : m_half(half)
  {}

  /// The index of the section, and of its view.
  std::uint32_t id() const { return m_half / 2; }
  std::uint32_t half() const { return m_half; }

  friend bool operator==(Section_descriptor a, Section_descriptor b) { return a.id() == b.id(); }
  friend bool operator!=(Section_descriptor a, Section_descriptor b) { return a.id() != b.id(); }
  friend bool operator<(Section_descriptor a, Section_descriptor b) { return a.id() < b.id(); }
  friend std::size_t hash_value(Section_descriptor s) { return s.id(); }

private:
  std::uint32_t m_half = (std::numeric_limits<std::uint32_t>::max)();
};

} // namespace Region_segmentation
} // namespace CGAL

namespace std {
template <>
struct hash<CGAL::Region_segmentation::Section_descriptor>
{
  std::size_t operator()(CGAL::Region_segmentation::Section_descriptor s) const { return s.id(); }
};
} // namespace std

#endif // CGAL_REGION_SEGMENTATION_GRAPH_SECTION_DESCRIPTOR_H
