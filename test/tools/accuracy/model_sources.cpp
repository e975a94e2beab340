// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_sources.h"

#include "read/read_mesh.h"
#include "models/procedural_models.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace princeton_benchmark {

namespace {

Truth make_truth(std::string name, std::vector<int> labels)
{
  const std::size_t number_of_segments = std::set<int>(labels.begin(), labels.end()).size();
  return {std::move(name), std::move(labels), number_of_segments};
}

Model load_princeton_model(const Princeton_data& data, int number)
{
  Model model;
  model.soup = segment_mesh::read_mesh(data.mesh_file(number).string()).soup;
  model.number_of_segments = std::size_t(data.number_of_segments(number));
  for (int j : data.human_segmentations(number))
    model.truths.push_back(make_truth(data.segmentation_file(number, j).stem().string(),
                                      data.labels(number, j, model.soup.polygons.size())));
  if (model.truths.empty())
    throw std::runtime_error(data.mesh_file(number).string() + ": no human segmentation");
  return model;
}

Model load_furniture(const std::filesystem::path& mesh_file)
{
  Model model;
  model.soup = segment_mesh::read_mesh(mesh_file.string()).soup;
  std::filesystem::path label_file = mesh_file;
  std::vector<int> labels = Princeton_data::read_integers(label_file.replace_extension(".seg"));
  if (labels.size() != model.soup.polygons.size())
    throw std::runtime_error(label_file.string() + ": " + std::to_string(labels.size()) +
                             " labels for " + std::to_string(model.soup.polygons.size()) +
                             " faces");
  std::map<int, std::size_t> sizes;
  for (const int label : labels)
    ++sizes[label];
  for (const auto& part : sizes)
    model.number_of_segments += double(part.second) > .002 * double(labels.size());
  model.truths.push_back(make_truth("its parts", std::move(labels)));
  return model;
}

Model make_procedural_model(segment_mesh::Labelled_model made)
{
  Model model;
  model.soup = std::move(made.soup);
  model.number_of_segments = made.number_of_parts;
  model.truths.push_back(make_truth("its parts", {made.labels.begin(), made.labels.end()}));
  return model;
}

} // namespace

std::vector<Model_source> princeton_sources(const Princeton_data& data)
{
  std::vector<Model_source> sources;
  for (int number : data.models())
    sources.push_back({std::to_string(number),
                       Princeton_data::category_name(Princeton_data::category(number)),
                       [&data, number] { return load_princeton_model(data, number); }});
  return sources;
}

std::vector<Model_source> furniture_sources(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".off")
      files.push_back(entry.path());
  if (files.empty())
    throw std::runtime_error(folder.string() + ": no file KIND_NAME.off");
  std::sort(files.begin(), files.end());
  std::vector<Model_source> sources;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.stem().string();
    sources.push_back(
      {name, name.substr(0, name.find('_')), [file] { return load_furniture(file); }});
  }
  return sources;
}

std::vector<Model_source> procedural_sources()
{
  std::vector<Model_source> sources;
  for (const segment_mesh::Model_recipe& recipe : segment_mesh::procedural_models())
    sources.push_back(
      {recipe.name, recipe.name, [&recipe] { return make_procedural_model(recipe.make()); }});
  return sources;
}

std::vector<Model_source> variant_sources(const std::vector<Variant>& variants)
{
  std::vector<Model_source> sources;
  for (const Variant& variant : variants)
    for (const segment_mesh::Model_recipe& recipe : segment_mesh::procedural_models())
      sources.push_back({recipe.name, variant.name, [make = variant.make, &recipe] {
                           return make_procedural_model(make(recipe));
                         }});
  return sources;
}

} // namespace princeton_benchmark
