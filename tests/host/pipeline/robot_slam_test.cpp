// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_slam.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/pipeline/moved_aside.hpp"
#include "tests/support/smooth_room.hpp"

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

TEST_F(RobotSlamTest, StaysWhereTheLastStopHasItWhenTheMethodMovesTheWholeWay) {
  slam.begin_stop();
  ping_at(1.0);
  slam.end_stop(true);
  ping_at(1.5);
  const geometry::Pose2 T_map_robot = slam.T_map_odom() * geometry::Pose2(2.0, 0.0, 0.0);
  method->T_map_odom = {0.3, 0.8, 0.2};
  ping_at(2.0);
  const geometry::Pose2 T_map_moved = slam.T_map_odom() * geometry::Pose2(2.0, 0.0, 0.0);
  EXPECT_NEAR(T_map_moved.x_m(), T_map_robot.x_m(), 1e-9);
  EXPECT_NEAR(T_map_moved.y_m(), T_map_robot.y_m(), 1e-9);
  EXPECT_NEAR(T_map_moved.heading_rad(), T_map_robot.heading_rad(), 1e-9);
}

/// Whose map is moved by `T_map_far` beyond 5 m.
class BentMap final : public MovedAside {
 public:
  BentMap() { T_map_odom = {}; }
  localization::PoseGaussian belief() const override { return {trajectory().back(), {}}; }
  std::vector<geometry::Pose2> trajectory() const override {
    std::vector<geometry::Pose2> bent = poses;
    for (geometry::Pose2& pose : bent) {
      pose = pose.x_m() > 5.0 ? T_map_far * pose : pose;
    }
    return bent;
  }

  geometry::Pose2 T_map_far;
};

TEST(RobotSlamOfABentMap, GoesByTheStopThatIsNearestNotByTheLastOne) {
  auto* method = new BentMap;
  RobotSlam slam{std::unique_ptr<slam::SlamMethod>(method), 0.4};
  for (const double x_m : {0.0, 10.0}) {
    slam.begin_stop();
    slam.follow({x_m, 0.0, 0.0});
    slam.add_ping({x_m, 0.0, 0.0}, {}, 0.5);
    slam.end_stop(true);
  }
  method->T_map_far = {0.0, 0.5, 0.0};
  slam.follow({1.0, 0.0, 0.0});
  slam.add_ping({8.0, 0.0, 0.0}, {}, 0.5);
  slam.add_ping({1.0, 0.0, 0.0}, {}, 0.5);
  EXPECT_NEAR((slam.T_map_odom() * geometry::Pose2(1.0, 0.0, 0.0)).y_m(), 0.0, 1e-9);
}

/// A stop all round, of a body that turns by `share` more than its odometry says.
void look_all_round(double share, RobotSlam& slam) {
  const tests::SmoothRoom room = tests::smooth_rectangle();
  slam.begin_stop();
  for (int sector = 0; sector <= 2; ++sector) {
    for (int i = 0; i <= 4; ++i) {  // No step of odometry is so large as to be a jump.
      slam.follow({0.0, 0.0, geometry::radians(180.0 * (sector - 1) + 45.0 * i)});
    }
    const geometry::Pose2 T_odom_robot(0.0, 0.0, geometry::radians(180.0 * sector));
    const geometry::Pose2 T_true_robot(0.0, 0.0, (1.0 + share) * geometry::radians(180.0 * sector));
    slam.follow(T_odom_robot);
    for (int degree = -90; degree < 90; degree += 2) {
      const geometry::Pose2 T_robot_sonar(0.0, 0.0, geometry::radians(degree));
      slam.add_ping(
          T_odom_robot, T_robot_sonar, tests::ideal_range_m(T_true_robot * T_robot_sonar, room));
    }
  }
  slam.end_stop(true);
}

TEST_F(RobotSlamTest, LearnsAtTheFirstStopHowFarTheBodyTurns) {
  constexpr double kShare = 0.05;
  method->T_map_odom = {};
  slam.follow({0.0, 0.0, geometry::radians(-180.0)});
  look_all_round(kShare, slam);
  const double half_turn_off_rad = kShare * std::numbers::pi;
  const mapping::Scan stop = slam.stops().front();
  const double start_rad = stop.front().T_map_robot.heading_rad();
  EXPECT_NEAR(geometry::angle_between(start_rad, stop.back().T_map_robot.heading_rad()),
              2.0 * half_turn_off_rad,
              0.02);
  const auto trajectory = slam.trajectory();
  slam.follow({0.0, 0.0, geometry::radians(45.0)});
  slam.follow({0.0, 0.0, geometry::radians(90.0)});
  const geometry::Pose2 T_map_robot =
      slam.T_map_odom() * geometry::Pose2(0.0, 0.0, geometry::radians(90.0));
  EXPECT_NEAR(geometry::angle_between(trajectory.back().heading_rad(), T_map_robot.heading_rad()),
              geometry::radians(90.0) + 0.5 * half_turn_off_rad,
              0.02)
      << "from then on, too";
}

}  // namespace
}  // namespace echomap::pipeline
