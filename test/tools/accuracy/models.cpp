// SPDX-License-Identifier: GPL-3.0-or-later

#include "models.h"

#include "Princeton_data.h"

#include <CGAL/IO/OFF.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace princeton_benchmark {

namespace {

Soup read_soup(const std::filesystem::path& file)
{
  Soup soup;
  if (!CGAL::IO::read_OFF(file.string(), soup.points, soup.triangles))
    throw std::runtime_error(file.string() + ": no mesh in the format OFF");
  return soup;
}

Person read_person(const std::filesystem::path& file, std::size_t number_of_faces)
{
  std::vector<int> labels = Princeton_data::read_labels(file, number_of_faces);
  const std::size_t number = std::set<int>(labels.begin(), labels.end()).size();
  return {std::move(labels), number};
}

std::vector<Model_source> find_furniture(const std::filesystem::path& folder)
{
  std::vector<Model_source> sources;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path mesh = entry.path();
    const std::string name = mesh.stem().string();
    if (mesh.extension() == ".off")
      sources.push_back({name,
                         name.substr(0, name.find('_')),
                         0,
                         "furniture",
                         mesh,
                         {std::filesystem::path(mesh).replace_extension(".seg")},
                         0});
  }
  if (sources.empty())
    throw std::runtime_error(folder.string() + ": no file KIND_NAME.off");
  std::sort(sources.begin(), sources.end(),
            [](const auto& a, const auto& b) { return a.mesh_file < b.mesh_file; });
  for (std::size_t i = 0; i < sources.size(); ++i)
    sources[i].number = 20 * Princeton_data::number_of_categories + 1 + int(i);
  return sources;
}

} // namespace

Mesh make_mesh(const Soup& soup)
{
  Mesh mesh;
  for (const Point& p : soup.points)
    mesh.add_vertex(p);
  for (const auto& t : soup.triangles) {
    const auto vertex = [&](std::size_t i) { return Mesh::Vertex_index(Mesh::size_type(t[i])); };
    if (mesh.add_face(vertex(0), vertex(1), vertex(2)) == Mesh::null_face())
      throw std::runtime_error("not an oriented 2-manifold");
  }
  return mesh;
}

std::size_t number_of_large_parts(const std::vector<int>& labels)
{
  std::map<int, std::size_t> sizes;
  for (const int label : labels)
    ++sizes[label];
  return std::size_t(std::count_if(sizes.begin(), sizes.end(), [&](const auto& part) {
    return double(part.second) > .002 * double(labels.size());
  }));
}

Model Model_source::load() const
{
  Model model{read_soup(mesh_file), number_of_segments, {}};
  for (const auto& file : label_files)
    model.people.push_back(read_person(file, model.soup.triangles.size()));
  if (model.people.empty())
    throw std::runtime_error(mesh_file.string() + ": no human segmentation");
  if (model.number_of_segments == 0)
    model.number_of_segments = number_of_large_parts(model.people.front().labels);
  return model;
}

std::vector<Model_source> find_models(const std::filesystem::path& benchmark,
                                      const std::filesystem::path& furniture)
{
  const Princeton_data data(benchmark);
  std::vector<Model_source> sources;
  for (const int n : data.models()) {
    sources.push_back({std::to_string(n),
                       Princeton_data::category_name(Princeton_data::category(n)),
                       n,
                       "benchmark",
                       data.mesh_file(n),
                       {},
                       std::size_t(data.number_of_segments(n))});
    for (const int j : data.human_segmentations(n))
      sources.back().label_files.push_back(data.segmentation_file(n, j));
  }
  if (!furniture.empty()) {
    const std::vector<Model_source> pieces = find_furniture(furniture);
    sources.insert(sources.end(), pieces.begin(), pieces.end());
  }
  return sources;
}

} // namespace princeton_benchmark
