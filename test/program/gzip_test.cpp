// SPDX-License-Identifier: GPL-3.0-or-later

// Inputs that gzip has compressed.

#include "Temporary_folder.h"
#include "batch/scores.h"
#include "read/errors.h"
#include "read/inflate.h"
#include "read/load_bytes.h"

#include <zlib.h>

#include <gtest/gtest.h>

#include <random>

namespace gzip_test {

using namespace segment_mesh;

/// By zlib's functions for files, which the program does not use.
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

/// Without remarks.
std::string inflated(const std::string& bytes)
{
  Remarks remarks;
  const std::string result = inflate("x", bytes, remarks);
  EXPECT_EQ(remarks, Remarks{});
  return result;
}

std::string message(const std::string& bytes)
{
  try {
    inflated(bytes);
  } catch (const Input_error& error) {
    return error.what();
  }
  return "was inflated";
}

TEST(Gzip, is_inflated)
{
  const Temporary_folder folder;
  for (const std::size_t size : {1, 1000, 5000000}) {
    const std::string text = random_text(size);
    const std::string bytes = compressed(folder, text);
    EXPECT_TRUE(is_gzip(bytes));
    EXPECT_FALSE(is_gzip(text));
    EXPECT_TRUE(inflated(bytes) == text) << size;
    Remarks remarks;
    EXPECT_TRUE(load_bytes(folder.write("a.off.gz", bytes), remarks) == text) << size;
    EXPECT_TRUE(load_bytes(folder.write("a.off", bytes), remarks) == text)
      << "an ending that says nothing of it";
  }
}

TEST(Gzip, is_inflated_in_several_members)
{
  const Temporary_folder folder;
  EXPECT_EQ(inflated(compressed(folder, "OFF\n") + compressed(folder, "1 2 3\n")), "OFF\n1 2 3\n");
}

TEST(Gzip, may_be_padded_by_zeros)
{
  const Temporary_folder folder;
  const std::string bytes = compressed(folder, "OFF\n");
  for (const std::size_t size : {1, 511, 100000})
    EXPECT_EQ(inflated(bytes + std::string(size, '\0')), "OFF\n") << size;
}

TEST(Gzip, is_inflated_before_other_bytes_with_a_remark)
{
  const Temporary_folder folder;
  const std::string bytes = compressed(folder, "OFF\n");
  const auto remarks = [](const std::string& all) {
    Remarks result;
    EXPECT_EQ(inflate("x", all, result), "OFF\n");
    return result;
  };
  EXPECT_EQ(remarks(bytes + "and more"),
            Remarks{"x: not read: 8 bytes after the end of the gzip data"});
  EXPECT_EQ(remarks(bytes + std::string(9, '\0') + "x"),
            Remarks{"x: not read: 10 bytes after the end of the gzip data"});
}

TEST(Gzip, of_labels_may_grow_as_much_as_they_do)
{
  const Temporary_folder folder;
  constexpr std::size_t number_of_faces = 600000;
  std::string labels;
  for (std::size_t i = 0; i < number_of_faces; ++i)
    labels += i < number_of_faces / 2 ? "0\n" : "1\n";
  const std::string file = folder.write("a.seg.gz", compressed(folder, labels));
  Remarks remarks;
  EXPECT_LT(100 * folder.read("a.seg.gz").size(), labels.size());
  EXPECT_EQ(read_truth(file, number_of_faces, remarks).labels.back(), 1);
  folder.write("a.seg.gz", compressed(folder, std::string(60000000, '0')));
  EXPECT_THROW(read_truth(file, number_of_faces, remarks), Input_error);
}

TEST(Gzip, is_told_where_it_is_damaged)
{
  const Temporary_folder folder;
  const std::string bytes = compressed(folder, random_text(100000));
  for (std::size_t size = 2; size < bytes.size(); size += 1 + size / 10)
    EXPECT_EQ(message(bytes.substr(0, size)), "x: is a gzip file that is cut off") << size;
  std::string damaged = bytes;
  damaged[damaged.size() / 2] = char(~damaged[damaged.size() / 2]);
  EXPECT_EQ(message(damaged), "x: is a damaged gzip file");
  EXPECT_EQ(message(bytes + "\x1f\x8b and more"), "x: is a damaged gzip file");
}

TEST(Gzip, is_refused_where_it_exhausts_the_memory)
{
  const Temporary_folder folder;
  EXPECT_EQ(message(compressed(folder, std::string(200000000, '0'))),
            "x: is a gzip file that grows by more than 100 times");
  EXPECT_EQ(inflated(compressed(folder, std::string(1000000, '0'))).size(), 1000000u);
}

TEST(Gzip, is_told_where_it_is_empty)
{
  const Temporary_folder folder;
  const std::string file = folder.write("a.off.gz", compressed(folder, ""));
  try {
    Remarks remarks;
    load_bytes(file, remarks);
    ADD_FAILURE() << "was read";
  } catch (const Input_error& error) {
    EXPECT_EQ(error.what(), file + ": is empty");
  }
}

} // namespace gzip_test
