// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODELS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODELS_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace princeton_benchmark {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// Points, and triangles of their indices.
struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
};

/// Vertices and faces are numbered as in the soup.
/// \throws std::runtime_error if the soup is not an oriented 2-manifold
Mesh make_mesh(const Soup& soup);

/// A map of the faces of a mesh to a vector of values.
template <typename Values>
auto face_map(const Mesh& mesh, Values& values)
{
  return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh));
}

/// A segmentation that results are compared with.
struct Person
{
  std::vector<int> labels; ///< of the triangles
  std::size_t number_of_segments;
};

/// A model in memory.
struct Model
{
  Soup soup;
  std::size_t number_of_segments; ///< the number k that a method is given
  std::vector<Person> people;
};

/// The number of the labels of more than .2 % of the faces.
std::size_t number_of_large_parts(const std::vector<int>& labels);

/// Where a model comes from.
struct Model_source
{
  std::string name, category;
  int number;             ///< in the benchmark; others have numbers above all of them
  std::string collection; ///< benchmark, furniture or sheets
  std::filesystem::path mesh_file;
  std::vector<std::filesystem::path> label_files; ///< one for each person
  std::size_t number_of_segments; ///< 0: that of the first person's parts of more than .2 % of the
                                  ///< faces

  /// \throws std::runtime_error with a message that names the file
  Model load() const;
};

/// The models of a copy of the Princeton benchmark, by number; then, unless the second folder is
/// empty, furniture: each `KIND_NAME.off` with the labels of its faces in `KIND_NAME.seg`, by name;
/// its category is the kind.
/// \throws std::runtime_error if a folder has no model
std::vector<Model_source> find_models(const std::filesystem::path& benchmark,
                                      const std::filesystem::path& furniture);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODELS_H
