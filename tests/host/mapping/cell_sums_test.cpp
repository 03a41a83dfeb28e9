// SPDX-License-Identifier: MIT
#include "host/mapping/cell_sums.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

TEST(CellSums, KeepsItsSumsAsItGrows) {
  CellSums sums;
  EXPECT_EQ(sums.at({3, 4}), 0) << "nothing is held yet";
  sums.hold({{0, 0}, {5, 5}});
  sums.add({3, 4}, 7);
  sums.add({3, 4}, -2);
  sums.hold({{-300, 2}, {5, 200}});
  EXPECT_EQ(sums.at({3, 4}), 5);
  EXPECT_LE(sums.bounds().min.x, -300);
  EXPECT_GE(sums.bounds().max.y, 200);
}

TEST(CellSums, MovesOnlyTheSideThatHasTo) {
  CellSums sums;
  sums.hold({{0, 0}, {5, 5}});
  const CellBounds before = sums.bounds();
  sums.hold({{0, 0}, {before.max.x + 1, 5}});
  EXPECT_GT(sums.bounds().max.x, before.max.x + 1) << "some more than asked for";
  EXPECT_EQ(sums.bounds().min.x, before.min.x);
  EXPECT_EQ(sums.bounds().min.y, before.min.y);
  EXPECT_EQ(sums.bounds().max.y, before.max.y);
}

TEST(CellSums, KnowsWhatNoMemoryWouldHold) {
  CellSums sums;
  sums.hold({{0, 0}, {5, 5}});
  EXPECT_TRUE(sums.can_hold({{0, 0}, {1000, 1000}}));
  EXPECT_FALSE(sums.can_hold({{0, 0}, {1 << 30, 0}}));
  EXPECT_FALSE(sums.can_hold({{0, 0}, {1 << 13, 1 << 13}}));
}

}  // namespace
}  // namespace echomap::mapping
