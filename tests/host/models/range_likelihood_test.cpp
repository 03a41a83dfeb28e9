// SPDX-License-Identifier: MIT
#include "host/models/range_likelihood.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

static_assert(RangeLikelihood<BeamModel>);

const BeamModel kSonar(sonar_cone_returns());

/// The integral over all ranges and the chance of no return.
double total(const BeamModel& model, std::optional<double> expected_m) {
  constexpr double kStepM = 1e-3;
  double sum = model.likelihood(std::nullopt, expected_m);
  for (double range_m = 0.5 * kStepM; range_m < model.max_range_m(); range_m += kStepM) {
    sum += kStepM * model.likelihood(range_m, expected_m);
  }
  return sum;
}

TEST(BeamModel, IsADensityWhateverIsExpected) {
  for (const double expected_m : {0.5, 1.0, 2.0, 3.5}) {
    EXPECT_NEAR(total(kSonar, expected_m), 1.0, 0.01) << expected_m;
  }
  EXPECT_NEAR(total(kSonar, std::nullopt), 1.0, 0.01);
}

TEST(BeamModel, FindsTheExpectedRangeLikeliest) {
  for (const double range_m : {0.5, 1.5, 1.9, 2.1, 3.0}) {
    EXPECT_GT(kSonar.likelihood(2.0, 2.0), kSonar.likelihood(range_m, 2.0)) << range_m;
  }
}

TEST(BeamModel, TakesSilenceForAHintAtNothing) {
  EXPECT_GT(kSonar.likelihood(std::nullopt, std::nullopt), 0.5);
  EXPECT_GT(kSonar.likelihood(std::nullopt, 2.0), 0.0);
  EXPECT_LT(kSonar.likelihood(std::nullopt, 2.0), kSonar.likelihood(std::nullopt, std::nullopt));
}

TEST(BeamModel, RefusesChancesThatLeaveNoHit) {
  EXPECT_THROW(BeamModel({.short_chance = 0.5, .missed_chance = 0.5}), std::invalid_argument);
  EXPECT_THROW(BeamModel({.silent_chance = -0.1}), std::invalid_argument);
  EXPECT_THROW(BeamModel({.hit_std_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(BeamModel({.max_range_m = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
