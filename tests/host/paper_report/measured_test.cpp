// SPDX-License-Identifier: MIT
#include "host/paper_report/measured.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::paper_report {
namespace {

// By hand, with z = 1.96 and z² / n = 0.064025: centre (0.83333 + 0.03201) / 1.06402 = 0.81328,
// half the width 1.95996 / 1.06402 * sqrt(0.0023148 + 0.0002668) = 0.09359.
TEST(MeasuredShare, HasWilsonsInterval) {
  const Measured share = measured_share(50, 60);
  EXPECT_DOUBLE_EQ(share.value, 50.0 / 60.0);
  EXPECT_NEAR(share.low, 0.7197, 1e-4);
  EXPECT_NEAR(share.high, 0.9069, 1e-4);
  EXPECT_EQ(share.runs, 60U);
}

// z² / (n + z²) = 3.84146 / 13.84146.
TEST(MeasuredShare, OfNoneAndOfAllHaveOneSidedIntervals) {
  const Measured none = measured_share(0, 10);
  EXPECT_EQ(none.value, 0.0);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.27753, 1e-5);
  const Measured all = measured_share(10, 10);
  EXPECT_EQ(all.value, 1.0);
  EXPECT_NEAR(all.low, 1.0 - 0.27753, 1e-5);
  EXPECT_EQ(all.high, 1.0);
}

TEST(MeasuredShare, LiesInItsIntervalWhichIsWithin0And1) {
  for (std::size_t runs = 1; runs <= 60; ++runs) {
    for (std::size_t successes = 0; successes <= runs; ++successes) {
      const Measured share = measured_share(successes, runs);
      EXPECT_TRUE(0.0 <= share.low && share.low <= share.value && share.value <= share.high &&
                  share.high <= 1.0)
          << successes << " of " << runs;
      EXPECT_LT(share.low, share.high);
    }
  }
}

// Mean 3, standard deviation sqrt(10 / 4), Student's t 2.7764 with 4 degrees of freedom:
// 2.7764 * 1.58114 / sqrt(5) = 1.96324.
TEST(MeasuredMean, HasStudentsInterval) {
  const Measured mean = measured_mean(std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_DOUBLE_EQ(mean.value, 3.0);
  EXPECT_NEAR(mean.low, 1.03676, 1e-5);
  EXPECT_NEAR(mean.high, 4.96324, 1e-5);
  EXPECT_EQ(mean.runs, 5U);
}

// Student's t is 12.7062 with 1 degree of freedom; standard deviation sqrt(2), over sqrt(2) is 1.
TEST(MeasuredMean, TwoValuesIsWide) {
  const Measured mean = measured_mean(std::vector<double>{-1.0, 1.0});
  EXPECT_NEAR(mean.low, -12.7062, 1e-4);
  EXPECT_NEAR(mean.high, 12.7062, 1e-4);
}

TEST(MeasuredMean, OneValueIsThatValue) {
  EXPECT_EQ(measured_mean(std::vector<double>{6.2}),
            (Measured{.value = 6.2, .low = 6.2, .high = 6.2, .runs = 1}));
}

TEST(Measured, WithoutRunsIsNotANumber) {
  for (const Measured& measured : {measured_share(0, 0), measured_mean({})}) {
    EXPECT_TRUE(std::isnan(measured.value));
    EXPECT_TRUE(std::isnan(measured.low));
    EXPECT_TRUE(std::isnan(measured.high));
    EXPECT_EQ(measured.runs, 0U);
    EXPECT_EQ(text_of(measured, "cm", 1), "no runs");
  }
}

TEST(Measured, IsScaledWithItsInterval) {
  EXPECT_EQ(scaled({.value = 0.5, .low = 0.25, .high = 0.75, .runs = 8}, 100.0),
            (Measured{.value = 50.0, .low = 25.0, .high = 75.0, .runs = 8}));
}

TEST(TextOf, HasValueUnitIntervalAndRuns) {
  EXPECT_EQ(text_of({.value = 6.24, .low = 5.06, .high = 7.31, .runs = 20}, "cm", 1),
            "6.2 cm (5.1 to 7.3), 20 runs");
  EXPECT_EQ(text_of(scaled(measured_share(50, 60), 60.0), "of 60", 0),
            "50 of 60 (43 to 54), 60 runs");
  EXPECT_EQ(text_of({.value = 3.0, .low = 2.0, .high = 4.0, .runs = 2}, "", 0),
            "3 (2 to 4), 2 runs");
}

TEST(TextOf, OneRunHasNoInterval) {
  EXPECT_EQ(text_of(measured_mean(std::vector<double>{6.2}), "cm", 1), "6.2 cm, 1 run");
}

TEST(TextOf, WhatRoundsToZeroHasNoSign) {
  EXPECT_EQ(text_of({.value = -0.04, .low = -0.06, .high = -0.02, .runs = 3}, "m", 1),
            "0.0 m (-0.1 to 0.0), 3 runs");
}

TEST(TextOf, NegativeDecimalsAreNone) {
  EXPECT_EQ(value_text({.value = 12.4, .low = 12.4, .high = 12.4, .runs = 1}, "cm", -1), "12 cm");
}

TEST(TextOf, IsValueAndInterval) {
  const Measured measured = measured_mean(std::vector<double>{1.0, 2.0, 3.0});
  EXPECT_EQ(text_of(measured, "m", 2), value_text(measured, "m", 2) + interval_text(measured, 2));
}

}  // namespace
}  // namespace echomap::paper_report
