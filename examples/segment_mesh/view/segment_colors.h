// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_COLORS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_COLORS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace segment_mesh {

/// Red, green, blue.
using Color = std::array<std::uint8_t, 3>;

/// A color from hue in turns, saturation and value, each in [0, 1].
inline Color color_from_hsv(double hue, double saturation, double value)
{
  const auto channel = [=](double offset) {
    const double h = std::fmod(hue * 6 + offset, 6.0);
    const double ramp = std::fmax(0.0, std::fmin(std::fmin(h, 4 - h), 1.0));
    return std::uint8_t(std::lround(255 * value * (1 - saturation * ramp)));
  };
  return {channel(5), channel(3), channel(1)};
}

/// What colors tell apart: segments, or the kinds of their surfaces, of which each has the color of
/// its number, from planes on.
enum class Coloring { SEGMENTS, KINDS };

/// The number of the color of segments of several faces: grey.
constexpr std::size_t color_of_no_kind = 9;

/// The color of a segment, dark grey for faces of none, the same in every output and on every
/// machine. Of the first twelve any two differ by at least 32 in CIELAB; further ones step round
/// the hues by the golden ratio.
inline Color segment_color(std::size_t segment)
{
  constexpr Color first[] = {{68, 119, 170},  {238, 102, 119}, {34, 136, 51},   {204, 187, 68},
                             {102, 204, 238}, {170, 51, 119},  {170, 136, 255}, {170, 102, 0},
                             {170, 238, 136}, {187, 187, 187}, {0, 68, 170},    {255, 204, 255}};
  if (segment == std::size_t(-1))
    return {96, 96, 96};
  constexpr std::size_t number_of_first = std::size(first);
  if (segment < number_of_first)
    return first[segment];
  const std::size_t i = segment - number_of_first;
  const double golden_ratio = 0.6180339887498949;
  const double saturations[] = {0.55, 0.85, 0.4}, values[] = {0.95, 0.7, 0.85};
  return color_from_hsv(std::fmod(double(i) * golden_ratio, 1.0), saturations[i % 3],
                        values[(i / 3) % 3]);
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_COLORS_H
