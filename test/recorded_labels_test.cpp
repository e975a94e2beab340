// SPDX-License-Identifier: GPL-3.0-or-later

// The labels of meshes of CGAL's demos are those that are recorded in recorded_labels/, a file a
// method. A line is a mesh, and for each number of segments that is asked for (0: it is chosen) the
// number that there is and a digest of the labels. Where labels are meant to change,
// `RECORD_LABELS=1 ctest -R Recorded_labels` writes the files anew.

#include "Digest.h"
#include "meshes.h"
#include "oracles.h"
#include "real_meshes.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#endif

#include <CGAL/boost/graph/IO/OFF.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace recorded_labels_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

constexpr const char* meshes =
  "ALSTOM_TEST4 anchor b9_mesh blobby_3cc boeing bones bull cactus cheese couplingdown cow "
  "cross_quad dino double-torus-example eight elephant elephant-with-holes elk fandisk "
  "femur hand handle head helmet holes homer joint knot1 mask_cone mech-holes-shark mpi "
  "mushroom nefertiti P pig pinion rotor spool three_peaks triceratops turbine";
const std::set<std::string> few_meshes = {"anchor", "boeing", "hand", "mpi", "pig"};

Soup read(const std::filesystem::path& file)
{
  std::ifstream in(file);
  std::vector<Kernel::Point_3> points;
  Soup soup;
  EXPECT_TRUE(CGAL::IO::read_OFF(in, points, soup.polygons)) << file;
  for (const Kernel::Point_3& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  return soup;
}

Soup unchanged(const Soup& soup)
{
  return soup;
}

/// Each coordinate is moved by at most a fifth of the mean length of the sides of faces.
Soup noisy(const Soup& original)
{
  Soup soup = original;
  double sum = 0;
  std::size_t number = 0;
  for (const Polygon& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i, ++number) {
      const Point &p = soup.points[polygon[i]], &q = soup.points[polygon[(i + 1) % polygon.size()]];
      sum += std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                       (p[2] - q[2]) * (p[2] - q[2]));
    }
  std::mt19937 random(1);
  for (Point& p : soup.points)
    for (double& x : p)
      x += 0.2 * sum / double(number) * (double(random()) / 2147483648 - 1);
  return soup;
}

/// With a copy of half its size, which crosses it or stands beside it.
Soup doubled(const Soup& soup)
{
  return joined(soup, scaled(soup, 0.5));
}

/// What a method gives, and its file.
template <typename Method>
class Recorded
{
public:
  explicit Recorded(std::string name, std::size_t most_faces = 20000)
    : m_name(std::move(name))
  {
    std::istringstream names(meshes);
    const std::set<std::string> chosen{std::istream_iterator<std::string>(names), {}};
    for (const auto& file : off_files())
      if (const std::string mesh = file.stem().string(); chosen.count(mesh))
        if (Soup soup = read(file); soup.polygons.size() <= most_faces)
          m_meshes[mesh] = std::move(soup);
  }

  /// All meshes: each is prepared once for all numbers. A method without a chosen number gets
  /// another one in its place.
  void add(const Method& method)
  {
    for (const auto& [mesh, soup] : m_meshes) {
      const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons,
                                                 RS::parameters::method(method));
      Labels labels(soup.polygons.size());
      if constexpr (std::is_same<Method, RS::Two_step>::value)
        add(mesh, 60, segmenter.segment(labels, 60), labels);
      else
        add(mesh, 0, segmenter.segment(labels), labels);
      for (const std::size_t k : {2, 5, 20, 100000})
        add(mesh, k, segmenter.segment(labels, k), labels);
    }
  }

  /// A few meshes, changed or with other constants: each number is asked for alone.
  template <typename NamedParameters>
  void add(const std::string& variant, const NamedParameters& np, Soup (*change)(const Soup&))
  {
    for (const std::string& mesh : few_meshes) {
      const Soup soup = change(m_meshes[mesh]);
      Labels labels(soup.polygons.size());
      for (const std::size_t k : {7, 600})
        add(mesh + '-' + variant, k,
            RS::segment_polygon_soup(soup.points, soup.polygons, labels, np.number_of_segments(k)),
            labels);
    }
  }

  /// Compares all that was added with the file, or writes it.
  void finish() const
  {
    const auto file = std::filesystem::path(__FILE__).parent_path() / "recorded_labels" /
                      (m_name + ".txt");
    if (std::getenv("RECORD_LABELS")) {
      std::ofstream out(file);
      for (const auto& [mesh, digests] : m_digests)
        out << mesh << digests << '\n';
      EXPECT_TRUE(out.flush()) << file;
      return;
    }
    std::map<std::string, std::string> recorded;
    std::ifstream in(file);
    for (std::string mesh, digests; in >> mesh && std::getline(in, digests);)
      recorded[mesh] = digests;
    EXPECT_EQ(recorded.size(), m_digests.size()) << "lines of " << file;
    for (const auto& [mesh, digests] : m_digests)
      compare(mesh, digests, recorded[mesh]);
  }

