// SPDX-License-Identifier: MIT
#include "host/slam/scan_matching.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "tests/host/slam/laser_building.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

constexpr double kReachM = 20.0;

localization::PoseGaussian believed(const Pose2& pose, double stddev_m, double stddev_rad) {
  localization::PoseGaussian belief{pose, Eigen::Matrix3d::Zero()};
  belief.covariance.diagonal() << stddev_m * stddev_m, stddev_m * stddev_m, stddev_rad * stddev_rad;
  return belief;
}

void expect_near(const Pose2& pose, const Pose2& expected, double max_m, double max_rad) {
  EXPECT_LT((pose.position_m() - expected.position_m()).norm(), max_m);
  EXPECT_LT(std::abs(geometry::angle_between(pose.heading_rad(), expected.heading_rad())), max_rad);
}

/// A building as it was seen all round from some places, and what is seen from another.
struct Match {
  tests::LaserBuilding building;
  std::mt19937 random{1};
  SurfaceField field;

  explicit Match(tests::LaserBuilding of) : building(std::move(of)) {}

  std::vector<Eigen::Vector2d> seen_m(const Pose2& from) {
    return sensors::end_points_m(building.scan(from, 180, random), kReachM);
  }
  void see_all_round(double x_m, double y_m) {
    for (const double heading_rad : {0.0, 1.5, 3.0, -1.5}) {
      const Pose2 from(x_m, y_m, heading_rad);
      field.add(sensors::in_frame_a_m(from, seen_m(from)));
    }
  }
};

TEST(ScanMatcher, FindsThePoseToACentimetre) {
  Match hall(tests::LaserBuilding::hall());
  hall.see_all_round(3.0, 3.0);
  hall.see_all_round(5.0, 4.0);
  const Pose2 truth(4.0, 3.5, 0.3);
  const Pose2 expected(4.08, 3.42, 0.34);
  const ScanMatch match =
      ScanMatcher().match(hall.seen_m(truth), believed(expected, 0.1, 0.05), hall.field);
  expect_near(match.T_map_robot, truth, 0.015, 0.003);
  EXPECT_GT(match.share, 0.9);
}

TEST(ScanMatcher, FindsAHeadingThatIsFarOff) {
  Match hall(tests::LaserBuilding::hall());
  hall.see_all_round(3.0, 3.0);
  hall.see_all_round(5.0, 4.0);
  const Pose2 truth(4.0, 3.5, 0.3);
  const ScanMatch match =
      ScanMatcher().match(hall.seen_m(truth), believed({4.1, 3.5, 0.5}, 0.1, 0.2), hall.field);
  expect_near(match.T_map_robot, truth, 0.015, 0.003);
}

TEST(ScanMatcher, KeepsOdometryAlongACorridor) {
  Match corridor(tests::LaserBuilding::corridor());
  for (int i = 0; i < 12; ++i) {
    corridor.see_all_round(0.3 * i - 2.0, 0.0);
  }
  const Pose2 expected(1.3, 0.05, 0.02);
  const ScanMatch match = ScanMatcher().match(
      corridor.seen_m({1.0, 0.0, 0.0}), believed(expected, 0.1, 0.05), corridor.field);
  EXPECT_NEAR(match.T_map_robot.x_m(), 1.3, 0.04) << "what odometry says";
  EXPECT_NEAR(match.T_map_robot.y_m(), 0.0, 0.01) << "what the walls say";
  EXPECT_NEAR(match.T_map_robot.heading_rad(), 0.0, 0.005);
  EXPECT_LT(match.information(0, 0), 0.01 * match.information(1, 1));
}

TEST(ScanMatcher, KeepsOdometryWhereNothingIsSeenOrKnown) {
  SurfaceField empty;
  const Pose2 expected(1.0, 2.0, 0.5);
  const auto prior = believed(expected, 0.1, 0.05);
  Match hall(tests::LaserBuilding::hall());
  const ScanMatch unknown = ScanMatcher().match(hall.seen_m({4.0, 3.5, 0.3}), prior, empty);
  expect_near(unknown.T_map_robot, expected, 1e-12, 1e-12);
  hall.see_all_round(3.0, 3.0);
  const ScanMatch unseen = ScanMatcher().match({}, prior, hall.field);
  expect_near(unseen.T_map_robot, expected, 1e-12, 1e-12);
  EXPECT_EQ(unseen.information, Eigen::Matrix3d::Zero());
}

TEST(ScanMatcher, StaysWhereItWasWhenOdometryJumps) {
  Match hall(tests::LaserBuilding::hall());
  hall.see_all_round(3.0, 3.0);
  hall.see_all_round(5.0, 4.0);
  const Pose2 truth(4.0, 3.5, 0.3);
  const auto jumped = believed({9.0, -1.5, 2.0}, 0.2, 0.1);
  const ScanMatch match =
      ScanMatcher().match_after(hall.seen_m(truth), {4.05, 3.5, 0.3}, jumped, hall.field);
  expect_near(match.T_map_robot, truth, 0.015, 0.003);
}

TEST(ScanMatcher, RefusesParametersWithoutSense) {
  ScanMatchingParams params;
  params.kernel = 0.0;
  EXPECT_THROW(ScanMatcher{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
