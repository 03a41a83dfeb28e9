// SPDX-License-Identifier: MIT
#include "host/models/gaussian_range.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::models {
namespace {

static_assert(RangeLikelihood<GaussianRange>);

TEST(GaussianRange, IsADensityOfTheRange) {
  const GaussianRange model;
  double total = 0.0;
  for (double range_m = 0.0; range_m < 2.0; range_m += 1e-4) {
    total += 1e-4 * model.likelihood(range_m, {1.0, false});
  }
  EXPECT_NEAR(total, 1.0, 1e-6);
}

TEST(GaussianRange, FallsAsEquationOneSays) {
  const GaussianRange model;
  const double at_it = model.likelihood(1.0, {1.0, false});
  EXPECT_NEAR(at_it, 1.0 / (0.03 * 2.5066283), 1e-6);
  EXPECT_NEAR(model.likelihood(1.03, {1.0, false}) / at_it, std::exp(-0.5), 1e-12);
  EXPECT_NEAR(model.likelihood(0.94, {1.0, false}) / at_it, std::exp(-2.0), 1e-12);
}

TEST(GaussianRange, SilenceSaysNothing) {
  const GaussianRange model;
  EXPECT_EQ(model.likelihood({}, {1.0, false}), 1.0);
  EXPECT_EQ(model.likelihood({}, {}), 1.0);
}

TEST(GaussianRange, NothingInTheMapIsAsFarAsTheSonarHears) {
  const GaussianRange model;
  EXPECT_EQ(model.likelihood(2.5, {}), model.likelihood(2.5, {2.55, false}));
}

TEST(GaussianRange, RefusesParametersWithoutSense) {
  EXPECT_THROW(GaussianRange({.sense_stddev_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(GaussianRange({.max_range_m = std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::models
