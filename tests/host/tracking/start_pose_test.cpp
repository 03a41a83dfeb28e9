// SPDX-License-Identifier: MIT
#include "host/tracking/start_pose.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::tracking {
namespace {

TEST(StartPose, IsWhatTheUserSays) {
  EXPECT_FALSE(start_pose({}));
  const auto start = start_pose({1.0, 2.0, 90.0});
  ASSERT_TRUE(start);
  EXPECT_EQ(start->T_map_robot.y_m(), 2.0);
  EXPECT_NEAR(geometry::degrees(start->T_map_robot.heading_rad()), 90.0, 1e-9);
}

}  // namespace
}  // namespace echomap::tracking
