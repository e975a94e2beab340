// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures as files.

#include "view/write_png.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace segment_mesh {
namespace write_png_test {

TEST(Write_png, is_one_of_three_channels)
{
  std::ostringstream out;
  write_png(Image(300, 2, {250, 240, 230}), out);
  EXPECT_EQ(out.str().substr(1, 3), "PNG");
  EXPECT_EQ(int(out.str().at(25)), 2);
}

TEST(Write_png, an_image_without_pixels_is_refused)
{
  std::ostringstream out;
  EXPECT_THROW(write_png(Image(0, 0, {}), out), std::runtime_error);
}

} // namespace write_png_test
} // namespace segment_mesh
