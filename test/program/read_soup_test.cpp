// SPDX-License-Identifier: GPL-3.0-or-later

// The readers against CGAL's on random files.

#include "read/errors.h"
#include "read/little_endian.h"
#include "read/read_mesh.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cstring>
#include <iterator>
#include <random>
#include <sstream>

namespace read_soup_test {

using namespace segment_mesh;

class Random_files : public testing::Test
{
protected:
  void SetUp() override { std::cout << "seed " << seed << "\n"; }

  std::size_t below(std::size_t n) { return random() % n; }

  const char* one_of(std::initializer_list<const char*> words)
  {
    return words.begin()[below(words.size())];
  }

  /// Any magnitude, also values that no float has, zeros of both signs and values near them.
  double coordinate()
  {
    const double value = std::uniform_real_distribution<>(-2, 2)(random);
    switch (below(6)) {
    case 0:
      return std::ldexp(value, int(below(200)) - 100);
    case 1:
      return float(value);
    case 2:
      return below(2) ? 0.0 : -0.0;
    default:
      return double(below(5)) - 2; // equal points for STL
    }
  }

  Polygon_soup random_soup(std::size_t most_corners)
  {
    Polygon_soup soup;
    for (std::size_t i = 0, n = 3 + below(10); i < n; ++i)
      soup.points.push_back({coordinate(), coordinate(), coordinate()});
    for (std::size_t i = 0, n = 1 + below(10); i < n; ++i) {
      std::vector<std::size_t> polygon;
      for (std::size_t j = 0, size = 3 + below(most_corners - 2); j < size; ++j)
        polygon.push_back(below(soup.points.size()));
      soup.polygons.push_back(polygon);
    }
    return soup;
  }

  std::string number(double value)
  {
    char text[64];
    std::snprintf(text, sizeof text, one_of({"%.17g", "%.9g", "%f", "%.3e", "%.0f"}), value);
    return text;
  }

  std::string blank() { return one_of({" ", "  ", "\t", " \t "}); }
  std::string line_end() { return one_of({"\n", "\n", " \n", "\n\n"}); }

