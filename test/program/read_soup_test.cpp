// SPDX-License-Identifier: GPL-3.0-or-later

// The readers on random files: against CGAL's, and with some bytes changed.

#include "read/errors.h"
#include "read/read_mesh.h"
#include "soup/little_endian.h"
#include "write/write_mesh.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>

namespace read_soup_test {

using namespace segment_mesh;

/// What `read` of CGAL makes of the bytes.
template <typename Read>
Polygon_soup by_cgal(const std::string& bytes, Read read)
{
  std::istringstream in(bytes);
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  EXPECT_TRUE(read(in, points, polygons, CGAL::parameters::verbose(false))) << bytes;
  Polygon_soup soup;
  for (const auto& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for (const auto& polygon : polygons)
    soup.polygons.push_back(polygon);
  return soup;
}

class Random_files : public testing::Test
{
protected:
  void SetUp() override { std::cout << "seed " << seed << "\n"; }

  std::size_t below(std::size_t n) { return n == 0 ? 0 : random() % n; }

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

  /// Replaces, removes, doubles or cuts off a few bytes.
  std::string changed(std::string bytes)
  {
    for (std::size_t i = 0, n = 1 + below(4); i < n; ++i) {
      const std::size_t at = below(bytes.size());
      switch (below(6)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes.erase(at, 1 + below(8));
        break;
      case 2:
        bytes.insert(at, bytes.substr(at, below(20)));
        break;
      case 3:
        bytes.insert(at, 1, "0123456789-.e \n#"[below(16)]);
        break;
      default:
        bytes.replace(at, 1, 1, char(below(256)));
      }
    }
    return bytes;
  }

  /// Whatever a file holds, it is read as a usable mesh or refused with one line that names it.
  void expect_read_or_refused(Mesh_format format, const std::string& bytes)
  {
    SCOPED_TRACE(testing::PrintToString(bytes));
    try {
      const Polygon_soup soup = parse_mesh("x", format, bytes).soup;
      ASSERT_FALSE(soup.polygons.empty());
      for (std::size_t p : soup.polygons.corners())
        ASSERT_LT(p, soup.points.size());
    } catch (const Input_error& error) {
      const std::string message = error.what();
      ASSERT_EQ(message.rfind("x:", 0), 0u) << message;
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }

  void check(Mesh_format format, const std::string& bytes, const Polygon_soup& expected)
  {
    const Input_mesh input = parse_mesh("x", format, bytes);
    const Polygon_soup& soup = input.soup;
    ASSERT_EQ(soup.points.size(), expected.points.size()) << bytes;
    // To the bit, with the signs of zeros.
    ASSERT_EQ(
      std::memcmp(soup.points.data(), expected.points.data(), sizeof(Point) * soup.points.size()),
      0)
      << bytes;
    ASSERT_EQ(soup.polygons, expected.polygons) << bytes;
    EXPECT_TRUE(input.remarks.empty());
    expect_read_or_refused(format, changed(bytes));
  }

  /// Calls `make` for the bytes of many files, until a test fails.
  template <typename Make, typename Read>
  void check_all(Mesh_format format, Make make, Read read)
  {
    for (int i = 0; i < 1000 && !HasFatalFailure(); ++i) {
      const std::string bytes = make();
      check(format, bytes, by_cgal(bytes, read));
    }
  }

  const unsigned seed = std::random_device()();
  std::mt19937 random{seed};
};

TEST_F(Random_files, of_off)
{
  const auto make = [this] {
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
    return bytes;
  };
  check_all(Mesh_format::OFF, make, [](auto&&... x) { return CGAL::IO::read_OFF(x...); });
}

TEST_F(Random_files, of_obj)
{
  const auto make = [this] {
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
    return bytes;
  };
  check_all(Mesh_format::OBJ, make, [](auto&&... x) { return CGAL::IO::read_OBJ(x...); });
}

TEST_F(Random_files, of_stl)
{
  const auto make = [this] {
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
    return bytes + (is_text ? "endsolid x\n" : "");
  };
  check_all(Mesh_format::STL, make, [](auto&&... x) { return CGAL::IO::read_STL(x...); });
}

std::string file_of_transcripts(const std::string& name)
{
  std::ifstream in(TRANSCRIPTS "/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Of glTF there is no reader of CGAL's.
TEST_F(Random_files, of_gltf)
{
  const std::string text = file_of_transcripts("tetrahedron.gltf"),
                    compressed = file_of_transcripts("tetrahedron_meshopt.gltf");
  for (int i = 0; i < 300 && !HasFatalFailure(); ++i) {
    const Polygon_soup soup = random_soup(6);
    std::ostringstream out;
    write_glb(out, {soup, std::vector<std::size_t>(soup.polygons.size())});
    expect_read_or_refused(Mesh_format::GLTF, changed(out.str()));
    for (const std::string& file : {text, compressed})
      expect_read_or_refused(Mesh_format::GLTF, changed(file));
  }
}

/// As gltfpack of meshoptimizer writes it, which begins with other corners.
TEST(Compressed_gltf, is_read_where_there_is_meshoptimizer)
{
  const auto triangles = [](const std::string& name) {
    const Polygon_soup soup = parse_mesh(name, Mesh_format::GLTF, file_of_transcripts(name)).soup;
    std::set<std::vector<Point>> result;
    for (const Polygon_soup::Polygon& polygon : soup.polygons) {
      std::vector<Point> points;
      for (const std::size_t i : polygon)
        points.push_back(soup.points[i]);
      std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
      result.insert(points);
    }
    return result;
  };
#ifdef SEGMENT_MESH_HAS_MESHOPTIMIZER
  EXPECT_EQ(triangles("tetrahedron_meshopt.gltf"), triangles("tetrahedron.gltf"));
#else
  EXPECT_THROW(triangles("tetrahedron_meshopt.gltf"), Input_error);
#endif
}

/// Appends a value to the data of a PLY file.
template <typename T>
void append(std::string& bytes, const std::string& format, double value)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<T>::max_digits10);
  text << +T(value) << " ";
  std::string data = text.str();
  if (format != "ascii") {
    data.clear();
    append_little_endian(data, T(value));
  }
  if (format == "binary_big_endian")
    std::reverse(data.begin(), data.end());
  bytes += data;
}

const std::map<std::string, void (*)(std::string&, const std::string&, double)> append_as = {
  {"char", append<std::int8_t>},     {"int8", append<std::int8_t>},
  {"uchar", append<std::uint8_t>},   {"uint8", append<std::uint8_t>},
  {"short", append<std::int16_t>},   {"int16", append<std::int16_t>},
  {"ushort", append<std::uint16_t>}, {"uint16", append<std::uint16_t>},
  {"int", append<std::int32_t>},     {"int32", append<std::int32_t>},
  {"uint", append<std::uint32_t>},   {"uint32", append<std::uint32_t>},
  {"float", append<float>},          {"float32", append<float>},
  {"double", append<double>},        {"float64", append<double>}};

class Random_ply_files : public Random_files
{
protected:
  std::string integer_type()
  {
    return one_of({"char", "uchar", "short", "ushort", "int", "uint", "int8", "uint8", "int16",
                   "uint16", "int32", "uint32"});
  }

  std::string file_of(const Polygon_soup& soup, const std::string& coordinate_type,
                      const std::string& size_type, const std::string& index_type)
  {
    const std::string format = one_of({"ascii", "binary_little_endian", "binary_big_endian"});
    const bool has_id = below(2), has_list = below(2);
    std::string bytes = "ply\nformat " + format + " 1.0\ncomment x\nelement vertex " +
                        std::to_string(soup.points.size()) + "\n" +
                        (has_id ? "property uchar id\n" : "");
    for (const char* name : {"x", "y", "z"})
      bytes += "property " + coordinate_type + " " + name + "\n";
    bytes += "element face " + std::to_string(soup.polygons.size()) + "\nproperty list " +
             size_type + " " + index_type + (below(2) ? " vertex_indices\n" : " vertex_index\n") +
             (has_list ? "property list uchar float uv\n" : "") + "end_header\n";
    const auto add = [&](const std::string& type, double value) {
      append_as.at(type)(bytes, format, value);
    };
    const std::string end = format == "ascii" ? "\n" : "";
    for (const Point& p : soup.points) {
      if (has_id)
        add("uchar", double(below(256)));
      for (const double x : p)
        add(coordinate_type, x);
      bytes += end;
    }
    for (const auto& polygon : soup.polygons) {
      add(size_type, double(polygon.size()));
      for (const std::size_t corner : polygon)
        add(index_type, double(corner));
      for (std::size_t i = 0, n = has_list ? below(3) : 0; has_list && i <= n; ++i)
        add(i == 0 ? "uchar" : "float", i == 0 ? double(n) : 0.5);
      bytes += end;
    }
    return bytes;
  }
};

/// Of the types that CGAL reads.
TEST_F(Random_ply_files, are_read_as_by_cgal)
{
  const auto make = [this] {
    return file_of(random_soup(6), one_of({"float", "double", "float32", "float64"}),
                   integer_type(), one_of({"int", "uint", "int32", "uint32"}));
  };
  check_all(Mesh_format::PLY, make, [](auto&&... x) { return CGAL::IO::read_PLY(x...); });
}

TEST_F(Random_ply_files, have_any_types)
{
  for (int i = 0; i < 1000 && !HasFatalFailure(); ++i) {
    Polygon_soup soup = random_soup(6);
    for (Point& p : soup.points)
      for (double& x : p)
        x = double(below(128)); // a value that all types have
    const std::string type = below(3) ? integer_type() : one_of({"float", "double"});
    check(Mesh_format::PLY, file_of(soup, type, integer_type(), integer_type()), soup);
  }
}

/// A size in a file that the file does not keep must not be believed when memory is reserved.
TEST(Lying_sizes, take_no_memory)
{
  const std::string face =
    "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uint uchar vertex_indices\nend_header\n";
  EXPECT_THROW(parse_mesh("x", Mesh_format::PLY, face + "\xff\xff\xff\xff"), Input_error);
}

} // namespace read_soup_test
