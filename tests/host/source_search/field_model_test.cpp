// SPDX-License-Identifier: MIT
#include "host/source_search/field_model.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::source_search {
namespace {

TEST(FieldModel, FallsWithTheSquareOfTheDistance) {
  FieldParams params;
  params.standoff_m = 1e-6;
  EXPECT_NEAR(response(1.0, 0.0, 0.0, params), 1.0, 1e-9);
  EXPECT_NEAR(response(3.0, 0.0, 0.0, params), 1.0 / 9.0, 1e-9);
}

TEST(FieldModel, IsFiniteRightAboveTheSource) {
  FieldParams params;
  params.standoff_m = 0.1;
  EXPECT_NEAR(response(0.0, 0.0, 0.0, params), 100.0, 1e-9);
}

TEST(FieldModel, LosesTheSameFactorWithEachMetreOfSolid) {
  const FieldParams params;
  const double open = response(2.0, 0.0, 6.0, params);
  EXPECT_NEAR(response(2.0, 0.2, 6.0, params) / open, std::exp(-1.2), 1e-12);
  EXPECT_NEAR(response(2.0, 0.4, 6.0, params) / open, std::exp(-2.4), 1e-12);
}

TEST(FieldModel, RelativeVarianceIsThatOfPlacesInTheSquare) {
  FieldParams params;
  params.rate_error = 0.0;
  params.standoff_m = 0.01;
  const double distance_m = 1.0;
  const double half_m = 0.1;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i) {
    const double along_m = ((i + 0.5) / kSteps - 0.5) * 2.0 * half_m;
    const double value = response(distance_m + along_m, 0.0, 0.0, params);
    sum += value / kSteps;
    sum_of_squares += value * value / kSteps;
  }
  const double relative = sum_of_squares / (sum * sum) - 1.0;
  const double variance_m2 = half_m * half_m / 3.0;
  EXPECT_NEAR(
      response_variance(distance_m, 0.0, 0.0, variance_m2, params), relative, 0.1 * relative);
}

TEST(FieldModel, WhatIsShieldedIsLessWellKnown) {
  const FieldParams params;
  EXPECT_GT(response_variance(2.0, 0.2, 6.0, 0.0, params),
            response_variance(2.0, 0.0, 6.0, 0.0, params) + 0.1);
}

TEST(FieldModel, RefusesWhatIsOutOfRange) {
  FieldParams params;
  params.max_strength = params.min_strength;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.attenuations_per_m.clear();
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.attenuations_per_m = {-1.0};
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::source_search
