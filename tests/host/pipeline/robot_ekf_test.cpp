// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_ekf.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/odometry.hpp"
#include "tests/host/pipeline/plain_robot.hpp"

namespace echomap::pipeline {
namespace {

using geometry::Pose2;
using localization::EkfOutcome;

constexpr double kPeriodS = 0.02;

localization::PoseFix fix_at(double stamp_s, const Pose2& T_map_robot) {
  const Eigen::Vector3d variances(1e-4, 1e-4, 1e-4);
  return {stamp_s, T_map_robot, variances.asDiagonal()};
}

/// A robot of which the test tells the story; its left wheel rolls farther than it says.
class RobotEkfTest : public ::testing::Test {
 protected:
  /// For so many steps of 20 ms.
  void drive(int steps, double speed_m_per_s, double turn_rad_per_s) {
    for (int i = 0; i < steps; ++i) {
      now_s += kPeriodS;
      const double arc_m = speed_m_per_s * kPeriodS;
      const double turn_rad = turn_rad_per_s * kPeriodS;
      T_map_robot = T_map_robot * sensors::arc_step(arc_m, turn_rad);
      travel.left_m += left_share * (arc_m - 0.1 * turn_rad);
      travel.right_m += arc_m + 0.1 * turn_rad;
      if (gyro) {
        yaw.yaw_rad += turn_rad + 0.03 * kPeriodS;
        yaw.measured_s += kPeriodS;
        ekf.on_yaw({stamp(), yaw});
      }
      ekf.on_odometry({stamp(), travel});
    }
  }
  time::RobotTime stamp() const {
    return time::RobotTime(time::RobotClock::duration(std::llround(now_s * 1e6)));
  }
  double error_m() const {
    return (ekf.belief()->T_map_robot.position_m() - T_map_robot.position_m()).norm();
  }
  double heading_error_rad() const {
    return std::abs(geometry::angle_between(ekf.belief()->T_map_robot.heading_rad(),
                                            T_map_robot.heading_rad()));
  }

