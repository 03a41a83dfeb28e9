// SPDX-License-Identifier: MIT
#include "host/team_map/calibrated_submaps.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;
using geometry::radians;

/// The first stop turns by what its odometry calls a whole turn and is 2 % less, and reads what it
/// has read.
constexpr double kShare = -0.02;

RobotRecord record_with_a_short_turn() {
  const tests::SmoothRoom room = tests::room_of_posts();
  RobotRecord record = tests::ideal_record("a", room, {{0.0, 0.0}, {0.6, 0.0}, {0.6, 0.3}}, 0.0);
  Submap& first = record.submaps[0];
  first.readings.clear();
  for (int turn = 0; turn <= 6; ++turn) {
    const double reported_rad = turn * radians(360.0) / 6.0;
    slam::OdometryMark mark;
    mark.T_odom_robot = Pose2(0.0, 0.0, reported_rad);
    mark.turn_rad = reported_rad;
    mark.turned_rad = reported_rad;
    for (int i = -44; i <= 44; ++i) {
      const Pose2 T_robot_sonar(0.0, 0.0, radians(2.0 * i));
      const Pose2 T_room_robot(0.0, 0.0, reported_rad * (1.0 + kShare));
      first.readings.push_back(
          {mark, T_robot_sonar, tests::ideal_range_m(T_room_robot * T_robot_sonar, room)});
    }
  }
  return record;
}

TEST(CalibratedSubmaps, CalibrateTurnsByTheFirstStop) {
  CalibratedSubmaps calibrated;
  calibrated.take(record_with_a_short_turn().submaps);
  const slam::OdometryMark& last = calibrated.submaps()[0].readings.back().mark;
  EXPECT_NEAR(last.T_odom_robot.heading_rad(), radians(360.0) * kShare, 0.003 * radians(360.0));
  EXPECT_NEAR(last.turn_rad, radians(360.0) * (1.0 + kShare), 0.003 * radians(360.0));
}

TEST(CalibratedSubmaps, LeaveTurnsAloneThatNothingCalibrates) {
  const RobotRecord record =
      tests::ideal_record("a", tests::room_of_posts(), {{0.0, 0.0}, {0.6, 0.2}}, 0.3);
  CalibratedSubmaps same;
  same.take(record.submaps);
  EXPECT_EQ(same.submaps()[1].readings[0].mark.T_odom_robot.x_m(),
            record.submaps[1].readings[0].mark.T_odom_robot.x_m());
}

void expect_same(const std::vector<Submap>& some, const std::vector<Submap>& others) {
  ASSERT_EQ(some.size(), others.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    const Pose2& one = some[i].readings.back().mark.T_odom_robot;
    const Pose2& other = others[i].readings.back().mark.T_odom_robot;
    EXPECT_EQ(one.position_m(), other.position_m()) << "submap " << i;
    EXPECT_EQ(one.heading_rad(), other.heading_rad()) << "submap " << i;
    for (std::size_t k = 0; k < some[i].T_odom_way.size(); ++k) {
      EXPECT_EQ(some[i].T_odom_way[k].position_m(), others[i].T_odom_way[k].position_m());
    }
  }
}

/// A robot publishes stop after stop, and once in a while one less than before.
TEST(CalibratedSubmaps, AreTheSameTakenOneByOneOrAllAtOnce) {
  const std::vector<Submap> reported = record_with_a_short_turn().submaps;
  CalibratedSubmaps at_once;
  at_once.take(reported);
  CalibratedSubmaps one_by_one;
  for (std::ptrdiff_t count = 0; count <= 3; ++count) {
    one_by_one.take({reported.begin(), reported.begin() + count});
  }
  expect_same(one_by_one.submaps(), at_once.submaps());
  one_by_one.take({reported.begin(), reported.begin() + 2});
  EXPECT_EQ(one_by_one.submaps().size(), 2U);
  one_by_one.take(reported);
  expect_same(one_by_one.submaps(), at_once.submaps());
}

}  // namespace
}  // namespace echomap::team_map
