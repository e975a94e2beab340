// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/reduce_colors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace segment_mesh {

namespace {

struct Counted_color
{
  Color color;
  std::size_t count;
};
using Histogram = std::vector<Counted_color>;

/// A range of the histogram.
struct Box
{
  Histogram::iterator begin, end;
  std::size_t channel = 0; ///< the one with the largest spread
  double spread = 0;       ///< weighted by the root of the number of pixels; 0 for a single color
};

Box make_box(Histogram::iterator begin, Histogram::iterator end)
{
  Box box{begin, end};
  std::size_t pixels = 0, widest = 0;
  for (auto c = begin; c != end; ++c)
    pixels += c->count;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto range = std::minmax_element(
        begin, end, [j](const auto& a, const auto& b) { return a.color[j] < b.color[j]; });
    const std::size_t spread = std::size_t(range.second->color[j] - range.first->color[j]);
    if (spread > widest) {
      widest = spread;
      box.channel = j;
    }
  }
  box.spread = double(widest) * std::sqrt(double(pixels));
  return box;
}

/// Where half of the pixels are before; both sides get a color.
Histogram::iterator median(const Box& box)
{
  std::size_t pixels = 0, before = 0;
  for (auto c = box.begin; c != box.end; ++c)
    pixels += c->count;
  auto cut = box.begin;
  while (cut + 1 != box.end && (cut == box.begin || 2 * before < pixels))
    before += (cut++)->count;
  return cut;
}

Color mean_color(const Box& box)
{
  std::array<std::size_t, 3> sums = {0, 0, 0};
  std::size_t pixels = 0;
  for (auto c = box.begin; c != box.end; ++c) {
    pixels += c->count;
    for (std::size_t j = 0; j < 3; ++j)
      sums[j] += c->count * c->color[j];
  }
  Color mean;
  for (std::size_t j = 0; j < 3; ++j)
    mean[j] = std::uint8_t((sums[j] + pixels / 2) / pixels);
  return mean;
}

std::vector<Box> cut_into_boxes(Histogram& histogram, std::size_t number_of_boxes)
{
  std::vector<Box> boxes = {make_box(histogram.begin(), histogram.end())};
  while (boxes.size() < number_of_boxes) {
    const auto widest = std::max_element(
        boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.spread < b.spread; });
    if (widest->spread == 0)
      break;
    const Box box = *widest;
    std::sort(box.begin, box.end, [&](const Counted_color& a, const Counted_color& b) {
      return a.color[box.channel] != b.color[box.channel]
                 ? a.color[box.channel] < b.color[box.channel]
                 : a.color < b.color;
    });
    const auto cut = median(box);
    *widest = make_box(box.begin, cut);
    boxes.push_back(make_box(cut, box.end));
  }
  return boxes;
}

} // namespace

void reduce_colors(Image& image, std::size_t number_of_colors)
{
  std::map<Color, std::size_t> counts;
  for (const Color& c : image.pixels)
    ++counts[c];
  if (counts.size() <= number_of_colors)
    return;
  Histogram histogram;
  for (const auto& entry : counts)
    histogram.push_back({entry.first, entry.second});
  std::map<Color, Color> replacements;
  for (const Box& box : cut_into_boxes(histogram, number_of_colors)) {
    const Color mean = mean_color(box);
    for (auto c = box.begin; c != box.end; ++c)
      replacements[c->color] = mean;
  }
  for (Color& c : image.pixels)
    c = replacements.at(c);
}

} // namespace segment_mesh
