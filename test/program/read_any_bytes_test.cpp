// SPDX-License-Identifier: GPL-3.0-or-later

#include "Temporary_folder.h"
#include "read/errors.h"
#include "read/read_mesh.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <random>

namespace read_any_bytes_test {

using namespace segment_mesh;

/// Replaces, removes, doubles or cuts off a few bytes.
std::string mutated(std::string bytes, std::mt19937& random)
{
  const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
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
      if (!bytes.empty())
        bytes[at] = char(below(256));
    }
  }
  return bytes;
}

/// Whatever a file holds, it is read as a usable mesh or refused with one line that names it.
void expect_read_or_refused(const std::string& file)
{
  try {
    const Input_mesh input = read_mesh(file);
    ASSERT_FALSE(input.soup.polygons.empty());
    for (std::size_t p : input.soup.polygons.corners())
      ASSERT_LT(p, input.soup.points.size());
  } catch (const Input_error& error) {
    const std::string message = error.what();
    ASSERT_EQ(message.rfind(file + ":", 0), 0u) << message;
    ASSERT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(Any_bytes, are_read_or_refused)
{
  const unsigned seed = 20140101;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::vector<std::pair<std::string, std::string>> files = {
    {"a.off", sample::off()},
    {"a.off", sample::with(sample::off(), "OFF", "STCNOFF")},
    {"a.obj", sample::obj()},
    {"a.ply", sample::ply()},
    {"a.ply", sample::binary_ply("binary_little_endian")},
    {"a.ply", sample::binary_ply("binary_big_endian")},
    {"a.stl", sample::stl()},
    {"a.stl", sample::binary_stl()},
    {"a.stl", sample::binary_stl("solid")},
    {"a.glb", sample::glb()},
    {"a.gltf", sample::gltf()}};
  const Temporary_folder folder;
  for (const auto& [name, bytes] : files)
    for (int i = 0; i < 300; ++i) {
      const std::string changed = mutated(bytes, random);
      SCOPED_TRACE(testing::Message() << name << " " << testing::PrintToString(changed));
      expect_read_or_refused(folder.write(name, changed));
      if (HasFatalFailure())
        return;
    }
}

} // namespace read_any_bytes_test
