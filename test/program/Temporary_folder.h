// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TEMPORARY_FOLDER_H
#define CGAL_REGION_SEGMENTATION_TEST_TEMPORARY_FOLDER_H

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

/// A folder that goes with the test.
class Temporary_folder
{
public:
  Temporary_folder()
    : m_path(std::filesystem::temp_directory_path() /
             ("segment_mesh_test-" + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directory(m_path);
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  std::string path(const std::string& name) const { return (m_path / name).string(); }

  /// Writes a file, and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(m_path / name, std::ios::binary) << bytes;
    return path(name);
  }

  std::string read(const std::string& name) const
  {
    std::ifstream in(m_path / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }

  bool has(const std::string& name) const { return std::filesystem::exists(m_path / name); }

  /// The names of all that is there, hidden files too, in order.
  std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(m_path))
      result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  std::filesystem::path m_path;
};

#endif // CGAL_REGION_SEGMENTATION_TEST_TEMPORARY_FOLDER_H
