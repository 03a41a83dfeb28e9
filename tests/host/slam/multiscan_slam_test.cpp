// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_slam.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/host/slam/drifting_rounds.hpp"

namespace echomap::slam {
namespace {

using mapping::Echo;
using mapping::view_of_wall;
using mapping::WallLine;

using geometry::Pose2;
using geometry::radians;

/// A room of 4 x 3 m around the origin, as a ring of eight sonars hears it.
sensors::RangeScan ring_in_room(const Pose2& T_map_robot) {
  constexpr WallLine kWalls[] = {{0.0, 2.0}, {1.5707963, 1.5}, {3.1415927, 2.0}, {-1.5707963, 1.5}};
  sensors::RangeScan scan{{}, {}, {}, radians(20.0), 5.0};
  for (int i = 0; i < 8; ++i) {
    const double bearing_rad = radians(45.0 * i);
    const Echo cone{
        T_map_robot.position_m(), T_map_robot.heading_rad() + bearing_rad, 0.0, radians(10.0)};
    double range_m = scan.max_range_m;
    for (const WallLine& wall : kWalls) {
      if (std::abs(geometry::angle_between(cone.axis_rad, wall.normal_rad)) < radians(75.0)) {
        range_m = std::min(range_m, view_of_wall(cone, wall).range_m);
      }
    }
    scan.beams.push_back({bearing_rad, range_m});
  }
  return scan;
}

constexpr Circle kWideCircle{0.8, 100};

void run(MultiscanSlam& slam, const Drive& drive) {
  for (std::size_t i = 0; i < drive.T_odom_robot.size(); ++i) {
    slam.add(drive.T_odom_robot[i], ring_in_room(drive.T_map_robot[i]));
  }
}

TEST(MultiscanSlam, CorrectsOdometryThatTurnsAside) {
  const Drive drive = rounds(kWideCircle, 3, 0.05);
  MultiscanSlam slam;
  run(slam, drive);
  const auto poses = slam.trajectory();
  ASSERT_EQ(poses.size(), drive.T_map_robot.size());
  EXPECT_GT(worst_error_m(drive.T_odom_robot, drive), 0.5);
  EXPECT_LT(worst_error_m(poses, drive), 0.2 * worst_error_m(drive.T_odom_robot, drive));
}

TEST(MultiscanSlam, BelievesGoodOdometryAndNoOther) {
  MultiscanSlam with_good;
  run(with_good, rounds(kWideCircle, 1, 0.0));
  EXPECT_LT(with_good.graph().steady_scale, 1.0);
  MultiscanSlam with_poor;
  run(with_poor, rounds(kWideCircle, 2, 0.1));
  EXPECT_EQ(with_poor.graph().steady_scale, 1.0);
}

TEST(MultiscanSlam, SaysHowSureItIs) {
  const Drive drive = rounds(kWideCircle, 2, 0.05);
  MultiscanSlam slam;
  run(slam, drive);
  const auto belief = slam.belief();
  EXPECT_TRUE(localization::is_covariance(belief.covariance));
  const Eigen::Vector2d off_m =
      belief.T_map_robot.position_m() - drive.T_map_robot.back().position_m();
  EXPECT_LT(off_m.dot(belief.covariance.topLeftCorner<2, 2>().inverse() * off_m), 13.8)
      << "99.9 % of a normal distribution";
}

TEST(MultiscanSlam, IsOdometryWhereNothingAnswers) {
  const Drive drive = rounds(kWideCircle, 2, 0.05);
  MultiscanSlam slam;
  for (const Pose2& T_odom_robot : drive.T_odom_robot) {
    slam.add(T_odom_robot, {{}, {}, {{0.0, std::nullopt}}, radians(20.0), 5.0});
  }
  const auto poses = slam.trajectory();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((poses[i].position_m() - drive.T_odom_robot[i].position_m()).norm(), 1e-6) << i;
  }
}

TEST(MultiscanSlam, KeepsTheWayAlongACorridorOfOdometry) {
  MultiscanSlam slam;
  for (int step = 0; step <= 120; ++step) {
    slam.add({0.1 * step, 0.0, 0.0},
             {{}, {}, {{radians(90.0), 1.0}, {radians(-90.0), 1.0}}, radians(20.0), 5.0});
  }
  EXPECT_NEAR(slam.belief().T_map_robot.x_m(), 12.0, 0.01);
  EXPECT_NEAR(slam.belief().T_map_robot.y_m(), 0.0, 0.01);
}

TEST(MultiscanSlam, StaysSoundWhereOdometryJumps) {
  Drive drive = rounds(kWideCircle, 3, 0.05);
  const Pose2 jump(0.0, 0.0, 1.2);
  for (std::size_t i = 200; i < drive.T_odom_robot.size(); ++i) {
    drive.T_odom_robot[i] = drive.T_odom_robot[i] * jump;
  }
  MultiscanSlam slam;
  run(slam, drive);
  for (const Pose2& pose : slam.trajectory()) {
    EXPECT_TRUE(localization::is_finite(pose));
  }
  EXPECT_TRUE(localization::is_covariance(slam.belief().covariance));
}

TEST(MultiscanSlam, IsAtTheOriginBeforeTheFirstScan) {
  const MultiscanSlam slam;
  EXPECT_EQ(slam.belief().T_map_robot.x_m(), 0.0);
  EXPECT_TRUE(slam.trajectory().empty());
}

TEST(MultiscanSlam, RefusesParametersWithoutSense) {
  MultiscanSlamParams params;
  params.steps = 0;
  EXPECT_THROW(MultiscanSlam{params}, std::invalid_argument);
}

TEST(MultiscanSlam, RefusesBeliefsWithoutSense) {
  MultiscanSlamParams params;
  for (const std::vector<OdometryNoiseHypothesis>& noise_hypotheses :
       {std::vector<OdometryNoiseHypothesis>{}, {{0.0, 0.33, 3.0}}, {{1.0, 3.0, 0.33}}}) {
    params.noise_hypotheses = noise_hypotheses;
    EXPECT_THROW(MultiscanSlam{params}, std::invalid_argument);
  }
}

}  // namespace
}  // namespace echomap::slam