  Pose2 T_map_robot{1.0, 0.5, 0.3};
  RobotEkf ekf{wide_robot()};
  double left_share = 0.97;
  bool gyro = false;
  double now_s = 0.0;
  sensors::Yaw yaw;
  sensors::WheelTravel travel{3.0, 2.0};
};

TEST_F(RobotEkfTest, StartsWithTheFirstFixAndFollowsByLateOnes) {
  drive(10, 0.0, 0.0);
  EXPECT_FALSE(ekf.belief());
  EXPECT_EQ(ekf.add(fix_at(now_s - 0.1, T_map_robot)), EkfOutcome::kApplied);
  drive(5, 0.0, 0.0);
  for (int i = 0; i < 100; ++i) {
    const auto late = fix_at(now_s, T_map_robot);
    drive(5, 0.2, 0.3);
    EXPECT_EQ(ekf.add(late), EkfOutcome::kApplied) << i;
  }
  EXPECT_LT(error_m(), 0.02);
  EXPECT_LT(heading_error_rad(), 0.03);
  EXPECT_EQ(ekf.applied(), 101U);
  EXPECT_EQ(ekf.trajectory().size(), 505U);
}

TEST_F(RobotEkfTest, TakesFixesInAnyOrder) {
  ekf.start_at({T_map_robot, Eigen::Matrix3d::Identity() * 1e-4});
  RobotEkf twin = ekf;
  std::vector<localization::PoseFix> fixes;
  drive(50, 0.2, 0.3);
  fixes.push_back(fix_at(now_s - 0.4, T_map_robot * Pose2(-0.08, 0.0, 0.0)));
  fixes.push_back(fix_at(now_s - 0.1, T_map_robot * Pose2(-0.02, 0.0, 0.0)));
  twin = ekf;
  ekf.add(fixes[0]);
  ekf.add(fixes[1]);
  twin.add(fixes[1]);
  twin.add(fixes[0]);
  EXPECT_NEAR(ekf.belief()->T_map_robot.x_m(), twin.belief()->T_map_robot.x_m(), 1e-9);
  EXPECT_NEAR(ekf.belief()->covariance(2, 2), twin.belief()->covariance(2, 2), 1e-12);
}

TEST_F(RobotEkfTest, TurnsByGyroAndWheelsTogether) {
  double error_rad[2] = {};
  for (const bool has_gyro : {false, true}) {
    SCOPED_TRACE(has_gyro);
    sensors::RobotGeometry robot = wide_robot();
    robot.track_m = 0.22;  // A tenth too wide: turns look too small.
    ekf = RobotEkf(robot);
    T_map_robot = Pose2();
    left_share = 1.0;
    gyro = has_gyro;
    ekf.start_at({T_map_robot, Eigen::Matrix3d::Identity() * 1e-4});
    drive(500, 0.0, 0.0);  // It stands, and the gyro's bias shows.
    for (int i = 0; i < 10; ++i) {
      drive(20, 0.0, 1.0);
      drive(100, 0.2, 0.0);
    }
    error_rad[has_gyro ? 1 : 0] = heading_error_rad();
  }
  EXPECT_GT(error_rad[0], 0.3);
  EXPECT_LT(error_rad[1], 0.6 * error_rad[0]);
}

TEST_F(RobotEkfTest, IsWhereManyFixesInARowSay) {
  drive(1, 0.0, 0.0);
  ekf.add(fix_at(now_s, T_map_robot));
  T_map_robot = Pose2(-2.0, 1.0, 2.0);
  for (int i = 0; i < 9; ++i) {
    drive(5, 0.0, 0.0);
    EXPECT_EQ(ekf.add(fix_at(now_s - 0.001, T_map_robot)), EkfOutcome::kGated) << i;
  }
  EXPECT_EQ(ekf.times_lost(), 0U);
  drive(5, 0.0, 0.0);
  EXPECT_EQ(ekf.add(fix_at(now_s + 0.01, T_map_robot)), EkfOutcome::kHeld);
  EXPECT_EQ(ekf.times_lost(), 0U) << "the odometry is not there";
  drive(1, 0.0, 0.0);
  EXPECT_EQ(ekf.times_lost(), 1U);
  EXPECT_LT(error_m(), 0.01);
}

TEST_F(RobotEkfTest, ForgetsWhereALiftedRobotWasAndHearsNoFixInTheAir) {
  drive(1, 0.0, 0.0);
  ekf.add(fix_at(now_s, T_map_robot));
  sensors::HazardObservation hazards;
  hazards.lifted = true;
  ekf.on_hazards(hazards);
  EXPECT_FALSE(ekf.belief());
  ekf.add(fix_at(now_s, T_map_robot));
  EXPECT_FALSE(ekf.belief());
  EXPECT_EQ(ekf.refused(), 1U);
  hazards.lifted = false;
  ekf.on_hazards(hazards);
  ekf.add(fix_at(now_s, Pose2(3.0, 3.0, 0.0)));
  EXPECT_EQ(ekf.belief()->T_map_robot.x_m(), 3.0);
}

TEST_F(RobotEkfTest, TakesFourCliffsForALift) {
  drive(1, 0.0, 0.0);
  ekf.add(fix_at(now_s, T_map_robot));
  sensors::HazardObservation hazards;
  hazards.cliffs = {true, true, true, false};
  ekf.on_hazards(hazards);
  EXPECT_TRUE(ekf.belief());
  hazards.cliffs.fill(true);
  ekf.on_hazards(hazards);
  EXPECT_FALSE(ekf.belief());
}

TEST_F(RobotEkfTest, StartsNotByAFixOfBeforeTheLanding) {
  drive(1, 0.0, 0.0);
  sensors::HazardObservation hazards;
  for (const bool is_lifted : {true, false}) {
    hazards.stamp = stamp();
    hazards.lifted = is_lifted;
    ekf.on_hazards(hazards);
    drive(10, 0.0, 0.0);
  }
  const double landed_s = now_s - 10 * kPeriodS;
  EXPECT_EQ(ekf.add(fix_at(landed_s - 0.01, T_map_robot)), EkfOutcome::kTooOld);
  EXPECT_FALSE(ekf.belief());
  EXPECT_EQ(ekf.refused(), 1U);
  EXPECT_EQ(ekf.add(fix_at(landed_s + 0.01, T_map_robot)), EkfOutcome::kApplied);
  EXPECT_TRUE(ekf.belief());
}

TEST_F(RobotEkfTest, RefusesWhatIsNoFix) {
  drive(1, 0.0, 0.0);
  auto bad = fix_at(now_s, T_map_robot);
  bad.covariance.setZero();
  ekf.add(bad);
  EXPECT_FALSE(ekf.belief());
  EXPECT_EQ(ekf.refused(), 1U);
  RobotEkfParams params;
  params.max_gated = 0;
  EXPECT_THROW(RobotEkf(wide_robot(), params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::pipeline
