// SPDX-License-Identifier: MIT
#include "host/localization/vuong_test.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(VuongTest, IsTheMeanDifferenceByItsDeviation) {
  const std::vector<double> better = {1.0, 2.0, 3.0, 4.0};
  const std::vector<double> worse = {0.0, 2.0, 2.0, 4.0};
  // Differences 1, 0, 1, 0: mean 0.5, deviation 0.577 and the floor of 0.05, of 4.
  EXPECT_NEAR(vuong_statistic(better, worse), 0.5 / ((std::sqrt(1.0 / 3.0) + 0.05) / 2.0), 1e-9);
  EXPECT_NEAR(vuong_statistic(worse, better), -vuong_statistic(better, worse), 1e-9);
}

TEST(VuongTest, SaysLessOfFewLargeDifferencesThanOfManySmallOnes) {
  const std::vector<double> worse(8, 0.0);
  const std::vector<double> many(8, 0.5);
  std::vector<double> few(8, 0.0);
  few.front() = 4.0;
  EXPECT_GT(vuong_statistic(many, worse), 2.0 * vuong_statistic(few, worse));
}

TEST(VuongTest, CertaintyIsBounded) {
  EXPECT_DOUBLE_EQ(odds_of_worse(0.0), 1.0);
  EXPECT_NEAR(odds_of_worse(1.645), 0.05 / 0.95, 1e-3);
  EXPECT_GT(odds_of_worse(1000.0), 0.0);
  EXPECT_TRUE(std::isfinite(odds_of_worse(-1000.0)));
}

}  // namespace
}  // namespace echomap::localization
