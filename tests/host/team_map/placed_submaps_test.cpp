// SPDX-License-Identifier: MIT
#include "host/team_map/placed_submaps.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;
using geometry::radians;

TEST(PlacedSubmaps, PlacesReadingsByThePoseOfTheFirst) {
  const RobotRecord record =
      tests::ideal_record("a", tests::room_of_posts(), {{0.0, 0.0}, {0.6, 0.0}}, 0.0);
  const PlacedSubmaps there =
      placed(record.submaps, {Pose2(2.0, 1.0, radians(90.0)), Pose2(2.0, 1.6, radians(90.0))});
  ASSERT_EQ(there.scans.size(), 2U);
  const mapping::PlacedReading& reading = there.scans[1][10];
  EXPECT_NEAR(reading.T_map_robot.x_m(), 2.0, 1e-9);
  EXPECT_NEAR(reading.T_map_robot.y_m(), 1.6, 1e-9);
  EXPECT_NEAR(reading.T_map_sonar.heading_rad(), radians(130.0), 1e-9);
  EXPECT_EQ(reading.range_m, record.submaps[1].readings[10].range_m);
}

TEST(PlacedSubmaps, SayWhereTheRobotWasWhenItsStopsEnded) {
  RobotRecord record =
      tests::ideal_record("a", tests::room_of_posts(), {{0.0, 0.0}, {0.6, 0.0}}, 0.0);
  const Pose2 turned_at_stop(0.0, 0.0, radians(30.0));
  auto& readings = record.submaps[1].readings;
  readings.back().mark.T_odom_robot = readings.front().mark.T_odom_robot * turned_at_stop;
  const auto ends = stop_ends(record.submaps, {Pose2(), Pose2(2.0, 1.6, radians(90.0))});
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[1].stamp_s, record.submaps[1].end_s);
  EXPECT_NEAR(ends[1].T_map_robot.x_m(), 2.0, 1e-9);
  EXPECT_NEAR(ends[1].T_map_robot.y_m(), 1.6, 1e-9);
  EXPECT_NEAR(ends[1].T_map_robot.heading_rad(), radians(120.0), 1e-9);
}

/// Odometry says 0.6 m straight on, SLAM has the second stop 0.1 m farther and to the left.
TEST(PlacedSubmaps, SpreadsWhatOdometryIsOffOverTheWay) {
  RobotRecord record =
      tests::ideal_record("a", tests::room_of_posts(), {{0.0, 0.0}, {0.6, 0.0}}, 0.0);
  record.submaps[1].contacts.push_back({Pose2(0.3, 0.0, 0.0), true, false});
  const PlacedSubmaps there = placed(record.submaps, {Pose2(), Pose2(0.7, 0.1, 0.0)});
  ASSERT_EQ(there.T_map_way.size(), 8U) << "two stops and six steps";
  EXPECT_NEAR(there.T_map_way[1].x_m(), 0.1 + 0.1 / 6.0, 1e-9);
  EXPECT_NEAR(there.T_map_way[6].x_m(), 0.7, 1e-9);
  EXPECT_NEAR(there.T_map_way[6].y_m(), 0.1, 1e-9);
  ASSERT_EQ(there.contacts.size(), 1U);
  EXPECT_NEAR(there.contacts[0].T_map_robot.x_m(), 0.35, 1e-9);
  EXPECT_TRUE(there.contacts[0].left);
}

}  // namespace
}  // namespace echomap::team_map
