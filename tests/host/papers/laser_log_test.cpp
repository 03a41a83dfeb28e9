// SPDX-License-Identifier: MIT
#include "host/papers/laser_log.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::papers {
namespace {

using datasets::OdometryStep;
using geometry::Pose2;

/// A scan of a square room about the origin, 6 m wide, from a robot that is there.
sensors::RangeScan scan_of_square(const Pose2& T_world_robot) {
  sensors::RangeScan scan;
  scan.max_range_m = 30.0;
  for (int i = 0; i < 180; ++i) {
    const double bearing_rad = geometry::radians(i - 90.0);
    const double direction_rad = T_world_robot.heading_rad() + bearing_rad;
    const double along_x = std::cos(direction_rad);
    const double along_y = std::sin(direction_rad);
    const double to_x_m = (std::copysign(3.0, along_x) - T_world_robot.x_m()) / along_x;
    const double to_y_m = (std::copysign(3.0, along_y) - T_world_robot.y_m()) / along_y;
    scan.beams.push_back({bearing_rad, std::min(to_x_m, to_y_m)});
  }
  return scan;
}

/// Two scans with an increment between them that turns and drives at once.
std::vector<datasets::LogRecord> arc() {
  const Pose2 T_last_now(0.3, 0.4, std::numbers::pi / 2.0);
  return {scan_of_square({}), OdometryStep{{}, T_last_now}, scan_of_square(T_last_now)};
}

TEST(LaserLog, IncrementsAreTakenAsPrintedOrAsTheyAre) {
  const auto told = paper_odometry(arc());
  const auto composed = composed_odometry(arc());
  ASSERT_EQ(told.size(), 2U);
  ASSERT_EQ(composed.size(), 2U);
  EXPECT_NEAR(told[1].x_m(), 0.0, 1e-12);
  EXPECT_NEAR(told[1].y_m(), 0.5, 1e-12);
  EXPECT_NEAR(composed[1].x_m(), 0.3, 1e-12);
  EXPECT_NEAR(composed[1].y_m(), 0.4, 1e-12);
  EXPECT_NEAR(path_length_m(told), 0.5, 1e-12);
  EXPECT_NEAR(path_length_m(composed), 0.5, 1e-12);
}

TEST(LaserLog, BeamsEndOnTheWallsFromTruePosesAndOthersAreLeftOut) {
  const auto points_m = scanned_points_m(arc(), composed_odometry(arc()), 20.0);
  EXPECT_EQ(points_m.size(), 360U);
  for (const Eigen::Vector2d& point_m : points_m) {
    EXPECT_NEAR(point_m.cwiseAbs().maxCoeff(), 3.0, 1e-9);
  }
  EXPECT_TRUE(scanned_points_m(arc(), composed_odometry(arc()), 1.0).empty());
}

TEST(LaserLog, SlamCorrectsOdometryByTheWalls) {
  std::vector<datasets::LogRecord> records;
  Pose2 T_world_robot;
  for (int i = 0; i < 40; ++i) {
    records.emplace_back(scan_of_square(T_world_robot));
    const Pose2 step(0.02, 0.0, 0.05);
    T_world_robot = T_world_robot * step;
    records.emplace_back(OdometryStep{{}, {0.02, 0.0, 0.055}});
  }
  records.emplace_back(scan_of_square(T_world_robot));
  slam::LandmarkSlam method;
  run_landmark_slam(records, method);
  const auto error_rad = [&](const std::vector<Pose2>& path) {
    return std::abs(
        geometry::angle_between(path.back().heading_rad(), T_world_robot.heading_rad()));
  };
  ASSERT_EQ(method.trajectory().size(), 41U);
  EXPECT_NEAR(error_rad(composed_odometry(records)), 0.2, 1e-9);
  EXPECT_LT(error_rad(method.trajectory()), 0.05);
}

}  // namespace
}  // namespace echomap::papers