private:
  void add(const std::string& mesh, std::size_t asked, std::size_t number, const Labels& labels)
  {
    Digest digest;
    for (const std::size_t label : labels)
      digest.add(label);
    std::ostringstream out;
    out << ' ' << asked << ':' << number << '/' << std::hex << std::setw(8) << std::setfill('0')
        << (digest.value() & 0xffffffffu);
    m_digests[mesh] += out.str();
  }

  void compare(const std::string& mesh, const std::string& digests,
               const std::string& recorded_digests) const
  {
    std::istringstream line(digests), recorded_line(recorded_digests);
    for (std::string now, recorded; line >> now; recorded.clear()) {
      recorded_line >> recorded;
      EXPECT_EQ(now, recorded)
        << "Other labels by " << m_name << " of " << mesh << ", " << now.substr(0, now.find(':'))
        << " segments (0: chosen). To see where, write them by the program before and after "
           "(segment_mesh MESH -k N --method METHOD -o labels.seg); if they are meant to change: "
           "RECORD_LABELS=1 ctest -R Recorded_labels";
    }
  }

  std::string m_name;
  std::map<std::string, Soup> m_meshes;
  std::map<std::string, std::string> m_digests; ///< the lines of the file, by mesh and variant
};

struct Recorded_labels : ::testing::Test
{
  void SetUp() override
  {
    if (off_files().empty())
      GTEST_SKIP() << "REGION_SEGMENTATION_REAL_MESHES names no folder with .off files";
  }
};

TEST_F(Recorded_labels, of_Two_step)
{
  Recorded<RS::Two_step> recorded("two-step");
  recorded.add(RS::Two_step());
  RS::Two_step other;
  other.maximum_angle = 30;
  other.feature_convexity = RS::Feature_convexity::ALL;
  other.beta = 0.5;
  other.gamma = 0.2;
  other.factor = 5;
  recorded.add("constants", RS::parameters::method(other), unchanged);
  recorded.add("apart", RS::parameters::method(other).component_links(false), doubled);
  recorded.add("doubled", RS::parameters::method(other), doubled);
  recorded.finish();
}

/// Of a method on superfacets.
template <typename Method>
void compare_with_recorded(const std::string& name)
{
  Recorded<Method> recorded(name);
  Method method;
  recorded.add(method);
  recorded.add("noisy", RS::parameters::method(method), noisy);
  recorded.add("doubled", RS::parameters::method(method), doubled);
  method.superfacets = RS::Superfacets(100, 0.2, 1);
  method.number_of_draws = 2;
  method.straightening.width = 0.1;
  method.straightening.width_of_segment = 0.4;
  method.straightening.cost = {3, 1};
  method.straightening.number_of_cuts = 10;
  recorded.add("constants", RS::parameters::method(method).component_links(false), doubled);
  method.straightening.number_of_cuts = 0;
  recorded.add("unmoved", RS::parameters::method(method), unchanged);
  recorded.finish();
}

TEST_F(Recorded_labels, of_Visibility_merging)
{
  compare_with_recorded<RS::Visibility_merging>("visibility");
}

TEST_F(Recorded_labels, of_Learned_merging)
{
  compare_with_recorded<RS::Learned_merging>("learned");
}

#ifdef TEST_EIGEN
TEST_F(Recorded_labels, of_Smooth_faces)
{
  Recorded<RS::Smooth_faces> recorded("smooth-faces", 3000);
  RS::Smooth_faces method;
  recorded.add(method);
  recorded.add("doubled", RS::parameters::method(method), doubled);
  method.tolerance = 0.02;
  recorded.add("tolerance", RS::parameters::method(method), unchanged);
  recorded.finish();
}
#endif

} // namespace recorded_labels_test
