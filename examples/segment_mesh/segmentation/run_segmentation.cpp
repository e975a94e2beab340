// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_segmentation.h"

#include "segmentation/smooth_borders.h"

#include <CGAL/Region_segmentation/Segments/no_segment.h>

#include <algorithm>

namespace segment_mesh {

namespace {

using CGAL::Region_segmentation::no_segment;

} // namespace

Segmentation run_segmentation(const Polygon_soup& soup, const Marks& marks,
                              const Segmentation_settings& settings,
                              const Progress_listener& listener)
{
  Segmentation result = run_on_soup(soup, marks, settings, listener);
  if (settings.borders == Border_treatment::SMOOTHING)
    smooth_borders(soup, marks, listener, result);
  return result;
}

Segmentation segmentation_from_labels(const std::vector<std::int64_t>& labels)
{
  std::vector<std::int64_t> different = labels;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  const auto none = std::find(different.begin(), different.end(), std::int64_t(no_segment));
  const bool has_none = none != different.end();
  if (has_none)
    different.erase(none);

  Segmentation result;
  const std::size_t n = different.size();
  result.number_of_segments = n;
  result.number_of_regions = n + has_none;
  for (std::int64_t label : labels) {
    const auto i = std::size_t(std::lower_bound(different.begin(), different.end(), label) -
                               different.begin());
    result.segment_of_face.push_back(label == no_segment ? std::size_t(no_segment) : i);
    result.region_of_face.push_back(label == no_segment ? n : i);
  }
  result.tree = CGAL::Region_segmentation::Merge_tree(result.number_of_regions);
  return result;
}

} // namespace segment_mesh
