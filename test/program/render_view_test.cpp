// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pictures: what must show does, what must not change does not.

#include "soup/vector_algebra.h"
#include "view/Sample_buffer.h"
#include "view/choose_viewpoint.h"
#include "view/render_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace segment_mesh {
namespace render_view_test {

constexpr Color background = {250, 240, 230};

View_options small_view()
{
  View_options options;
  options.width = 160;
  options.height = 120;
  options.background = background;
  return options;
}

/// Quads in the order -x, +x, -y, +y, -z, +z.
Polygon_soup make_cube()
{
  Polygon_soup soup;
  for (std::size_t i = 0; i < 8; ++i)
    soup.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  soup.polygons = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return soup;
}

const std::vector<std::size_t> cube_labels = {0, 1, 2, 3, 4, 5};

/// From where -z is forward and y is up.
const Viewpoint front = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

std::size_t number_of_pixels(const Image& image, const Color& color)
{
  return std::size_t(std::count(image.pixels.begin(), image.pixels.end(), color));
}

/// Whether a pixel is a shade of a color: its channels are in the same proportion, or mixed with
/// white.
bool is_shade_of(const Color& pixel, const Color& color)
{
  const auto hue = [](const Color& c) {
    const int low = (std::min)({c[0], c[1], c[2]}), high = (std::max)({c[0], c[1], c[2]});
    Point p = {double(c[0] - low), double(c[1] - low), double(c[2] - low)};
    return high > low ? times(1.0 / (high - low), p) : p;
  };
  const Point difference = minus(hue(pixel), hue(color));
  return inner_product(difference, difference) < 0.01;
}

/// The segments whose color covers at least 40 pixels.
std::set<std::size_t> visible_segments(const Image& image, std::size_t number_of_segments)
{
  std::set<std::size_t> result;
  for (std::size_t s = 0; s < number_of_segments; ++s)
    if (std::count_if(image.pixels.begin(), image.pixels.end(),
                      [s](const Color& p) { return is_shade_of(p, segment_color(s)); }) >= 40)
      result.insert(s);
  return result;
}

std::size_t number_of_dark_pixels(const Image& image)
{
  return std::size_t(std::count_if(image.pixels.begin(), image.pixels.end(),
                                   [](const Color& p) { return p[0] + p[1] + p[2] < 150; }));
}

bool is_empty(const Image& image)
{
  return number_of_pixels(image, background) == image.pixels.size();
}

TEST(Render_view, a_cube_shows_three_sides_in_their_colors_with_dark_borders)
{
  const Image image = render_view(make_cube(), cube_labels, small_view());
  const std::set<std::size_t> visible = visible_segments(image, 6);
  EXPECT_EQ(visible.size(), 3u);
  EXPECT_EQ(visible.count(3), 1u) << "it is seen from above";
  EXPECT_GT(number_of_dark_pixels(image), 50u);
}

TEST(Render_view, is_the_same_each_time_whatever_place_and_size)
{
  const Image image = render_view(make_cube(), cube_labels, small_view());
  EXPECT_EQ(image.pixels, render_view(make_cube(), cube_labels, small_view()).pixels);
  Polygon_soup moved = make_cube();
  for (Point& p : moved.points)
    p = {1024 * p[0] + 4096, 1024 * p[1] - 512, 1024 * p[2]}; // without rounding
  EXPECT_EQ(image.pixels, render_view(moved, cube_labels, small_view()).pixels);
}

TEST(Render_view, the_order_of_faces_does_not_matter)
{
  Polygon_soup reversed = make_cube();
  reversed.polygons = {};
  for (std::size_t f = cube_labels.size(); f-- > 0;)
    reversed.polygons.push_back(make_cube().polygons[f]);
  EXPECT_EQ(render_view(make_cube(), cube_labels, small_view()).pixels,
            render_view(reversed, {5, 4, 3, 2, 1, 0}, small_view()).pixels);
}

/// Large triangles that cross each other, each one twice: so their depths are equal.
std::vector<std::vector<Screen_point>> crossing_triangles(std::size_t number)
{
  std::mt19937 random(1);
  const auto uniform = [&random](double size) { return size * double(random()) / 4294967296.0; };
  std::vector<std::vector<Screen_point>> result;
  for (std::size_t f = 0; f < number; f += 2) {
    result.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const double x = uniform(150), y = uniform(40);
      result.back().push_back({x, y, uniform(1), uniform(1)});
    }
    result.push_back(result.back());
  }
  return result;
}

