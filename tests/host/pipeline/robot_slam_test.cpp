// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_slam.hpp"

#include <gtest/gtest.h>

#include "tests/host/pipeline/moved_aside.hpp"

namespace echomap::pipeline {
namespace {

class RobotSlamTest : public ::testing::Test {
 protected:
  /// Drives on to `x_m` and pings.
  void ping_at(double x_m) {
    slam.follow({x_m, 0.0, 0.0});
    slam.add_ping({x_m, 0.0, 0.0}, {}, 0.5);
  }

  MovedAside* method = new MovedAside;
  RobotSlam slam{std::unique_ptr<slam::SlamMethod>(method), 0.4};
};

TEST_F(RobotSlamTest, TakesAPingForAScanOfOneBeam) {
  ping_at(1.0);
  EXPECT_EQ(method->beams, 1U);
  EXPECT_DOUBLE_EQ(slam.T_map_odom().y_m(), 1.0);
}

TEST_F(RobotSlamTest, HoldsBackWhatComesAtAStop) {
  ping_at(0.0);
  slam.begin_stop();
  ping_at(1.0);
  ping_at(2.0);
  EXPECT_EQ(method->beams, 1U);
  slam.end_stop(true);
  EXPECT_EQ(method->beams, 3U);
  EXPECT_EQ(method->followed, 3U);
  EXPECT_DOUBLE_EQ(method->poses.back().x_m(), 2.0);
  ASSERT_EQ(slam.stops().size(), 1U);
  const mapping::Scan stop = slam.stops().front();
  ASSERT_EQ(stop.size(), 2U);
  EXPECT_DOUBLE_EQ(stop.front().T_map_sonar.x_m(), 1.0);
  EXPECT_DOUBLE_EQ(stop.back().T_map_robot.x_m(), 2.0);
  EXPECT_DOUBLE_EQ(stop.back().T_map_robot.y_m(), 1.0);
  EXPECT_EQ(stop.back().range_m, 0.5);
}

TEST_F(RobotSlamTest, LeavesOutPingsThatDoNotCount) {
  slam.begin_stop();
  ping_at(1.0);
  slam.end_stop(false);
  EXPECT_EQ(method->beams, 0U);
  EXPECT_EQ(method->followed, 1U) << "the robot drove all the same";
  EXPECT_TRUE(slam.stops().empty());
}

TEST_F(RobotSlamTest, HasAllEchoesOnTheTrajectory) {
  ping_at(0.0);
  slam.begin_stop();
  ping_at(1.0);
  slam.end_stop(false);
  const auto trajectory = slam.trajectory();
  const auto points = slam.points(trajectory).points();
  ASSERT_EQ(points.size(), 2U);
  EXPECT_DOUBLE_EQ(points[0].position_m.x(), 0.5);
  EXPECT_DOUBLE_EQ(points[0].position_m.y(), 1.0);
  EXPECT_DOUBLE_EQ(points[1].position_m.x(), 1.5);
}

TEST_F(RobotSlamTest, CountsPingsOfAStopThatAreOfAnOlderInstant) {
  ping_at(0.0);
  slam.begin_stop();
  slam.add_ping({}, {}, 0.5);
  slam.end_stop(true);
  EXPECT_EQ(method->beams, 2U);
}

TEST_F(RobotSlamTest, SurvivesAStopOfNothing) {
  slam.begin_stop();
  slam.end_stop(true);
  EXPECT_TRUE(slam.stops().empty());
}

}  // namespace
}  // namespace echomap::pipeline
