// SPDX-License-Identifier: MIT
#include "host/team_map/submap_recorder.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;

/// A robot that drives straight on and turns on the spot:
///
///     stop 0 --- 0.5 m, a bump ---> stop 1, which turns by half a turn
class SubmapRecorderTest : public ::testing::Test {
 protected:
  static sensors::RobotGeometry robot() {
    sensors::RobotGeometry geometry;
    geometry.track_m = 0.2;
    geometry.sonar_x_m = 0.05;
    return geometry;
  }

  time::RobotTime next() { return time::robot_time(now_s += 0.1); }

  void drive(double distance_m) {
    for (int step = 0; step < 10; ++step) {
      travel.left_m += 0.1 * distance_m;
      travel.right_m += 0.1 * distance_m;
      recorder.on_odometry({next(), travel});
    }
  }

  void turn(double angle_rad) {
    for (int step = 0; step < 10; ++step) {
      travel.left_m -= 0.1 * angle_rad * 0.1;
      travel.right_m += 0.1 * angle_rad * 0.1;
      recorder.on_odometry({next(), travel});
    }
  }

  void ping(double pan_rad, std::optional<double> range_m) {
    recorder.on_sonar({next(), travel, pan_rad, range_m});
  }

  void stop() {
    recorder.begin_scan();
    ping(0.0, 1.0);
    ping(0.5, std::nullopt);
    recorder.end_scan();
  }

  void bump() {
    sensors::HazardObservation hazards;
    hazards.stamp = next();
    hazards.bump_left = true;
    recorder.on_hazards(hazards);
    recorder.on_hazards(hazards);
  }

  SubmapRecorder recorder{robot()};
  sensors::WheelTravel travel;
  double now_s = 1.0;
};

TEST_F(SubmapRecorderTest, MakesASubmapOfEveryStopByOdometry) {
  ping(0.0, 3.0);  // On the way.
  stop();
  drive(0.5);
  bump();
  recorder.begin_scan();
  ping(0.0, 2.0);
  turn(geometry::radians(180.0));
  ping(0.0, 1.5);
  recorder.end_scan();
  recorder.end_scan();

  ASSERT_EQ(recorder.submaps().size(), 2U);
  const Submap& first = recorder.submaps()[0];
  EXPECT_EQ(first.index, 0U);
  EXPECT_NEAR(first.begin_s, 1.1, 1e-9);
  EXPECT_NEAR(first.end_s, 1.3, 1e-9);
  ASSERT_EQ(first.readings.size(), 2U);
  EXPECT_EQ(first.readings[0].range_m, 1.0);
  EXPECT_FALSE(first.readings[1].range_m);
  EXPECT_NEAR(first.readings[1].T_robot_sonar.heading_rad(), 0.5, 1e-9);
  EXPECT_NEAR(first.readings[1].T_robot_sonar.x_m(), 0.05, 1e-9);

  const Submap& second = recorder.submaps()[1];
  EXPECT_EQ(second.index, 1U);
  EXPECT_EQ(second.begin_s, first.end_s);
  ASSERT_EQ(second.readings.size(), 2U);
  EXPECT_NEAR(second.readings[0].mark.T_odom_robot.x_m(), 0.5, 1e-9);
  EXPECT_NEAR(second.readings[0].mark.path_m, 0.5, 1e-9);
  EXPECT_NEAR(second.readings[1].mark.turned_rad, geometry::radians(180.0), 1e-9);
  EXPECT_NEAR(
      std::abs(second.readings[1].mark.T_odom_robot.heading_rad()), geometry::radians(180.0), 1e-6);
  ASSERT_EQ(second.contacts.size(), 1U) << "a switch that stays closed is one contact";
  EXPECT_TRUE(second.contacts[0].left);
  EXPECT_NEAR(second.contacts[0].T_odom_robot.x_m(), 0.5, 1e-9);
}

TEST_F(SubmapRecorderTest, KeepsTheWayInStepsOfTenCentimetres) {
  stop();
  drive(0.52);
  stop();
  const auto& way = recorder.submaps()[1].T_odom_way;
  ASSERT_EQ(way.size(), 5U);
  for (std::size_t i = 1; i < way.size(); ++i) {
    EXPECT_NEAR((way[i].position_m() - way[i - 1].position_m()).norm(), 0.104, 1e-9);
  }
}

/// A robot that a person has driven down a corridor.
TEST_F(SubmapRecorderTest, LeavesOutWhatLiesFartherOffThanASubmapMayReach) {
  stop();
  bump();
  for (int metre = 0; metre < 40; ++metre) {
    drive(1.0);
  }
  stop();
  const Submap& submap = recorder.submaps()[1];
  EXPECT_GT(submap.T_odom_way.size(), 250U);
  EXPECT_GT(submap.T_odom_way.front().x_m(), 10.9);
  EXPECT_TRUE(submap.contacts.empty());
}

TEST_F(SubmapRecorderTest, HasNoSubmapOfAStopWithoutAnAnswer) {
  recorder.begin_scan();
  sensors::SonarObservation dead{next(), travel, 0.0, std::nullopt};
  dead.has_answered = false;
  recorder.on_sonar(dead);
  recorder.end_scan();
  EXPECT_TRUE(recorder.submaps().empty());
}

TEST_F(SubmapRecorderTest, GivesTheWayOfADroppedStopToTheNext) {
  stop();
  drive(0.5);
  bump();
  stop();
  recorder.drop_last();
  ASSERT_EQ(recorder.submaps().size(), 1U);
  drive(0.5);
  stop();
  const Submap& last = recorder.submaps().back();
  EXPECT_EQ(last.index, 1U);
  EXPECT_EQ(last.begin_s, recorder.submaps().front().end_s);
  EXPECT_EQ(last.contacts.size(), 1U);
  EXPECT_NEAR(last.T_odom_way.front().x_m(), 0.05, 0.06);
  EXPECT_NEAR(last.T_odom_way.back().x_m(), 1.0, 0.1);
}

TEST_F(SubmapRecorderTest, CountsACarryAsAJump) {
  stop();
  recorder.on_carried({next(), travel, Pose2(3.0, 0.0, 0.0)});
  stop();
  const slam::OdometryMark& mark = recorder.submaps().back().readings.front().mark;
  EXPECT_NEAR(mark.T_odom_robot.x_m(), 3.0, 1e-9);
  EXPECT_NEAR(mark.jumped_m, 3.0, 1e-9);
  EXPECT_NEAR(mark.path_m, 0.0, 1e-9);
}

TEST(TMapSubmaps, AreThePosesAtTheFirstReadings) {
  pipeline::Snapshot snapshot;
  mapping::Scan scan(2);
  scan[0].T_map_robot = Pose2(1.0, 2.0, 0.5);
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(
      std::vector<mapping::Scan>{mapping::Scan(), scan});
  const auto poses = T_map_submaps(snapshot);
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0].x_m(), 1.0);
}

}  // namespace
}  // namespace echomap::team_map
