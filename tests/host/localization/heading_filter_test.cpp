// SPDX-License-Identifier: MIT
#include "host/localization/heading_filter.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

constexpr double kPeriodS = 0.02;

/// A robot with a gyro that drifts and wheels that slip.
class TurningRobot {
 public:
  explicit TurningRobot(std::uint32_t seed) : random_(seed) {}

  HeadingStep turn(double rate_rad_per_s) {
    const double turn_rad = rate_rad_per_s * kPeriodS;
    heading_rad_ = geometry::wrap_angle(heading_rad_ + turn_rad);
    return {kPeriodS,
            turn_rad + bias_rad_per_s * kPeriodS + 1e-3 * std::sqrt(kPeriodS) * normal_(random_),
            turn_rad * (1.0 + 0.1 * normal_(random_))};
  }
  double heading_rad() const { return heading_rad_; }

  double bias_rad_per_s = 0.03;

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  double heading_rad_ = 0.0;
};

TEST(HeadingFilter, ARobotThatStandsCalibratesItsGyro) {
  TurningRobot robot(1);
  HeadingFilter filter;
  for (int i = 0; i < 250; ++i) {
    EXPECT_EQ(filter.update(robot.turn(0.0)), HeadingOutcome::kApplied);
  }
  EXPECT_NEAR(filter.bias_rad_per_s(), 0.03, 0.002);
  EXPECT_NEAR(filter.heading_rad(), 0.0, 0.03);
}

TEST(HeadingFilter, IsBetterThanGyroOrWheelsAlone) {
  double filter_off = 0.0, gyro_off = 0.0, wheels_off = 0.0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    TurningRobot robot(seed);
    HeadingFilter filter;
    double gyro_rad = 0.0, wheels_rad = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const HeadingStep step = robot.turn(i % 500 < 250 ? 0.0 : 1.0);
      filter.update(step);
      gyro_rad += step.gyro_turn_rad;
      wheels_rad += 1.05 * step.wheel_turn_rad;
    }
    const auto off = [&](double heading_rad) {
      return std::abs(
          geometry::angle_between(geometry::wrap_angle(heading_rad), robot.heading_rad()));
    };
    filter_off += off(filter.heading_rad()) / 20.0;
    gyro_off += off(gyro_rad) / 20.0;
    wheels_off += off(wheels_rad) / 20.0;
  }
  EXPECT_LT(filter_off, 0.1 * gyro_off);
  EXPECT_LT(filter_off, 0.2 * wheels_off);
}

TEST(HeadingFilter, BelievesWheelsTheLessTheFartherTheyRolled) {
  HeadingFilterParams params;
  params.wheel_rad_per_root_m = 0.02;
  const auto bias_after = [&](double forward_m) {
    HeadingFilter filter(params);
    filter.update({13.0, 0.0, 0.0});
    filter.update({4.0, 0.005, 0.0, forward_m});
    return filter.bias_rad_per_s();
  };
  EXPECT_LT(std::abs(bias_after(1.0)), 0.3 * std::abs(bias_after(0.0)));
  EXPECT_EQ(bias_after(-1.0), bias_after(1.0));
}

TEST(HeadingFilter, ItsErrorIsWithinThreeSigma) {
  int outside = 0;
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    TurningRobot robot(seed);
    HeadingFilter filter;
    for (int i = 0; i < 1000; ++i) {
      filter.update(robot.turn(0.5));
    }
    const double off_rad = geometry::angle_between(filter.heading_rad(), robot.heading_rad());
    outside += std::abs(off_rad) > 3.0 * std::sqrt(filter.covariance()(0, 0)) ? 1 : 0;
    EXPECT_GT(filter.covariance().determinant(), 0.0) << seed;
  }
  EXPECT_LE(outside, 1);
}

TEST(HeadingFilter, TrustsTheGyroWhereWheelsSlip) {
  TurningRobot robot(1);
  HeadingFilter filter;
  for (int i = 0; i < 500; ++i) {
    filter.update(robot.turn(0.0));
  }
  const double before_rad = filter.heading_rad();
  EXPECT_EQ(filter.update({kPeriodS, 0.03 * kPeriodS, 0.0}), HeadingOutcome::kApplied);
  EXPECT_EQ(filter.update({kPeriodS, 0.5, 0.0}), HeadingOutcome::kWheelsSlipped);
  EXPECT_NEAR(filter.heading_rad() - before_rad, 0.5, 0.01);
}

TEST(HeadingFilter, RefusesTimeThatStandsOrRunsBackAndNumbersThatAreNone) {
  HeadingFilter filter;
  EXPECT_EQ(filter.update({0.0, 0.1, 0.1}), HeadingOutcome::kBadTime);
  EXPECT_EQ(filter.update({-1.0, 0.1, 0.1}), HeadingOutcome::kBadTime);
  EXPECT_EQ(filter.update({1.0, std::nan(""), 0.1}), HeadingOutcome::kNotFinite);
  EXPECT_EQ(filter.heading_rad(), 0.0);
}

TEST(HeadingFilter, RefusesSettingsWithoutSense) {
  EXPECT_THROW(HeadingFilter({.wheel_floor_rad = 0.0}), std::invalid_argument);
  EXPECT_THROW(HeadingFilter({.gyro_rad_per_root_s = -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
