// SPDX-License-Identifier: MIT
#include "host/exploration/wall_walk.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;
using geometry::radians;

TEST(WallWalk, FollowsTheOdometryFromWhereItBegan) {
  WallWalk walk({});
  walk.follow({1.0, 2.0, 0.5});
  walk.follow({1.5, 2.5, 0.7});
  EXPECT_NEAR(walk.T_map_robot().x_m(), 1.5, 1e-12);
  EXPECT_NEAR(walk.T_map_robot().y_m(), 2.5, 1e-12);
  EXPECT_NEAR(walk.T_map_robot().heading_rad(), 0.7, 1e-12);
}

// Equations 6 to 8: the way by the fitted line, the turn as it is.
TEST(WallWalk, CorrectsEveryStepsWayAndNoTurn) {
  WallWalk walk({1.1, 0.002});
  walk.follow({});
  walk.begin();
  walk.follow({0.01, 0.0, 0.0});
  walk.follow({0.02, 0.0, radians(30.0)});
  const WallStep& step = walk.add({});
  EXPECT_NEAR(step.T_map_robot.x_m(), 2 * (1.1 * 0.01 + 0.002), 1e-12);
  EXPECT_NEAR(step.T_map_robot.heading_rad(), radians(30.0), 1e-12);
  EXPECT_NEAR(step.travelled_m, 0.026, 1e-12);
}

TEST(WallWalk, StandsStillWhereTheOdometryDoes) {
  WallWalk walk({1.0, 0.005});
  walk.follow({});
  walk.follow({0.0, 0.0, radians(90.0)});
  EXPECT_EQ(walk.T_map_robot().position_m().norm(), 0.0);
}

TEST(WallWalk, CountsWholeTurnsSinceItBegan) {
  WallWalk walk({});
  for (int i = 0; i < 10; ++i) {
    walk.follow({0.0, 0.0, radians(-60.0 * i)});
    if (i == 1) {
      walk.begin();
    }
  }
  EXPECT_NEAR(walk.add({}).turned_rad, radians(-480.0), 1e-9);
  EXPECT_EQ(walk.steps().size(), 1U);
}

TEST(WallWalk, PlacesOnlyWhatWasSeenAlongAWall) {
  const Pose2 T_robot_sensor(0.1, -0.1, radians(-90.0));
  const Pose2 here(1.0, 1.0, radians(90.0));
  std::vector<WallStep> steps{{here, {false, false, true, 0.07}, 0.5, 0.0},
                              {here, {true, false, true, 0.07}, 0.5, 0.0},
                              {here, {false, false, false, 0.07}, 0.5, 0.0},
                              {here, {false, false, true, std::nullopt}, 0.5, 0.0}};
  const auto points = wall_points(steps, T_robot_sensor);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(points[0].place_m.x(), 1.17, 1e-12);
  EXPECT_NEAR(points[0].place_m.y(), 1.1, 1e-12);
  EXPECT_EQ(points[0].travelled_m, 0.5);
}

}  // namespace
}  // namespace echomap::exploration
