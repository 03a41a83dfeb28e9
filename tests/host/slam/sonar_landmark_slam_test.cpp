// SPDX-License-Identifier: MIT
#include "host/slam/sonar_landmark_slam.hpp"

#include <algorithm>
#include <stdexcept>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/host/slam/drifting_rounds.hpp"
#include "tests/host/slam/heard_room.hpp"

namespace echomap::slam {
namespace {

using mapping::Echo;
using mapping::EchoFeature;

using geometry::Pose2;

constexpr Circle kNarrowCircle{0.5, 60};

/// Ten cones all round, as they hear the room.
sensors::RangeScan ring_from(const Pose2& T_map_robot, std::mt19937& random) {
  std::normal_distribution<double> noise_m(0.0, 0.01);
  sensors::RangeScan scan{{}, {}, {}, 2.0 * kBeamHalfAngleRad, 4.0};
  for (int i = 0; i < 10; ++i) {
    const double bearing_rad = geometry::radians(36.0 * i);
    const Echo cone{
        T_map_robot.position_m(), T_map_robot.heading_rad() + bearing_rad, 0.0, kBeamHalfAngleRad};
    auto range_m = heard_m(cone, walls_and_leg());
    if (range_m) {
      *range_m += noise_m(random);
    }
    scan.beams.push_back({bearing_rad, range_m});
  }
  return scan;
}

void run(SonarLandmarkSlam& slam, const Drive& drive, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < drive.T_odom_robot.size(); ++i) {
    slam.add(drive.T_odom_robot[i], ring_from(drive.T_map_robot[i], random));
  }
}

TEST(SonarLandmarkSlam, CorrectsOdometryThatTurnsAside) {
  const Drive drive = rounds(kNarrowCircle, 4, 0.08);
  constexpr std::uint32_t kSeeds = 10;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    SonarLandmarkSlam slam;
    run(slam, drive, seed);
    const auto poses = slam.trajectory();
    ASSERT_EQ(poses.size(), drive.T_map_robot.size());
    EXPECT_LT(worst_error_m(poses, drive), 0.3 * worst_error_m(drive.T_odom_robot, drive)) << seed;
    // On a circle, a share of the turn and a drift over the way are alike.
    const Eigen::Vector3d& calibration = slam.filter().calibration();
    EXPECT_NEAR(calibration[0] / kNarrowCircle.radius_m + calibration[1], -0.08, 0.02) << seed;
  }
}

TEST(SonarLandmarkSlam, LeavesGoodOdometryAlmostAlone) {
  const Drive drive = rounds(kNarrowCircle, 4, 0.0);
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    SonarLandmarkSlam slam;
    run(slam, drive, seed);
    EXPECT_LT(worst_error_m(slam.trajectory(), drive), 0.1) << seed;
  }
}

TEST(SonarLandmarkSlam, SaysHowSureItIs) {
  const Drive drive = rounds(kNarrowCircle, 3, 0.08);
  constexpr int kSeeds = 20;
  double nees = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    SonarLandmarkSlam slam;
    run(slam, drive, seed);
    const auto belief = slam.belief();
    ASSERT_TRUE(localization::is_covariance(belief.covariance));
    const Eigen::Vector2d off_m =
        belief.T_map_robot.position_m() - drive.T_map_robot.back().position_m();
    nees += off_m.dot(belief.covariance.topLeftCorner<2, 2>().inverse() * off_m) / kSeeds;
  }
  EXPECT_LT(nees, 6.0) << "2 is right";
}

TEST(SonarLandmarkSlam, MapsTheWalls) {
  SonarLandmarkSlam slam;
  run(slam, rounds(kNarrowCircle, 3, 0.0), 1);
  for (const EchoFeature& feature : walls_and_leg()) {
    if (feature.kind == LandmarkKind::kWall) {
      const auto& all = slam.filter().landmarks();
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Landmark& landmark) {
        const Eigen::Vector2d off = innovation(landmark.value, feature.value);
        return landmark.kind == feature.kind && std::abs(off.x()) < 0.1 && std::abs(off.y()) < 0.2;
      })) << feature.value.y();
    }
  }
}

TEST(SonarLandmarkSlam, IsOdometryWhereNothingAnswers) {
  const Drive drive = rounds(kNarrowCircle, 2, 0.05);
  SonarLandmarkSlam slam;
  for (const Pose2& T_odom_robot : drive.T_odom_robot) {
    slam.add(T_odom_robot, {{}, {}, {{0.0, std::nullopt}}, 0.4, 4.0});
  }
  const auto poses = slam.trajectory();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((poses[i].position_m() - drive.T_odom_robot[i].position_m()).norm(), 1e-6) << i;
  }
  EXPECT_GT(slam.belief().covariance(0, 0), 0.0);
}

TEST(SonarLandmarkSlam, ARobotThatStandsLearnsNothing) {
  SonarLandmarkSlam slam;
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    slam.add({}, ring_from({}, random));
  }
  EXPECT_TRUE(slam.filter().landmarks().empty());
  EXPECT_LT(slam.belief().T_map_robot.position_m().norm(), 1e-12);
}

TEST(SonarLandmarkSlam, RefusesParametersWithoutSense) {
  EXPECT_THROW(SonarLandmarkSlam({.noise_hypotheses = {}}), std::invalid_argument);
  EXPECT_THROW(SonarLandmarkSlam({.odometry = {.heading_stddev_rad = 0.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
