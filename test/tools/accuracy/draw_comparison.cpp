// SPDX-License-Identifier: GPL-3.0-or-later

#include "draw_comparison.h"

#include "view/choose_viewpoint.h"
#include "view/render_view.h"
#include "view/write_png.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace princeton_benchmark {

using segment_mesh::Image;

namespace {

Image side_by_side(const Image& left, const Image& right)
{
  Image both(left.width + right.width, left.height, {255, 255, 255});
  for (std::size_t y = 0; y < both.height; ++y)
    for (std::size_t x = 0; x < both.width; ++x)
      both.at(x, y) = x < left.width ? left.at(x, y) : right.at(x - left.width, y);
  return both;
}

} // namespace

std::vector<std::size_t> match_labels(const std::vector<int>& result, const std::vector<int>& truth)
{
  std::map<std::pair<int, int>, std::size_t> faces_in_common;
  for (std::size_t f = 0; f < result.size(); ++f)
    ++faces_in_common[{result[f], truth[f]}];
  std::vector<std::pair<std::size_t, std::pair<int, int>>> pairs;
  for (const auto& entry : faces_in_common)
    pairs.push_back({entry.second, entry.first});
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });

  std::map<int, std::size_t> name_of_label;
  std::set<int> taken;
  std::size_t next_name = 0;
  for (const auto& pair : pairs) {
    const auto [of_result, of_truth] = pair.second;
    next_name = (std::max)(next_name, std::size_t(of_result) + 1);
    if (taken.count(of_result) == 0 && name_of_label.emplace(of_truth, of_result).second)
      taken.insert(of_result);
  }
  std::vector<std::size_t> names;
  for (int label : truth) {
    const auto entry = name_of_label.emplace(label, next_name);
    next_name += entry.second;
    names.push_back(entry.first->second);
  }
  return names;
}

Picture draw_comparison(const segment_mesh::Polygon_soup& soup, const std::vector<int>& result,
                        const std::vector<int>& truth)
{
  segment_mesh::View_options options;
  options.width = 280;
  options.height = 220;
  const std::vector<std::size_t> labels(result.begin(), result.end());
  options.viewpoint = segment_mesh::choose_viewpoint(soup, labels);
  Image image = side_by_side(
    segment_mesh::render_view(soup, labels, {}, options),
    segment_mesh::render_view(soup, match_labels(result, truth), {}, options));
  for (segment_mesh::Color& color : image.pixels) // in steps of 8, which takes a third of the bytes
    for (std::uint8_t& channel : color)
      channel |= 7;
  std::ostringstream png;
  segment_mesh::write_png(image, png);
  return {png.str(), image.width, image.height};
}

} // namespace princeton_benchmark
