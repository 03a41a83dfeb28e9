// SPDX-License-Identifier: MIT
#include "host/sensors/odometry.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

using geometry::Pose2;
using std::numbers::pi;
constexpr double kTrackM = 0.14;

void expect_near(const Pose2& actual, const Pose2& expected, double tolerance) {
  EXPECT_NEAR(actual.x_m(), expected.x_m(), tolerance);
  EXPECT_NEAR(actual.y_m(), expected.y_m(), tolerance);
  const Pose2 difference = actual.inverse() * expected;
  EXPECT_NEAR(difference.heading_rad(), 0.0, tolerance);
}

/// Drives by wheel distances since the last call.
struct Driver {
  WheelOdometry odometry{kTrackM};
  WheelTravel travel;

  void roll(double left_m, double right_m) {
    travel = {travel.left_m + left_m, travel.right_m + right_m};
    odometry.update(travel);
  }
  void straight(double distance_m) { roll(distance_m, distance_m); }
  void turn(double turn_rad) { roll(-turn_rad * kTrackM / 2.0, turn_rad * kTrackM / 2.0); }
  const Pose2& pose() const { return odometry.T_odom_robot(); }
};

TEST(WheelOdometry, StartsAtTheOrigin) { expect_near(Driver{}.pose(), Pose2(), 0.0); }

TEST(WheelOdometry, GoesForwardAlongX) {
  Driver robot;
  robot.straight(1.5);
  expect_near(robot.pose(), Pose2(1.5, 0.0, 0.0), 1e-12);
}

TEST(WheelOdometry, TurnsLeftWhenTheRightWheelRollsFarther) {
  Driver robot;
  robot.turn(pi / 3.0);
  expect_near(robot.pose(), Pose2(0.0, 0.0, pi / 3.0), 1e-12);
}

TEST(WheelOdometry, ReturnsToTheStartOfAClosedSquareEitherWayRound) {
  for (const double turn_rad : {pi / 2.0, -pi / 2.0}) {
    Driver robot;
    for (int side = 0; side < 4; ++side) {
      robot.straight(2.0);
      robot.turn(turn_rad);
    }
    expect_near(robot.pose(), Pose2(), 1e-9);
  }
}

TEST(WheelOdometry, IsExactOnAnArcHoweverItIsCut) {
  const double radius_m = 0.8;
  const double turn_rad = 1.9;
  const Pose2 end(radius_m * std::sin(turn_rad), radius_m * (1.0 - std::cos(turn_rad)), turn_rad);
  for (const int cuts : {1, 2, 7, 1000}) {
    Driver robot;
    for (int i = 0; i < cuts; ++i) {
      robot.roll((radius_m - kTrackM / 2.0) * turn_rad / cuts,
                 (radius_m + kTrackM / 2.0) * turn_rad / cuts);
    }
    expect_near(robot.pose(), end, 1e-9);
  }
}

TEST(WheelOdometry, IsContinuousWhereTheArcBecomesALine) {
  for (const double turn_rad : {1e-3, 1e-5, 2.1e-6, 1.9e-6, 1e-9, 0.0}) {
    Driver robot;
    robot.roll(1.0 - turn_rad * kTrackM / 2.0, 1.0 + turn_rad * kTrackM / 2.0);
    expect_near(
        robot.pose(), Pose2(1.0 - turn_rad * turn_rad / 6.0, turn_rad / 2.0, turn_rad), 1e-9);
  }
}

TEST(WheelOdometry, RollsBackAlongTheWayItCame) {
  std::mt19937 random(3);
  const auto roll_m = [&] { return (static_cast<double>(random() % 2001) - 1000.0) * 1e-4; };
  Driver robot;
  std::vector<WheelTravel> path;
  for (int i = 0; i < 1000; ++i) {
    path.push_back(robot.travel);
    robot.roll(roll_m(), roll_m());
  }
  for (; !path.empty(); path.pop_back()) {
    robot.odometry.update(path.back());
  }
  expect_near(robot.pose(), Pose2(), 1e-9);
}

TEST(ArcStep, IsAQuarterOfACircleAfterAQuarterTurn) {
  const double right_angle_rad = std::numbers::pi / 2.0;
  expect_near(arc_step(right_angle_rad, right_angle_rad), Pose2(1.0, 1.0, right_angle_rad), 1e-12);
  expect_near(arc_step(-2.0, 0.0), Pose2(-2.0, 0.0, 0.0), 0.0);
}

TEST(WheelOdometry, GoesOnFromWhereTheRobotWasCarriedTo) {
  WheelOdometry odometry(0.2);
  odometry.update({1.0, 1.0});
  odometry.move_to(Pose2(5.0, 6.0, std::numbers::pi / 2.0), {3.0, 2.0});
  expect_near(odometry.update({3.5, 2.5}), Pose2(5.0, 6.5, std::numbers::pi / 2.0), 1e-12);
}

TEST(WheelOdometry, RefusesATrackThatIsNone) {
  EXPECT_THROW(WheelOdometry{0.0}, std::invalid_argument);
  EXPECT_THROW(WheelOdometry{-0.1}, std::invalid_argument);
  EXPECT_THROW(WheelOdometry{std::numeric_limits<double>::infinity()}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::sensors