TEST(Sample_buffer, shows_the_nearest_of_faces_drawn_alone_whatever_their_order)
{
  constexpr std::size_t width = 150, height = 40;
  const auto triangles = crossing_triangles(200);
  Sample_buffer upward(width, height), downward(width, height);
  std::vector<Sample_buffer> alone(triangles.size(), Sample_buffer(width, height));
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    upward.draw_polygon(triangles[f], Sample_buffer::Index(f));
    downward.draw_polygon(triangles[triangles.size() - 1 - f],
                          Sample_buffer::Index(triangles.size() - 1 - f));
    alone[f].draw_polygon(triangles[f], Sample_buffer::Index(f));
  }
  for (std::size_t sample = 0; sample < width * height; ++sample) {
    const auto seen = [sample](const Sample_buffer& buffer) {
      return buffer.at(sample % width, sample / width);
    };
    Sample_buffer::Sample nearest;
    for (const Sample_buffer& buffer : alone)
      if (seen(buffer).depth < nearest.depth)
        nearest = seen(buffer);
    for (const Sample_buffer* buffer : {&upward, &downward}) {
      ASSERT_EQ(seen(*buffer).face, nearest.face) << sample;
      ASSERT_EQ(seen(*buffer).depth, nearest.depth) << sample;
      ASSERT_EQ(seen(*buffer).light, nearest.light) << sample;
    }
  }
}

TEST(Render_view, background_is_untouched)
{
  const Image image = render_view(make_cube(), cube_labels, small_view());
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x)
      if (x == 0 || y == 0 || x + 1 == image.width || y + 1 == image.height) {
        EXPECT_EQ(image.at(x, y), background) << x << " " << y;
      }
}

TEST(Render_view, a_side_seen_from_the_front_fills_its_square)
{
  View_options options = small_view();
  options.viewpoint = front;
  const Image image = render_view(make_cube(), cube_labels, options);
  const double side = 120 * 0.92; // the margin is 4 % of the height, on both sides
  const std::size_t drawn = image.pixels.size() - number_of_pixels(image, background);
  EXPECT_NEAR(double(drawn), side * side, 2 * side);
  EXPECT_EQ(visible_segments(image, 6), std::set<std::size_t>{5});
}

TEST(Render_view, what_is_nearer_hides_what_is_behind_it)
{
  Polygon_soup soup;
  for (double z : {0.0, 1.0})
    for (const auto& corner : {Point{0, 0, z}, Point{1, 0, z}, Point{1, 1, z}, Point{0, 1, z}})
      soup.points.push_back(corner);
  soup.polygons = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  View_options options = small_view();
  options.viewpoint = front;
  EXPECT_EQ(visible_segments(render_view(soup, {0, 1}, options), 2), std::set<std::size_t>{1});
}

TEST(Render_view, a_polygon_that_is_not_convex_keeps_its_notch)
{
  Polygon_soup soup;
  soup.points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0},
                 {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  soup.polygons = {{0, 1, 2, 3, 4, 5, 6, 7}};
  View_options options = small_view();
  options.viewpoint = front;
  const Image image = render_view(soup, {0}, options);
  EXPECT_EQ(image.at(image.width / 2, 20), background);
  EXPECT_TRUE(is_shade_of(image.at(image.width / 2, 100), segment_color(0)));
}

TEST(Render_view, faces_that_share_edges_leave_no_gap)
{
  constexpr std::size_t n = 37;
  Polygon_soup soup;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      soup.points.push_back(
        {double(i) + 0.3 * std::sin(double(i * j)), double(j), 0.1 * double(i)});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = i * (n + 1) + j, b = a + n + 1;
      soup.polygons.push_back({a, b, b + 1});
      soup.polygons.push_back({a, b + 1, a + 1});
    }
  View_options options = small_view();
  options.viewpoint = front;
  const Image image = render_view(soup, std::vector<std::size_t>(2 * n * n), options);
  for (std::size_t y = 12; y < 108; ++y)
    for (std::size_t x = 32; x < 128; ++x)
      ASSERT_TRUE(is_shade_of(image.at(x, y), segment_color(0))) << x << " " << y;
}

/// A plane of squares, of which those of each second row reach one farther to the right.
TEST(Render_view, a_border_does_not_zigzag_from_edge_to_edge)
{
  constexpr std::size_t n = 10;
  Polygon_soup soup;
  std::vector<std::size_t> labels;
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      soup.points.push_back({double(j), double(i), 0});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = i * (n + 1) + j, b = a + n + 1;
      soup.polygons.push_back({a, a + 1, b + 1, b});
      labels.push_back(j < n / 2 + i % 2 ? 0 : 1);
    }
  View_options options = small_view();
  options.viewpoint = front;
  const Image image = render_view(soup, labels, options);
  std::size_t least = image.width, greatest = 0;
  for (std::size_t y = 30; y < 90; ++y)
    for (std::size_t x = 40; x < 120; ++x)
      if (const Color& p = image.at(x, y); p[0] + p[1] + p[2] < 150) {
        least = (std::min)(least, x);
        greatest = (std::max)(greatest, x);
      }
  const double square = 120 * 0.92 / n;
  EXPECT_LT(double(greatest - least), 0.8 * square) << "of a border that is " << square << " wide";
}

