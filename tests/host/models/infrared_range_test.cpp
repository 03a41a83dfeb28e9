// SPDX-License-Identifier: MIT
#include "host/models/infrared_range.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

static_assert(RangeLikelihood<InfraredRange>);

constexpr double kStepM = 1e-5;

/// Of all ranges up to the greatest, and of silence.
double total(const InfraredRange& model, const ExpectedRange& expected) {
  double sum = model.likelihood({}, expected);
  for (double range_m = 0.5 * kStepM; range_m < 0.06; range_m += kStepM) {
    sum += kStepM * model.likelihood(range_m, expected);
  }
  return sum;
}

TEST(InfraredRange, ChancesAddUpToOne) {
  const InfraredRange model;
  EXPECT_NEAR(total(model, {}), 1.0, 1e-9);
  EXPECT_NEAR(total(model, {0.03, false}), 1.0, 1e-6);
  for (const double oblique_m : {0.001, 0.02, 0.05, 0.057, 0.06}) {
    EXPECT_NEAR(total(model, {oblique_m, true}), 1.0, 1e-6) << oblique_m;
  }
}

TEST(InfraredRange, IsSharpNearAndBroadFar) {
  const InfraredRange model;
  EXPECT_GT(model.likelihood(0.01, {0.01, false}), 1.5 * model.likelihood(0.055, {0.055, false}));
  EXPECT_LT(model.likelihood(0.02, {0.01, false}), 0.2 * model.likelihood(0.06, {0.05, false}));
}

TEST(InfraredRange, AWallAslantIsMostlySilentOrSeemsTooFar) {
  const InfraredRange model;
  EXPECT_GT(model.likelihood({}, {0.03, true}), 5.0 * model.likelihood({}, {0.03, false}));
  EXPECT_GT(model.likelihood(0.05, {0.03, true}), 5.0 * model.likelihood(0.01, {0.03, true}));
}

TEST(InfraredRange, RefusesChancesWithoutSense) {
  EXPECT_THROW(InfraredRange({.oblique_silent_chance = 1.0}), std::invalid_argument);
  EXPECT_THROW(InfraredRange({.random_chance = -0.1}), std::invalid_argument);
  EXPECT_THROW(InfraredRange({.near_stddev_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(InfraredRange({.max_range_m = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
