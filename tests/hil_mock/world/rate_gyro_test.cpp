// SPDX-License-Identifier: MIT
#include "hil_mock/world/rate_gyro.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/hil_mock/world/steps.hpp"

namespace echomap::world {
namespace {

GyroParams quiet() { return {0.0, 0.0, 0.0, 0.0}; }

NoiseStream noise(std::uint32_t seed) { return {seed, NoisePurpose::kGyro}; }

/// Angle error after 20 s at rest, in degrees, with the bias of the start taken off.
double drift_deg(const GyroParams& params, std::uint32_t seed) {
  RateGyro gyro(params, noise(seed));
  const double bias_deg_per_s = gyro.bias_deg_per_s();
  double angle_deg = 0.0;
  for (int i = 0; i < 20000; ++i) {
    gyro.step(kStepS, 0.0, 42.0);
    angle_deg += (gyro.rate_deg_per_s() - bias_deg_per_s) * kStepS;
  }
  return angle_deg;
}

double standard_deviation(const GyroParams& params) {
  double sum_of_squares = 0.0;
  constexpr int kSeeds = 60;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    sum_of_squares += std::pow(drift_deg(params, seed), 2);
  }
  return std::sqrt(sum_of_squares / kSeeds);
}

TEST(RateGyro, WithoutErrorsItGivesTheRate) {
  RateGyro gyro(quiet(), noise(1));
  for (int i = 0; i < 100; ++i) {
    gyro.step(kStepS, 1.0, 256.0);
  }
  EXPECT_NEAR(gyro.rate_deg_per_s(), 57.29578, 1e-5);
}

TEST(RateGyro, TheFilterTakesItsTime) {
  RateGyro gyro(quiet(), noise(1));
  const double time_constant_s = 1.0 / (2.0 * std::numbers::pi * 42.0);
  for (int i = 0; i < std::lround(time_constant_s / kStepS * 1.0); ++i) {
    gyro.step(kStepS, 1.0, 42.0);
  }
  EXPECT_NEAR(gyro.rate_deg_per_s() / 57.29578, 1.0 - std::exp(-1.0), 0.04);
}

TEST(RateGyro, BiasAndScaleAreDrawnForEachRun) {
  GyroParams params = quiet();
  params.bias_stddev_deg_per_s = 2.0;
  double sum_of_squares = 0.0;
  for (std::uint32_t seed = 1; seed <= 1000; ++seed) {
    sum_of_squares += std::pow(RateGyro(params, noise(seed)).bias_deg_per_s(), 2);
  }
  EXPECT_NEAR(std::sqrt(sum_of_squares / 1000.0), 2.0, 0.15);
}

TEST(RateGyro, WhiteNoiseMakesTheAngleWalkByItsDensity) {
  GyroParams params = quiet();
  params.noise_deg_per_s_per_sqrt_hz = 0.005;
  EXPECT_NEAR(standard_deviation(params), 0.005 * std::sqrt(20.0 / 2.0), 0.004);
}

TEST(RateGyro, AWanderingBiasMakesTheAngleWalkFaster) {
  GyroParams params = quiet();
  params.bias_walk_deg_per_s_per_sqrt_s = 0.002;
  EXPECT_NEAR(standard_deviation(params), 0.002 * std::sqrt(std::pow(20.0, 3) / 3.0), 0.025);
}

}  // namespace
}  // namespace echomap::world
