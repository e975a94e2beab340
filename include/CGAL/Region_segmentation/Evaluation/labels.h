// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EVALUATION_LABELS_H
#define CGAL_REGION_SEGMENTATION_EVALUATION_LABELS_H

#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <charconv>
#include <cstddef>
#include <istream>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace IO {

/// \ingroup PkgRegionSegmentationIO
/// reads labels in the `.seg` format of the Princeton Segmentation Benchmark: one integer per line,
/// one line per face. Empty lines at the end are ignored.
///
/// \tparam Label an integral type other than `bool`
/// \throws Invalid_input if the stream cannot be read (a missing file), or a line is not an integer
///         that `Label` can represent; the message states the line
template <typename Label = long long>
std::vector<Label> read_labels(std::istream& in)
{
  if (!in)
    throw Invalid_input("the stream of labels cannot be read");
  std::vector<Label> labels;
  std::string line;
  std::size_t first_empty_line = 0;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) {
      first_empty_line = first_empty_line ? first_empty_line : number;
      continue;
    }
    if (first_empty_line)
      throw Invalid_input("line " + std::to_string(first_empty_line) + ": no label");
    const char* end = line.data() + line.find_last_not_of(" \t\r") + 1;
    Label label{};
    const auto result = std::from_chars(line.data() + first, end, label);
    if (result.ec != std::errc() || result.ptr != end)
      throw Invalid_input("line " + std::to_string(number) + ": not a label");
    labels.push_back(label);
  }
  if (in.bad())
    throw Invalid_input("the stream of labels cannot be read to its end");
  return labels;
}

/// \ingroup PkgRegionSegmentationIO
/// reads the labels of the faces of a mesh, in iteration order.
///
/// \throws Invalid_input if `read_labels(in)` does, or if the number of labels is not the number of
///         faces; the map is unchanged
template <typename FaceGraph, typename FaceLabelMap>
void read_labels(std::istream& in, const FaceGraph& mesh, FaceLabelMap label_map)
{
  using Label = typename boost::property_traits<FaceLabelMap>::value_type;
  const std::vector<Label> labels = read_labels<Label>(in);
  const std::size_t number_of_faces = faces(mesh).size(); // num_faces() may count removed ones
  if (labels.size() != number_of_faces)
    throw Invalid_input(std::to_string(labels.size()) + " labels for " +
                        std::to_string(number_of_faces) + " faces");
  write_face_values(mesh, labels, label_map);
}

/// \ingroup PkgRegionSegmentationIO
/// writes the label of every face of a mesh, in iteration order, one per line.
///
/// \returns whether the stream is good
template <typename FaceGraph, typename FaceLabelMap>
bool write_labels(std::ostream& out, const FaceGraph& mesh, FaceLabelMap label_map)
{
  static_assert(internal::check_face_map<FaceLabelMap, FaceGraph>());
  for (auto f : faces(mesh))
    out << +get(label_map, f) << '\n'; // + : a label of one byte is a number, not a character
  return out.good();
}

} // namespace IO
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EVALUATION_LABELS_H
