// SPDX-License-Identifier: GPL-3.0-or-later

// Inputs that gzip has compressed.

#include "Temporary_folder.h"
#include "batch/scores.h"
#include "read/errors.h"
#include "read/load_bytes.h"

#include <zlib.h>

#include <gtest/gtest.h>

#include <random>

namespace gzip_test {

using namespace segment_mesh;

std::string compressed(const Temporary_folder& folder, const std::string& bytes)
{
  const gzFile file = gzopen(folder.path("compressed").c_str(), "wb");
  gzwrite(file, bytes.data(), unsigned(bytes.size()));
  gzclose(file);
  return folder.read("compressed");
}

std::string random_text(std::size_t size)
{
  std::mt19937 random(size);
  std::string text;
  while (text.size() < size)
    text += std::to_string(random() % 1000) + " ";
  return text;
}

/// What a file of these bytes holds.
std::string inflated(const std::string& bytes)
{
  const Temporary_folder folder;
  return load_bytes(folder.write("a.off", bytes));
}

std::string message(const std::string& bytes)
{
  const Temporary_folder folder;
  const std::string file = folder.write("a.off.gz", bytes);
  try {
    load_bytes(file);
  } catch (const Input_error& error) {
    return std::string(error.what()).substr(file.size());
  }
  return "was inflated";
}

TEST(Gzip, is_inflated)
{
  const Temporary_folder folder;
  for (const std::size_t size : {1, 1000, 5000000}) {
    const std::string text = random_text(size);
    EXPECT_TRUE(inflated(compressed(folder, text)) == text) << size;
    EXPECT_TRUE(inflated(text) == text) << size;
  }
}

TEST(Gzip, may_have_several_members_and_padding)
{
  const Temporary_folder folder;
  const std::string bytes = compressed(folder, "OFF\n") + compressed(folder, "1 2 3\n");
  for (const std::size_t size : {0, 1, 511, 100000})
    EXPECT_EQ(inflated(bytes + std::string(size, '\0')), "OFF\n1 2 3\n") << size;
}

TEST(Gzip, of_labels_may_grow_as_much_as_they_do)
{
  const Temporary_folder folder;
  constexpr std::size_t number_of_faces = 600000;
  std::string labels;
  for (std::size_t i = 0; i < number_of_faces; ++i)
    labels += i < number_of_faces / 2 ? "0\n" : "1\n";
  const std::string file = folder.write("a.seg.gz", compressed(folder, labels));
  EXPECT_LT(100 * folder.read("a.seg.gz").size(), labels.size());
  EXPECT_EQ(read_truth(file, number_of_faces).labels.back(), 1);
  folder.write("a.seg.gz", compressed(folder, std::string(60000000, '0')));
  EXPECT_THROW(read_truth(file, number_of_faces), Input_error);
}

TEST(Gzip, is_told_where_it_is_damaged)
{
  const Temporary_folder folder;
  const std::string bytes = compressed(folder, random_text(100000));
  for (std::size_t size = 2; size < bytes.size(); size += 1 + size / 10)
    EXPECT_EQ(message(bytes.substr(0, size)), ": is a gzip file that is cut off") << size;
  std::string damaged = bytes;
  damaged[damaged.size() / 2] = char(~damaged[damaged.size() / 2]);
  EXPECT_EQ(message(damaged), ": is a damaged gzip file");
  EXPECT_EQ(message(bytes + "\x1f\x8b and more"), ": is a damaged gzip file");
  EXPECT_EQ(message(compressed(folder, "")), ": is empty");
}

TEST(Gzip, is_refused_where_it_exhausts_the_memory)
{
  const Temporary_folder folder;
  EXPECT_EQ(message(compressed(folder, std::string(200000000, '0'))),
            ": is a gzip file that grows by more than 100 times");
  EXPECT_EQ(inflated(compressed(folder, std::string(1000000, '0'))).size(), 1000000u);
}

} // namespace gzip_test
