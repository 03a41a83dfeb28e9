// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/ray_casting.hpp"
#include "host/pipeline/robot_localizer.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/expect_pose_estimate.hpp"
#include "tests/support/furnished_room.hpp"

namespace echomap::pipeline {
namespace {

using geometry::Pose2;

const mapping::RasterMap kFurnishedRoom = tests::furnished_room();

/// A laser of 36 beams, 0.1 m before the middle of the robot; a wall stands in the middle of its
/// cells.
sensors::RangeScan scan_at(const Pose2& T_map_robot, double stamp_s) {
  const mapping::DistanceField field(kFurnishedRoom, 10.0);
  const Pose2 T_robot_sensor(0.1, 0.0, 0.0);
  const Pose2 T_map_sensor = T_map_robot * T_robot_sensor;
  sensors::RangeScan scan;
  scan.stamp_s = stamp_s;
  scan.T_robot_sensor = T_robot_sensor;
  scan.max_range_m = 10.0;
  scan.is_light = true;
  for (int i = 0; i < 36; ++i) {
    const double bearing_rad = std::numbers::pi * (i / 18.0 - 1.0);
    const Eigen::Vector2f direction =
        geometry::unit_vector(T_map_sensor.heading_rad() + bearing_rad).cast<float>();
    float range_m = 0.0F;
    mapping::cast_rays(field, T_map_sensor.position_m(), {&direction, 1}, 10.0, {&range_m, 1});
    scan.beams.push_back({bearing_rad, static_cast<double>(range_m) + 0.05});
  }
  return scan;
}

/// Drives 1.2 m through the room; the odometry begins elsewhere. Returns where it ends.
Pose2 drive(RobotLocalizer& localizer) {
  const Pose2 T_map_odom(0.6, 0.2, 0.4);
  Pose2 T_map_robot(0.45, 0.95, 0.1);
  for (int i = 0; i < 12; ++i) {
    const double stamp_s = 0.5 * i;
    localizer.on_odometry_pose({time::robot_time(stamp_s), T_map_odom.inverse() * T_map_robot});
    localizer.on_range_scan(scan_at(T_map_robot, stamp_s));
    T_map_robot = T_map_robot * Pose2(0.11, 0.0, 0.02);
  }
  return T_map_robot * Pose2(0.11, 0.0, 0.02).inverse();
}

TEST(RangeScanLocalizer, FindsARobotByItsRangeScans) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  const Pose2 truth = drive(localizer);
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), truth, 0.1, 0.1));
  EXPECT_EQ(localizer.scans(), 12U);
  EXPECT_EQ(localizer.updates(), localizer.trajectory().size());
  EXPECT_GE(localizer.updates(), 11U);
}

TEST(RangeScanLocalizer, BeginsWhereItIsTold) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  localizer.start_at({0.45, 0.95, 0.1}, 0.05, 0.05);
  localizer.on_range_scan(scan_at({0.45, 0.95, 0.1}, 0.0));
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), {0.45, 0.95, 0.1}, 0.05, 0.05));
  EXPECT_EQ(localizer.belief().status, localization::LocalizationStatus::kLocalized);
}

TEST(RangeScanLocalizer, WaitsUntilTheRobotHasMoved) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  for (int i = 0; i < 5; ++i) {
    localizer.on_range_scan(scan_at({0.45, 0.95, 0.1}, 0.1 * i));
  }
  EXPECT_EQ(localizer.updates(), 1U);
  EXPECT_EQ(localizer.scans(), 5U);
}

TEST(RangeScanLocalizer, CountsScansOfAnotherSensor) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  localizer.on_range_scan(scan_at({0.45, 0.95, 0.1}, 0.0));
  sensors::RangeScan sonar = scan_at({0.45, 0.95, 0.1}, 0.1);
  sonar.beam_width_rad = 0.5;
  localizer.on_range_scan(sonar);
  EXPECT_EQ(localizer.unused_scans(), 1U);
}

TEST(RangeScanLocalizer, KnowsNothingWithoutRanges) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  localizer.on_odometry_pose({});
  EXPECT_TRUE(localizer.belief().hypotheses.empty());
  EXPECT_TRUE(localizer.trajectory().empty());
}

TEST(RangeScanLocalizer, TakesWheelsAndContactsBeforeItKnowsItsSensor) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  localizer.start_at({0.45, 0.95, 0.1}, 0.05, 0.05);
  localizer.on_odometry({time::robot_time(0.1), {0.3, 0.3}});
  sensors::HazardObservation bump;
  bump.bump_left = true;
  localizer.on_hazards(bump);
  EXPECT_TRUE(localizer.belief().hypotheses.empty());
  localizer.on_range_scan(scan_at({0.45, 0.95, 0.1}, 0.2));
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), {0.45, 0.95, 0.1}, 0.05, 0.05));
}

TEST(RangeScanLocalizer, LeavesOutScansWhenTimeRunsBackwards) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  const Pose2 truth = drive(localizer);
  const std::size_t updates = localizer.updates();
  localizer.on_odometry_pose({time::robot_time(9.0), {1.0, 1.0, 1.0}});
  for (const double stamp_s : {1.0, -5.0, std::numeric_limits<double>::quiet_NaN()}) {
    localizer.on_range_scan(scan_at({2.0, 0.3, 1.0}, stamp_s));
    EXPECT_EQ(localizer.belief().outcome, localization::LocalizerOutcome::kTimeRanBack);
  }
  EXPECT_EQ(localizer.late_scans(), 3U);
  EXPECT_EQ(localizer.updates(), updates);
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), truth, 0.1, 0.1));
}

TEST(RangeScanLocalizer, SaysThatAStartIsOffTheMap) {
  RobotLocalizer localizer(kFurnishedRoom, {}, {}, std::mt19937(1));
  localizer.start_at({50.0, 50.0, 0.0}, 0.1, 0.1);
  const Pose2 truth = drive(localizer);
  EXPECT_EQ(localizer.start_outcome(), localization::LocalizerOutcome::kOffTheFloor);
  EXPECT_TRUE(tests::is_estimated_near(localizer.belief(), truth, 0.1, 0.1));
}

TEST(RangeScanLocalizer, RejectsInvalidParameters) {
  RobotLocalizerParams params;
  params.scan_step_m = 0.0;
  EXPECT_THROW(RobotLocalizer(kFurnishedRoom, {}, params, std::mt19937(1)), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::pipeline
