// SPDX-License-Identifier: MIT
#include "tests/benchmarks/edge_counts.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

TEST(EdgeCounts, HaveFiguresNamedByRateAndJitter) {
  const auto figures = figures_of({{200, 40, 12, 3, 2, 0}});
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_EQ(figures[0].name, "miscounts_200k_jitter40");
  EXPECT_DOUBLE_EQ(figures[0].value, 3.0);
  EXPECT_EQ(figures[0].runs, 12U);
  EXPECT_EQ(figures[1].name, "lost_steps_200k_jitter40");
  EXPECT_DOUBLE_EQ(figures[1].value, 2.0);
  EXPECT_EQ(figures[2].name, "resets_200k_jitter40");
}

TEST(EdgeCounts, HaveNoMiscountsWhereNothingWasCompared) {
  const auto figures = figures_of({{200, 0, 0, 0, 0, 1}});
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].name, "lost_steps_200k_jitter0");
}

TEST(EdgeCounts, AreWorstWhereTheMostWereMissedOrNoneCouldBeCompared) {
  EXPECT_DOUBLE_EQ(worst_miscounts({{200, 0, 9, 0, 0, 0}, {200, 20, 9, 5, 0, 0}}), 5.0);
  EXPECT_TRUE(std::isinf(worst_miscounts({{200, 0, 9, 0, 0, 0}, {200, 20, 0, 0, 0, 0}})));
}

}  // namespace
}  // namespace echomap::bench