  const unsigned seed = std::random_device()();
  std::mt19937 random{seed};
};

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;

/// What `read` of CGAL makes of the bytes.
template <typename Read>
Polygon_soup by_cgal(const std::string& bytes, Read read)
{
  std::istringstream in(bytes);
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  EXPECT_TRUE(read(in, points, polygons)) << bytes;
  Polygon_soup soup;
  for (const Point_3& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for (const auto& polygon : polygons)
    soup.polygons.push_back(polygon);
  return soup;
}

void expect_same(Mesh_format format, const std::string& bytes, const Polygon_soup& expected)
{
  const Input_mesh input = parse_mesh("x", format, bytes);
  const Polygon_soup& soup = input.soup;
  ASSERT_EQ(soup.points.size(), expected.points.size()) << bytes;
  // To the bit, with the signs of zeros.
  ASSERT_EQ(
    std::memcmp(soup.points.data(), expected.points.data(), sizeof(Point) * soup.points.size()), 0)
    << bytes;
  ASSERT_EQ(soup.polygons, expected.polygons) << bytes;
  EXPECT_TRUE(input.remarks.empty());
}

constexpr int number_of_files = 1000;

TEST_F(Random_files, of_off)
{
  for (int i = 0; i < number_of_files && !HasFatalFailure(); ++i) {
    const Polygon_soup soup = random_soup(6);
    std::string bytes = "OFF" + line_end() + std::to_string(soup.points.size()) + blank() +
                        std::to_string(soup.polygons.size()) + " 0" + line_end();
    for (const Point& p : soup.points)
      bytes += number(p[0]) + blank() + number(p[1]) + blank() + number(p[2]) + line_end();
    for (const auto& polygon : soup.polygons) {
      bytes += std::to_string(polygon.size());
      for (const std::size_t corner : polygon)
        bytes += blank() + std::to_string(corner);
      bytes += line_end();
    }
    expect_same(Mesh_format::OFF, bytes, by_cgal(bytes, [](auto&... x) {
                  return CGAL::IO::read_OFF(x..., CGAL::parameters::verbose(false));
                }));
  }
}

TEST_F(Random_files, of_obj)
{
  for (int i = 0; i < number_of_files && !HasFatalFailure(); ++i) {
    const Polygon_soup soup = random_soup(6);
    std::string bytes = one_of({"", "# a comment\n", "o thing\n"});
    for (const Point& p : soup.points)
      bytes += "v " + number(p[0]) + " " + number(p[1]) + " " + number(p[2]) + "\n";
    for (const auto& polygon : soup.polygons) {
      bytes += one_of({"f", "g a\nf", "s off\nf"});
      for (const std::size_t corner : polygon)
        bytes += " " +
                 (below(4) ? std::to_string(corner + 1)
                           : std::to_string(int(corner) - int(soup.points.size()))) +
                 one_of({"", "", "/1", "//2", "/1/2"});
      bytes += "\n";
    }
    expect_same(Mesh_format::OBJ, bytes, by_cgal(bytes, [](auto&... x) {
                  return CGAL::IO::read_OBJ(x..., CGAL::parameters::verbose(false));
                }));
  }
}

TEST_F(Random_files, of_stl)
{
  for (int i = 0; i < number_of_files && !HasFatalFailure(); ++i) {
    const Polygon_soup soup = random_soup(3);
    const bool is_text = below(2) == 0;
    std::string bytes = is_text ? "solid x\n" : std::string(80, 'x');
    if (!is_text)
      append_little_endian(bytes, std::uint32_t(soup.polygons.size()));
    for (const auto& polygon : soup.polygons) {
      bytes += is_text ? "facet normal 0 0 1\nouter loop\n" : std::string(12, '\0');
      for (const std::size_t corner : polygon) {
        const Point& p = soup.points[corner];
        if (is_text)
          bytes += "vertex " + number(p[0]) + " " + number(p[1]) + " " + number(p[2]) + "\n";
        else
          for (const double x : p)
            append_little_endian(bytes, float(x));
      }
      bytes += is_text ? "endloop\nendfacet\n" : std::string(2, '\0');
    }
    bytes += is_text ? "endsolid x\n" : "";
    expect_same(Mesh_format::STL, bytes, by_cgal(bytes, [](auto&... x) {
                  return CGAL::IO::read_STL(x..., CGAL::parameters::verbose(false));
                }));
  }
}

/// Values of a PLY file in one of its three formats.
class Ply_values
{
public:
  explicit Ply_values(const std::string& format)
    : m_format(format)
  {}

  void add(const std::string& type, double value)
  {
    if (type == "char" || type == "int8")
      add(std::int8_t(value));
    else if (type == "uchar" || type == "uint8")
      add(std::uint8_t(value));
    else if (type == "short" || type == "int16")
      add(std::int16_t(value));
    else if (type == "ushort" || type == "uint16")
      add(std::uint16_t(value));
    else if (type == "int" || type == "int32")
      add(std::int32_t(value));
    else if (type == "uint" || type == "uint32")
      add(std::uint32_t(value));
    else if (type == "float" || type == "float32")
      add(float(value));
    else
      add(value);
  }

  void end_line() { bytes += m_format == "ascii" ? "\n" : ""; }

  std::string bytes;

private:
  template <typename T>
  void add(T value)
  {
    if (m_format == "ascii") {
      std::ostringstream text;
      text.precision(std::numeric_limits<T>::max_digits10);
      text << +value << " ";
      bytes += text.str();
      return;
    }
    const std::size_t start = bytes.size();
    append_little_endian(bytes, value);
    if (m_format == "binary_big_endian")
      std::reverse(bytes.begin() + std::ptrdiff_t(start), bytes.end());
  }

  std::string m_format;
};

class Random_ply_files : public Random_files
{
protected:
  std::string integer_type()
  {
    return one_of({"char", "uchar", "short", "ushort", "int", "uint", "int8", "uint8", "int16",
                   "uint16", "int32", "uint32"});
  }

  /// A file of the soup, and in `expected` what its values mean in their types.
  std::string file_of(const Polygon_soup& soup, const std::string& coordinate_type,
                      const std::string& size_type, const std::string& index_type)
  {
    const std::string format = one_of({"ascii", "binary_little_endian", "binary_big_endian"});
    const bool has_id = below(2), has_list = below(2);
    std::string header = "ply\nformat " + format + " 1.0\ncomment x\nelement vertex " +
                         std::to_string(soup.points.size()) + "\n" +
                         (has_id ? "property uchar id\n" : "");
    for (const char* name : {"x", "y", "z"})
      header += "property " + coordinate_type + " " + name + "\n";
    header += "element face " + std::to_string(soup.polygons.size()) + "\nproperty list " +
              size_type + " " + index_type + (below(2) ? " vertex_indices\n" : " vertex_index\n");
    header += has_list ? "property list uchar float uv\n" : "";
    header += "end_header\n";
    Ply_values values(format);
    for (const Point& p : soup.points) {
      if (has_id)
        values.add("uchar", double(below(256)));
      for (const double x : p)
        values.add(coordinate_type, x);
      values.end_line();
    }
    for (const auto& polygon : soup.polygons) {
      values.add(size_type, double(polygon.size()));
      for (const std::size_t corner : polygon)
        values.add(index_type, double(corner));
      for (std::size_t i = 0, n = has_list ? below(3) : 0; has_list && i <= n; ++i)
        values.add(i == 0 ? "uchar" : "float", i == 0 ? double(n) : 0.5);
      values.end_line();
    }
    return header + values.bytes;
  }
};

/// Of the types that CGAL reads.
TEST_F(Random_ply_files, are_read_as_by_cgal)
{
  for (int i = 0; i < number_of_files && !HasFatalFailure(); ++i) {
    const std::string bytes = file_of(random_soup(6),
                                      one_of({"float", "double", "float32", "float64"}),
                                      integer_type(), one_of({"int", "uint", "int32", "uint32"}));
    expect_same(Mesh_format::PLY, bytes, by_cgal(bytes, [](auto&... x) {
                  return CGAL::IO::read_PLY(x..., CGAL::parameters::verbose(false));
                }));
  }
}

TEST_F(Random_ply_files, have_any_types)
{
  for (int i = 0; i < number_of_files && !HasFatalFailure(); ++i) {
    Polygon_soup soup = random_soup(6);
    for (Point& p : soup.points)
      for (double& x : p)
        x = double(below(128)); // a value that all types have
    const std::string type = below(3) ? integer_type() : one_of({"float", "double"});
    expect_same(Mesh_format::PLY, file_of(soup, type, integer_type(), integer_type()), soup);
  }
}

/// A count in a header that the file does not keep must not be believed when memory is reserved.
TEST(Lying_headers, take_no_memory)
{
  const std::string count = "1000000000000000000";
  const std::string ply = " 1.0\nelement vertex " + count +
                          "\nproperty float x\nproperty float y\nproperty float z\n"
                          "element face " +
                          count + "\nproperty list uint int vertex_indices\nend_header\n";
  for (const std::string format : {"ascii", "binary_little_endian"})
    EXPECT_THROW(parse_mesh("x", Mesh_format::PLY, "ply\nformat " + format + ply + "1 2 3 4 5 6 7"),
                 Input_error);
  EXPECT_THROW(parse_mesh("x", Mesh_format::OFF, "OFF " + count + " " + count + " 0\n1 2 3\n"),
               Input_error);
  EXPECT_THROW(
    parse_mesh("x", Mesh_format::OFF, "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + count + " 0 1 2\n"),
    Input_error);
  const std::string faces =
    "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uint uchar vertex_indices\nend_header\n";
  EXPECT_THROW(parse_mesh("x", Mesh_format::PLY, faces + "\xff\xff\xff\xff"), Input_error);
}

} // namespace read_soup_test