TEST(Render_view, a_face_turned_the_wrong_way_looks_the_same)
{
  const Polygon_soup cube = make_cube();
  Polygon_soup turned = {cube.points, {}};
  for (std::size_t f = 0; f < 5; ++f)
    turned.polygons.push_back(cube.polygons[f]);
  const auto& last = cube.polygons[5];
  turned.polygons.push_back({last[3], last[2], last[1], last[0]});
  View_options options = small_view();
  options.viewpoint = front;
  EXPECT_EQ(render_view(cube, cube_labels, options).pixels,
            render_view(turned, cube_labels, options).pixels);
}

TEST(Render_view, the_viewpoint_shows_the_segments)
{
  // One side in four parts, which only a viewer in front of it sees.
  Polygon_soup soup = make_cube();
  soup.points.push_back({0, 0.5, 0.5});
  Polygons polygons = {{0, 4, 8}};
  for (std::size_t f = 1; f < soup.polygons.size(); ++f)
    polygons.push_back(soup.polygons[f]);
  for (const std::vector<std::size_t>& triangle :
       {std::vector<std::size_t>{4, 6, 8}, {6, 2, 8}, {2, 0, 8}})
    polygons.push_back(triangle);
  soup.polygons = polygons;
  const Image image = render_view(soup, {0, 1, 2, 3, 4, 5, 6, 7, 8}, small_view());
  const std::set<std::size_t> visible = visible_segments(image, 9);
  for (std::size_t s : {0, 6, 7, 8})
    EXPECT_EQ(visible.count(s), 1u) << s;
}

TEST(Render_view, a_viewpoint_is_orthonormal_right_handed_and_upright)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double sign : {-1.0, 1.0})
      for (const Viewpoint& v : candidate_viewpoints({axis, sign})) {
        EXPECT_NEAR(inner_product(v.right, v.right), 1, 1e-12);
        EXPECT_NEAR(inner_product(v.up, v.up), 1, 1e-12);
        EXPECT_NEAR(inner_product(v.right, v.up), 0, 1e-12);
        const Point difference = minus(cross_product(v.right, v.up), v.toward_viewer);
        EXPECT_NEAR(inner_product(difference, difference), 0, 1e-12);
        EXPECT_EQ(v.right[axis], 0);
        EXPECT_GT(sign * v.up[axis], 0);
        EXPECT_GT(sign * v.toward_viewer[axis], 0);
      }
}

TEST(Render_view, a_turned_mesh_looks_the_same_where_its_own_direction_is_up)
{
  Polygon_soup brick = make_cube();
  for (Point& p : brick.points)
    p = {p[0], 2 * p[1], 4 * p[2]};
  const auto picture = [&](const Up_direction& up, const auto& turn) {
    Polygon_soup turned = brick;
    for (Point& p : turned.points)
      p = turn(p);
    View_options options = small_view();
    options.up = up;
    return render_view(turned, cube_labels, options).pixels;
  };
  const auto upright = picture({}, [](const Point& p) { return p; });
  EXPECT_EQ(upright, picture({2, 1}, [](const Point& p) { return Point{p[2], p[0], p[1]}; }));
  EXPECT_EQ(upright, picture({0, 1}, [](const Point& p) { return Point{p[1], p[2], p[0]}; }));
  EXPECT_EQ(upright, picture({1, -1}, [](const Point& p) { return Point{-p[0], -p[1], p[2]}; }));
  EXPECT_NE(upright, picture({2, 1}, [](const Point& p) { return p; }));
}

Point cielab(const Color& color)
{
  Point linear;
  for (std::size_t j = 0; j < 3; ++j) {
    const double c = color[j] / 255.0;
    linear[j] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  const auto f = [&](const Point& row) {
    const double t = inner_product(row, linear);
    return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
  };
  const double x = f({0.43395, 0.37621, 0.18991}), y = f({0.2126, 0.7152, 0.0722}),
               z = f({0.01772, 0.10948, 0.87289}); // relative to the white point D65
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

TEST(Segment_colors, the_first_dozen_are_well_apart)
{
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Point difference = minus(cielab(segment_color(i)), cielab(segment_color(j)));
      EXPECT_GE(std::sqrt(inner_product(difference, difference)), 32) << i << " " << j;
    }
}

TEST(Render_view, degenerate_meshes_do_no_harm)
{
  constexpr double huge = 1.7e308;
  EXPECT_TRUE(is_empty(render_view({}, {}, small_view())));
  EXPECT_TRUE(is_empty(render_view({{{0, 0, 0}}, {}}, {}, small_view())));
  EXPECT_TRUE(is_empty(render_view({{{1, 1, 1}}, {{0, 0, 0}}}, {7}, small_view())));
  render_view({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, {0}, small_view());

  Polygon_soup cube = make_cube();
  for (Point& p : cube.points)
    p = {(p[0] - 0.5) * 2 * huge, (p[1] - 0.5) * 2 * huge, (p[2] - 0.5) * 2 * huge};
  EXPECT_EQ(visible_segments(render_view(cube, cube_labels, small_view()), 6).size(), 3u);
  View_options no_pixels;
  no_pixels.width = 0;
  EXPECT_TRUE(render_view(make_cube(), cube_labels, no_pixels).pixels.empty());
}

} // namespace render_view_test
} // namespace segment_mesh
