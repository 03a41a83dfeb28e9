// SPDX-License-Identifier: MIT
#include "host/localization/path_alignment.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/localization/heard_scan.hpp"
#include "tests/support/furnished_room.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

double off_m(const Pose2& one, const Pose2& other) {
  return (one.position_m() - other.position_m()).norm();
}

double off_rad(const Pose2& one, const Pose2& other) {
  return std::abs(geometry::angle_between(one.heading_rad(), other.heading_rad()));
}

/// Three stops along the room; each drive, odometry has turned by 5 degrees that the robot has not.
struct BentWalk {
  BentWalk() : room(tests::furnished_room()), model(tests::sonar_model(room)) {
    const std::vector<Pose2> told = {{}, {0.6, 0.0, 0.09}, {1.2, 0.05, 0.18}};
    for (std::size_t i = 0; i < truth.size(); ++i) {
      scans.insert(scans.begin(), {told[i], tests::heard_scan(room, truth[i]), {}});
    }
  }

  mapping::RasterMap room;
  std::unique_ptr<ObservationModel> model;
  std::vector<Pose2> truth = {{1.4, 0.95, 0.0}, {2.0, 0.95, 0.0}, {2.6, 0.95, 0.0}};
  std::vector<StopScan> scans;  ///< The newest first.
};

TEST(PathAlignment, BeginsWithWhatOdometryTells) {
  const std::vector<StopScan> scans = {{{2.0, 0.0, 0.0}, {}, {}}, {{1.0, 0.0, 0.0}, {}, {}}};
  const ScanPath path = path_by_odometry(scans, {0.0, 0.0, geometry::radians(90.0)});
  ASSERT_EQ(path.size(), 2U);
  EXPECT_NEAR(path[1].x_m(), 0.0, 1e-12);
  EXPECT_NEAR(path[1].y_m(), -1.0, 1e-12);
}

TEST(PathAlignment, TakesTheBendOfOdometryOut) {
  BentWalk walk;
  std::vector<ScanPath> paths = {path_by_odometry(walk.scans, {2.6, 0.95, 0.05})};
  ASSERT_GT(off_rad(paths[0][2], walk.truth[0]), 0.12) << "odometry is bent";
  align_paths(walk.scans, *walk.model, paths);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(off_m(paths[0][i], walk.truth[2 - i]), 0.08) << i;
    EXPECT_LT(off_rad(paths[0][i], walk.truth[2 - i]), 0.065) << i;
  }
}

TEST(PathAlignment, StaysWithinWhatOdometryMayErr) {
  BentWalk walk;
  const Pose2 T_map_elsewhere(0.6, 0.3, 2.0);
  std::vector<ScanPath> paths = {path_by_odometry(walk.scans, T_map_elsewhere)};
  align_paths(walk.scans, *walk.model, paths);
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    const Pose2 told = walk.scans[i + 1].T_odom_robot.inverse() * walk.scans[i].T_odom_robot;
    const Pose2 aligned = paths[0][i + 1].inverse() * paths[0][i];
    EXPECT_LT(off_m(told, aligned), 0.15) << i;
    EXPECT_LT(off_rad(told, aligned), 0.2) << i;
  }
}

TEST(PathAlignment, LeavesOneScanToTheSearch) {
  BentWalk walk;
  walk.scans.resize(1);
  std::vector<ScanPath> paths = {path_by_odometry(walk.scans, {2.5, 0.9, 0.05})};
  align_paths(walk.scans, *walk.model, paths);
  EXPECT_EQ(off_m(paths[0][0], {2.5, 0.9, 0.05}), 0.0);
}

}  // namespace
}  // namespace echomap::localization
