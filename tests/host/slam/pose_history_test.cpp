// SPDX-License-Identifier: MIT
#include "host/slam/pose_history.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using geometry::Pose2;

void drive_ahead(EkfSlamFilter& filter, double travelled_m) {
  filter.move(0, Pose2(travelled_m, 0.0, 0.0), {.drive_m = travelled_m}, {.drive_m = 0.01});
}

TEST(PoseHistory, KeepsAPoseWhereTheLastIsFar) {
  EkfSlamFilter filter;
  PoseHistory history;
  for (int i = 0; i < 10; ++i) {
    history.keep(filter);
    drive_ahead(filter, 0.4);
  }
  EXPECT_EQ(filter.stored_poses(), 4U) << "at 0, 1.2, 2.4 and 3.6 m";
}

TEST(PoseHistory, KnowsEachInstantHoweverFewPosesItKeeps) {
  EkfSlamFilter filter;
  PoseHistory history({.max_poses = 3});
  for (int i = 0; i < 20; ++i) {
    history.keep(filter);
    history.add({});
    history.add(Pose2(0.5, 0.1, 0.0));
    drive_ahead(filter, 1.0);
  }
  EXPECT_LE(filter.stored_poses(), 3U);
  const auto poses = history.trajectory(filter);
  ASSERT_EQ(poses.size(), 40U);
  for (std::size_t i = 0; i < 20; ++i) {
    const auto x_m = static_cast<double>(i);
    EXPECT_NEAR(poses[2 * i].x_m(), x_m, 1e-9);
    EXPECT_NEAR(poses[2 * i + 1].x_m(), x_m + 0.5, 1e-9);
    EXPECT_NEAR(poses[2 * i + 1].y_m(), 0.1, 1e-9);
  }
}

TEST(PoseHistory, KeepsTwoPosesAtLeast) {
  EXPECT_THROW(PoseHistory({.max_poses = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
