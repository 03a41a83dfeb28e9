// SPDX-License-Identifier: MIT
#include "host/localization/pose_ekf.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

using geometry::Pose2;

const Pose2 T_step(0.05, 0.0, 0.02);

PoseGaussian start() { return {{1.0, 2.0, 0.5}, 0.01 * Eigen::Matrix3d::Identity()}; }

/// Drives an arc with ten odometry poses a second, from 0 s on.
void drive(PoseEkf& filter, int from, int to) {
  Pose2 T_odom_robot;
  for (int i = 0; i <= to; ++i) {
    if (i >= from) {
      EXPECT_EQ(filter.move(0.1 * i, T_odom_robot), EkfOutcome::kApplied);
    }
    T_odom_robot = T_odom_robot * T_step;
  }
}

PoseFix fix_at(double stamp_s, const Pose2& T_map_robot) {
  return {stamp_s, T_map_robot, 0.0025 * Eigen::Matrix3d::Identity()};
}

void expect_same(const PoseGaussian& left, const PoseGaussian& right) {
  EXPECT_NEAR((left.T_map_robot.position_m() - right.T_map_robot.position_m()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(left.T_map_robot.heading_rad(), right.T_map_robot.heading_rad(), 1e-12);
  EXPECT_TRUE(left.covariance.isApprox(right.covariance, 1e-9));
}

TEST(PoseEkf, FollowsTheOdometryAndGrowsUnsure) {
  PoseEkf filter(start());
  drive(filter, 0, 1);
  const Pose2 expected = start().T_map_robot * T_step;
  EXPECT_NEAR(filter.belief().T_map_robot.x_m(), expected.x_m(), 1e-12);
  EXPECT_GT(filter.belief().covariance.trace(), start().covariance.trace());
}

TEST(PoseEkf, IsAsSureHoweverOftenTheOdometryReports) {
  PoseEkf often(start());
  PoseEkf seldom(start());
  for (int i = 0; i <= 1000; ++i) {
    const Pose2 T_odom_robot(0.002 * i, 0.0, 0.0);
    often.move(0.01 * i, T_odom_robot);
    if (i % 100 == 0) {
      seldom.move(0.01 * i, T_odom_robot);
    }
  }
  EXPECT_NEAR(often.belief().covariance(0, 0) / seldom.belief().covariance(0, 0), 1.0, 0.03);
  EXPECT_NEAR(often.belief().covariance(2, 2) / seldom.belief().covariance(2, 2), 1.0, 0.03);
}

TEST(PoseEkf, AFixPullsAndMakesSure) {
  PoseEkf filter(start());
  drive(filter, 0, 0);
  EXPECT_EQ(filter.update(fix_at(0.0, {1.1, 2.0, 0.5})), EkfOutcome::kApplied);
  EXPECT_NEAR(filter.belief().T_map_robot.x_m(), 1.08, 1e-9);
  EXPECT_LT(filter.belief().covariance.trace(), start().covariance.trace());
}

TEST(PoseEkf, ComesToTheSameBeliefInWhicheverOrderMeasurementsCome) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<PoseMeasurement> measurements;
  Pose2 T_map_robot = start().T_map_robot;
  for (int i = 0; i < 12; ++i) {
    const double stamp_s = 0.1 * i + 0.03;
    measurements.emplace_back(fix_at(stamp_s,
                                     {T_map_robot.x_m() + noise(random),
                                      T_map_robot.y_m() + noise(random),
                                      T_map_robot.heading_rad() + noise(random)}));
    LandmarkObservation seen;
    seen.stamp_s = stamp_s + 0.02;
    seen.landmark_m = T_map_robot * Eigen::Vector2d(2.0, 0.3);
    seen.range_m = std::hypot(2.0, 0.3) + noise(random);
    seen.bearing_rad = std::atan2(0.3, 2.0) + noise(random);
    measurements.emplace_back(seen);
    T_map_robot = T_map_robot * T_step;
  }
  PoseEkf in_order(start());
  drive(in_order, 0, 15);
  for (const PoseMeasurement& measurement : measurements) {
    in_order.update(measurement);
  }
  for (int round = 0; round < 20; ++round) {
    std::shuffle(measurements.begin(), measurements.end(), random);
    PoseEkf filter(start());
    drive(filter, 0, 8);
    for (std::size_t i = 0; i < 12; ++i) {
      filter.update(measurements[i]);
    }
    drive(filter, 9, 15);
    for (std::size_t i = 12; i < measurements.size(); ++i) {
      filter.update(measurements[i]);
    }
    expect_same(filter.belief(), in_order.belief());
  }
}

TEST(PoseEkf, HoldsAMeasurementUntilTheOdometryGetsThere) {
  PoseEkf filter(start());
  EXPECT_EQ(filter.update(fix_at(0.25, {1.1, 2.0, 0.5})), EkfOutcome::kHeld);
  drive(filter, 0, 2);
  EXPECT_EQ(filter.count(EkfOutcome::kGated) + filter.count(EkfOutcome::kApplied), 3U);
  const double before_x_m = filter.belief().T_map_robot.x_m();
  drive(filter, 3, 3);
  EXPECT_EQ(filter.count(EkfOutcome::kApplied), 5U);
  EXPECT_GT(filter.belief().T_map_robot.x_m(), before_x_m);
}

TEST(PoseEkf, RefusesOneMoreThanItMayHold) {
  PoseEkf filter(start(), {.max_held = 2});
  EXPECT_EQ(filter.update(fix_at(0.1, {})), EkfOutcome::kHeld);
  EXPECT_EQ(filter.update(fix_at(0.2, {})), EkfOutcome::kHeld);
  EXPECT_EQ(filter.update(fix_at(0.3, {})), EkfOutcome::kTooManyHeld);
}

TEST(PoseEkf, TellsWhatIsOlderThanTheHistory) {
  PoseEkf filter(start(), {.history_s = 0.5});
  drive(filter, 0, 20);
  const PoseGaussian before = filter.belief();
  EXPECT_EQ(filter.update(fix_at(1.4, before.T_map_robot)), EkfOutcome::kTooOld);
  expect_same(filter.belief(), before);
  EXPECT_NE(filter.update(fix_at(1.55, before.T_map_robot)), EkfOutcome::kTooOld);
}

TEST(PoseEkf, DoesNotBelieveWhatIsBeyondTheGate) {
  PoseEkf filter(start());
  drive(filter, 0, 0);
  EXPECT_EQ(filter.update(fix_at(0.0, {3.0, 2.0, 0.5})), EkfOutcome::kGated);
  EXPECT_EQ(filter.update(LandmarkObservation{.landmark_m = {3.0, 2.0}, .range_m = 6.0}),
            EkfOutcome::kGated);
  expect_same(filter.belief(), start());
}

TEST(PoseEkf, NamesWhatItRefusesAndStaysAsItWas) {
  const double nan = std::nan("");
  PoseEkf filter(start());
  drive(filter, 0, 0);
  EXPECT_EQ(filter.move(0.0, T_step), EkfOutcome::kTimeRanBack);
  EXPECT_EQ(filter.move(-1.0, T_step), EkfOutcome::kTimeRanBack);
  EXPECT_EQ(filter.move(nan, T_step), EkfOutcome::kNotFinite);
  EXPECT_EQ(filter.move(1.0, {nan, 0.0, 0.0}), EkfOutcome::kNotFinite);
  EXPECT_EQ(filter.update(fix_at(nan, {})), EkfOutcome::kNotFinite);
  EXPECT_EQ(filter.update(PoseFix{0.0, {}, Eigen::Matrix3d::Zero()}), EkfOutcome::kBadCovariance);
  EXPECT_EQ(filter.update(LandmarkObservation{.range_m = -1.0}), EkfOutcome::kBadRange);
  EXPECT_EQ(filter.update(LandmarkObservation{.landmark_m = {1.0, 2.0}, .range_m = 1.0}),
            EkfOutcome::kAtLandmark);
  expect_same(filter.belief(), start());
  EXPECT_EQ(filter.count(EkfOutcome::kTimeRanBack), 2U);
  EXPECT_EQ(filter.count(EkfOutcome::kNotFinite), 3U);
}

TEST(PoseEkf, OdometryThatCameLateLosesNothing) {
  PoseEkf filter(start());
  drive(filter, 0, 4);
  filter.move(0.25, T_step);
  drive(filter, 5, 10);
  PoseEkf undisturbed(start());
  drive(undisturbed, 0, 10);
  expect_same(filter.belief(), undisturbed.belief());
}

TEST(PoseEkf, IsAsSureAsItShouldBe) {
  // Mean of chi square with three degrees of freedom over 300 independent drives: 3 +- 0.28.
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  double nees = 0.0;
  const models::OdometryMotion motion;
  for (int run = 0; run < 300; ++run) {
    const auto off = [&](double std_dev) { return std_dev * normal(random); };
    Pose2 T_map_robot(1.0 + off(0.1), 2.0 + off(0.1), 0.5 + off(0.1));
    PoseEkf filter(start());
    Pose2 T_odom_robot;
    for (int i = 0; i < 40; ++i) {
      filter.move(0.1 * i, T_odom_robot);
      if (i % 10 == 9) {
        filter.update(fix_at(0.1 * i,
                             {T_map_robot.x_m() + off(0.05),
                              T_map_robot.y_m() + off(0.05),
                              T_map_robot.heading_rad() + off(0.05)}));
      }
      const models::OdometryStep step = models::odometry_step({}, T_step);
      const models::MotionSpread spread = models::cut_step_spread(motion, step, {});
      T_odom_robot = T_odom_robot * T_step;
      T_map_robot = T_map_robot *
                    Pose2(0.0, 0.0, step.turn_before_rad + off(spread.turn_before_rad)) *
                    Pose2(step.drive_m + off(spread.drive_m),
                          off(spread.side_m),
                          step.turn_after_rad + off(spread.turn_after_rad));
    }
    filter.move(4.0, T_odom_robot);
    const Pose2 believed = filter.belief().T_map_robot;
    const Eigen::Vector3d error(believed.x_m() - T_map_robot.x_m(),
                                believed.y_m() - T_map_robot.y_m(),
                                believed.heading_rad() - T_map_robot.heading_rad());
    nees += error.dot(filter.belief().covariance.llt().solve(error)) / 300.0;
  }
  EXPECT_NEAR(nees, 3.0, 0.4);
}

TEST(PoseEkf, RefusesAStartAndSettingsWithoutSense) {
  EXPECT_THROW(PoseEkf({{}, Eigen::Matrix3d::Zero()}), std::invalid_argument);
  EXPECT_THROW(PoseEkf({{std::nan(""), 0.0, 0.0}, start().covariance}), std::invalid_argument);
  EXPECT_THROW(PoseEkf(start(), {.gate_of_two = 0.0}), std::invalid_argument);
  EXPECT_THROW(PoseEkf(start(), {.whole_step = {.drive_m = 0.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
