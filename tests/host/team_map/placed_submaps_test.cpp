// SPDX-License-Identifier: MIT
#include "host/team_map/placed_submaps.hpp"

#include <gtest/gtest.h>

#include "tests/support/told_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;
using geometry::radians;

TEST(PlacedSubmaps, PlacesReadingsByThePoseOfTheFirst) {
  const RobotRecord record =
      tests::told_record("a", tests::room_of_posts(), {{0.0, 0.0}, {0.6, 0.0}}, 0.0);
  const PlacedSubmaps there =
      placed(record.submaps, {Pose2(2.0, 1.0, radians(90.0)), Pose2(2.0, 1.6, radians(90.0))});
  ASSERT_EQ(there.scans.size(), 2U);
  const mapping::PlacedReading& reading = there.scans[1][10];
  EXPECT_NEAR(reading.T_map_robot.x_m(), 2.0, 1e-9);
  EXPECT_NEAR(reading.T_map_robot.y_m(), 1.6, 1e-9);
  EXPECT_NEAR(reading.T_map_sonar.heading_rad(), radians(130.0), 1e-9);
  EXPECT_EQ(reading.range_m, record.submaps[1].readings[10].range_m);
}

/// Odometry says 0.6 m straight on, SLAM has the second stop 0.1 m farther and to the left.
TEST(PlacedSubmaps, SpreadsWhatOdometryIsOffOverTheWay) {
  RobotRecord record =
      tests::told_record("a", tests::room_of_posts(), {{0.0, 0.0}, {0.6, 0.0}}, 0.0);
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

/// The first stop turns by what its odometry calls a whole turn and is 2 % less, and reads what it
/// has read.
TEST(PlacedSubmaps, CalibratesTurnsByTheFirstStop) {
  constexpr double kShare = -0.02;
  const tests::SmoothRoom room = tests::room_of_posts();
  RobotRecord record = tests::told_record("a", room, {{0.0, 0.0}, {0.6, 0.0}}, 0.0);
  Submap& first = record.submaps[0];
  first.readings.clear();
  for (int turn = 0; turn <= 6; ++turn) {
    const double told_rad = turn * radians(360.0) / 6.0;
    slam::OdometryMark mark;
    mark.T_odom_robot = Pose2(0.0, 0.0, told_rad);
    mark.turn_rad = told_rad;
    mark.turned_rad = told_rad;
    for (int i = -44; i <= 44; ++i) {
      const Pose2 T_robot_sonar(0.0, 0.0, radians(2.0 * i));
      const Pose2 T_room_robot(0.0, 0.0, told_rad * (1.0 + kShare));
      first.readings.push_back(
          {mark, T_robot_sonar, tests::ideal_range_m(T_room_robot * T_robot_sonar, room)});
    }
  }
  const std::vector<Submap> calibrated = calibrated_turns(record.submaps);
  EXPECT_NEAR(calibrated[0].readings.back().mark.T_odom_robot.heading_rad(),
              radians(360.0) * kShare,
              0.003 * radians(360.0));
  EXPECT_NEAR(calibrated[0].readings.back().mark.turn_rad,
              radians(360.0) * (1.0 + kShare),
              0.003 * radians(360.0));
}

TEST(PlacedSubmaps, LeavesTurnsAloneThatNothingCalibrates) {
  const RobotRecord record =
      tests::told_record("a", tests::room_of_posts(), {{0.0, 0.0}, {0.6, 0.2}}, 0.3);
  const std::vector<Submap> same = calibrated_turns(record.submaps);
  EXPECT_EQ(same[1].readings[0].mark.T_odom_robot.x_m(),
            record.submaps[1].readings[0].mark.T_odom_robot.x_m());
}

}  // namespace
}  // namespace echomap::team_map
