// SPDX-License-Identifier: MIT
#include "host/models/uniform_sum.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

TEST(UniformSum, DeviatesByAThirdAndIsNearlyNormal) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  constexpr int kSamples = 200'000;
  constexpr double kB = 0.6;
  double sum = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  int within = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double value = uniform_sum_sample(kB, [&] { return uniform(random); });
    sum += value;
    squares += value * value;
    fourths += std::pow(value, 4);
    within += std::abs(value) < uniform_sum_stddev(kB) ? 1 : 0;
  }
  const double variance = squares / kSamples;
  EXPECT_NEAR(sum / kSamples, 0.0, 0.002);
  EXPECT_NEAR(std::sqrt(variance), 0.2, 0.002);
  EXPECT_NEAR(static_cast<double>(within) / kSamples, 0.683, 0.005);
  // Of a sum of 12: 3 - 1.2 / 12.
  EXPECT_NEAR(fourths / kSamples / (variance * variance), 2.9, 0.05);
}

TEST(UniformSum, NeverLeavesTwiceB) {
  EXPECT_DOUBLE_EQ(uniform_sum_sample(0.3, [] { return 0.0; }), -0.6);
  EXPECT_DOUBLE_EQ(uniform_sum_sample(0.3, [] { return 1.0; }), 0.6);
  EXPECT_DOUBLE_EQ(uniform_sum_sample(0.3, [] { return 0.5; }), 0.0);
}

TEST(UniformSum, KnowsItsBAgain) { EXPECT_DOUBLE_EQ(uniform_sum_b(uniform_sum_stddev(0.7)), 0.7); }

}  // namespace
}  // namespace echomap::models
