// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_status.hpp"

#include <gtest/gtest.h>

namespace echomap::pipeline {
namespace {

TEST(RobotStatus, ABumpIsWhereASwitchCloses) {
  RobotStatus status;
  EXPECT_TRUE(status.on_hazards({.stamp = {}, .bump_left = true}).left);
  const NewBumps second = status.on_hazards({.stamp = {}, .bump_left = true, .bump_right = true});
  EXPECT_FALSE(second.left);
  EXPECT_TRUE(second.right);
  status.on_hazards({});
  EXPECT_TRUE(status.on_hazards({.stamp = {}, .bump_left = true}).left);
}

TEST(RobotStatus, APoseIsVoidFromALiftUntilTheRobotIsPutDownAtAKnownPlace) {
  RobotStatus status;
  EXPECT_FALSE(status.has_void_pose());
  status.on_hazards({.stamp = {}, .lifted = true});
  status.on_hazards({.stamp = {}, .lifted = true});
  status.on_hazards({});
  status.on_hazards({.stamp = {}, .cliffs = {true, true, true, true}});
  EXPECT_TRUE(status.has_void_pose());
  Snapshot snapshot;
  status.describe(snapshot);
  EXPECT_EQ(snapshot.times_lifted, 2U);
  status.on_carried();
  EXPECT_FALSE(status.has_void_pose());
}

TEST(RobotStatus, DescribesTheLastOfEach) {
  RobotStatus status;
  Snapshot snapshot;
  status.describe(snapshot);
  EXPECT_FALSE(snapshot.yaw || snapshot.battery);
  status.on_infrared({{}, {}, {0.5}});
  status.on_battery({{}, 7.0});
  status.on_battery({{}, 6.5});
  status.on_yaw({});
  status.on_hazards({.stamp = {}, .wall = true});
  status.describe(snapshot);
  EXPECT_EQ(snapshot.infrared.range_m.size(), 1U);
  EXPECT_EQ(snapshot.battery->voltage_v, 6.5);
  EXPECT_TRUE(snapshot.yaw);
  EXPECT_TRUE(snapshot.hazards.wall);
}

}  // namespace
}  // namespace echomap::pipeline
