// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles.h"

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace Partition_test {

namespace RS = CGAL::Region_segmentation;
using RS::Partition;
using namespace test;

TEST(Partition_test, labels_of_every_width_stay_different)
{
  using Limits = std::numeric_limits<std::int64_t>;
  const std::vector<std::int64_t> wide = {Limits::max(), Limits::min(),         0, -1,
                                          Limits::max(), std::int64_t(1) << 32, 1};
  EXPECT_EQ(labels_of(Partition::from_labels(wide)), (Labels{0, 1, 2, 3, 0, 4, 5}));
  EXPECT_EQ(labels_of(Partition::from_labels(std::vector<std::int8_t>{-128, 127, -1, -128})),
            (Labels{0, 1, 2, 0}));
  EXPECT_EQ(labels_of(Partition::from_labels(std::vector<std::uint64_t>{~std::uint64_t(0), 0})),
            (Labels{0, 1}));
  EXPECT_EQ(labels_of(Partition::from_labels(std::vector<bool>{true, false, true})),
            (Labels{0, 1, 0}));
}

TEST(Partition_test, is_that_of_the_labels)
{
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Labels labels(random() % 3000);
    const std::size_t n = 1 + random() % 2000;
    for (std::size_t& label : labels)
      label = (random() % n) * (seed % 2 ? 1 : std::size_t(1) << 33);
    const auto p = Partition::from_labels(labels);
    EXPECT_EQ(labels_of(p), renumbered(labels));
    EXPECT_EQ(p.number_of_parts(), std::set<std::size_t>(labels.begin(), labels.end()).size());
  }
}

TEST(Partition_test, equality_is_that_of_the_parts)
{
  const auto p = Partition::from_labels(std::vector<int>{3, 3, 5});
  EXPECT_EQ(p, Partition::from_labels(std::vector<long>{-4, -4, 9}));
  EXPECT_EQ(p, Partition({0, 0, 1}, 2));
  EXPECT_NE(p, Partition::from_labels(std::vector<int>{3, 5, 5}));
  EXPECT_NE(p, Partition::from_labels(std::vector<int>{3, 3}));
  EXPECT_EQ(Partition(), Partition::from_labels(std::vector<int>()));
  EXPECT_EQ(Partition().number_of_parts(), 0u);
}

TEST(Partition_test, composed_joins_parts)
{
  const auto fine = Partition::from_labels(std::vector<int>{0, 1, 2, 1, 3});
  const auto coarse = Partition::from_labels(std::vector<int>{0, 1, 0, 1});
  EXPECT_EQ(labels_of(composed(fine, coarse)), (Labels{0, 1, 0, 1, 1}));
  EXPECT_EQ(composed(fine, coarse).number_of_parts(), 2u);
  EXPECT_EQ(composed(Partition(), Partition()), Partition());
}

} // namespace Partition_test
