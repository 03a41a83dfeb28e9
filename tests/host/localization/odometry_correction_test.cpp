// SPDX-License-Identifier: MIT
#include "host/localization/odometry_correction.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(OdometryCorrection, FindsTheLineThatPointsLieOn) {
  const std::vector<MeasuredDistance> distances = {{0.5, 0.47}, {1.0, 0.92}, {2.0, 1.82}};
  const auto correction = fit_correction(distances);
  ASSERT_TRUE(correction);
  EXPECT_NEAR(correction->slope, 0.9, 1e-12);
  EXPECT_NEAR(correction->offset_m, 0.02, 1e-12);
}

TEST(OdometryCorrection, IsEquationsFourAndFiveWithTheirNamesExchanged) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.01);
  std::vector<MeasuredDistance> distances;
  double sum_d = 0.0, sum_t = 0.0, sum_dd = 0.0, sum_dt = 0.0;
  for (int i = 1; i <= 30; ++i) {
    const double d = 0.1 * i;
    const double t = 0.95 * d + 0.005 + noise(random);
    distances.push_back({d, t});
    sum_d += d;
    sum_t += t;
    sum_dd += d * d;
    sum_dt += d * t;
  }
  const double below = 30.0 * sum_dd - sum_d * sum_d;
  const auto correction = fit_correction(distances);
  ASSERT_TRUE(correction);
  EXPECT_NEAR(correction->offset_m, (sum_t * sum_dd - sum_d * sum_dt) / below, 1e-12);
  EXPECT_NEAR(correction->slope, (30.0 * sum_dt - sum_d * sum_t) / below, 1e-12);
}

TEST(OdometryCorrection, NeedsTwoDifferentDistances) {
  EXPECT_FALSE(fit_correction({}));
  EXPECT_FALSE(fit_correction(std::vector<MeasuredDistance>{{1.0, 0.9}}));
  EXPECT_FALSE(fit_correction(std::vector<MeasuredDistance>{{1.0, 0.9}, {1.0, 1.1}}));
  EXPECT_FALSE(fit_correction(std::vector<MeasuredDistance>{{1.0, 0.9}, {2.0, std::nan("")}}));
}

TEST(OdometryCorrection, IsTheSameBackwardsAndNothingStanding) {
  const DistanceCorrection correction{0.9, 0.02};
  EXPECT_NEAR(correction.corrected_m(1.0), 0.92, 1e-12);
  EXPECT_NEAR(correction.corrected_m(-1.0), -0.92, 1e-12);
  EXPECT_EQ(correction.corrected_m(0.0), 0.0);
}

}  // namespace
}  // namespace echomap::localization
