// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures as files: few colors take few bytes.

#include "view/reduce_colors.h"
#include "view/write_png.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace segment_mesh {
namespace write_png_test {

constexpr Color background = {250, 240, 230};

TEST(Write_png, has_a_palette_where_that_is_enough)
{
  const auto color_type = [](const Image& image) {
    std::ostringstream out;
    write_png(image, out);
    EXPECT_EQ(out.str().substr(1, 3), "PNG");
    return int(out.str().at(25));
  };
  Image image(300, 2, background);
  EXPECT_EQ(color_type(image), 3);
  for (std::size_t x = 0; x < 300; ++x)
    image.at(x, 0) = {std::uint8_t(x), std::uint8_t(x / 2), 0};
  EXPECT_EQ(color_type(image), 2);
  reduce_colors(image, 256);
  EXPECT_EQ(color_type(image), 3);
}

TEST(Write_png, an_image_without_pixels_is_refused)
{
  std::ostringstream out;
  EXPECT_THROW(write_png(Image(), out), std::runtime_error);
}

TEST(Reduce_colors, keeps_few_colors_and_stays_near_many)
{
  Image few(16, 16, background);
  few.at(3, 3) = {0, 0, 0};
  const std::vector<Color> before = few.pixels;
  reduce_colors(few, 2);
  EXPECT_EQ(few.pixels, before);

  Image many(256, 4, background);
  for (std::size_t x = 0; x < 256; ++x)
    many.at(x, 1) = {std::uint8_t(x), std::uint8_t(x), std::uint8_t(x)};
  const Image original = many;
  reduce_colors(many, 33);
  EXPECT_LE(std::set<Color>(many.pixels.begin(), many.pixels.end()).size(), 33u);
  for (std::size_t i = 0; i < many.pixels.size(); ++i)
    EXPECT_NEAR(many.pixels[i][0], original.pixels[i][0], 12) << i;
}

} // namespace write_png_test
} // namespace segment_mesh
