// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_PRINCETON_DATA_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_PRINCETON_DATA_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The Princeton Segmentation Benchmark as it lies on disk, in its own layout:
/// `data/off/N.off`, `data/seg/Benchmark/N/N_j.seg`, `util/parameters/nSeg-ByModel.txt`. Any part
/// of the models may be there. Every error is a `std::runtime_error` that names the file.
class Princeton_data
{
public:
  using Path = std::filesystem::path;

  static constexpr int number_of_categories = 20;

  /// \throws std::runtime_error if there is no mesh, or no table of the numbers of segments
  explicit Princeton_data(Path root)
    : m_root(std::move(root))
  {
    m_models = numbers_in(m_root / "data" / "off", "", ".off");
    if (m_models.empty())
      throw std::runtime_error((m_root / "data" / "off").string() + ": no file N.off");
    const Path table = m_root / "util" / "parameters" / "nSeg-ByModel.txt";
    m_numbers_of_segments = read_integers(table);
    if (m_numbers_of_segments.size() < std::size_t(m_models.back()))
      throw std::runtime_error(table.string() + ": fewer lines than models");
  }

  /// The data in the directory that the environment variable REGION_SEGMENTATION_PSB names; none
  /// when it is not set or the directory is not there.
  static std::optional<Princeton_data> from_environment()
  {
    const char* root = std::getenv("REGION_SEGMENTATION_PSB");
    if (!root || !std::filesystem::is_directory(Path(root) / "data" / "off"))
      return std::nullopt;
    return Princeton_data(root);
  }

  /// The numbers of the models that are there, ascending.
  const std::vector<int>& models() const { return m_models; }

  Path mesh_file(int model) const
  {
    return m_root / "data" / "off" / (std::to_string(model) + ".off");
  }

  /// The j of the human segmentations `N_j.seg` of a model, ascending.
  std::vector<int> human_segmentations(int model) const
  {
    return numbers_in(segmentation_folder(model), std::to_string(model) + "_", ".seg");
  }

  Path segmentation_file(int model, int segmentation) const
  {
    return segmentation_folder(model) /
           (std::to_string(model) + "_" + std::to_string(segmentation) + ".seg");
  }

  /// The labels of a human segmentation, one for each face in the order of the mesh file.
  /// \throws std::runtime_error if there are not `number_of_faces` of them
  std::vector<int> labels(int model, int segmentation, std::size_t number_of_faces) const
  {
    return read_labels(segmentation_file(model, segmentation), number_of_faces);
  }

  /// k of the standard protocol: the most common number of segments among the people.
  int number_of_segments(int model) const { return m_numbers_of_segments.at(model - 1); }

  /// The category of a model, 0 .. 19; 13 (Spring) has no models.
  static int category(int model) { return (model - 1) / 20; }

  static const char* category_name(int category)
  {
    static constexpr std::array<const char*, number_of_categories> names = {
      "Human",     "Cup",   "Glasses", "Airplane", "Ant",  "Chair",  "Octopus",
      "Table",     "Teddy", "Hand",    "Plier",    "Fish", "Bird",   "Spring",
      "Armadillo", "Bust",  "Mech",    "Bearing",  "Vase", "FourLeg"};
    return names.at(category);
  }

  /// The integers of a file. \throws std::runtime_error if there are not `number_of_faces` of them
  static std::vector<int> read_labels(const Path& file, std::size_t number_of_faces)
  {
    std::vector<int> result = read_integers(file);
    if (result.size() != number_of_faces)
      throw std::runtime_error(file.string() + ": " + std::to_string(result.size()) +
                               " labels for " + std::to_string(number_of_faces) + " faces");
    return result;
  }

private:
  /// All numbers of a file.
  static std::vector<int> read_integers(const Path& file)
  {
    std::ifstream in(file);
    if (!in)
      throw std::runtime_error(file.string() + ": cannot be opened");
    std::vector<int> numbers;
    for (int number; in >> number;)
      numbers.push_back(number);
    if (!in.eof())
      throw std::runtime_error(file.string() + ": entry " + std::to_string(numbers.size() + 1) +
                               " is not an integer");
    return numbers;
  }

  Path segmentation_folder(int model) const
  {
    return m_root / "data" / "seg" / "Benchmark" / std::to_string(model);
  }

  /// The n of the files `<prefix>n<suffix>` in a folder, ascending; none where it does not exist.
  static std::vector<int> numbers_in(const Path& folder, const std::string& prefix,
                                     const std::string& suffix)
  {
    std::vector<int> numbers;
    std::error_code not_there;
    for (const auto& entry : std::filesystem::directory_iterator(folder, not_there)) {
      const std::string name = entry.path().filename().string();
      const std::size_t affixes = prefix.size() + suffix.size();
      if (name.size() <= affixes || name.compare(0, prefix.size(), prefix) != 0 ||
          name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
        continue;
      const std::string digits = name.substr(prefix.size(), name.size() - affixes);
      if (digits.size() < 9 && digits.find_first_not_of("0123456789") == std::string::npos)
        numbers.push_back(std::stoi(digits));
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }

  Path m_root;
  std::vector<int> m_models;
  std::vector<int> m_numbers_of_segments; // by model, from 1
};

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_PRINCETON_DATA_H
