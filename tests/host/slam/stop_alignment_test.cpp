// SPDX-License-Identifier: MIT
#include "host/slam/stop_alignment.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/smooth_room.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;
using geometry::radians;
using tests::SmoothRoom;

const SmoothRoom kRoom = tests::smooth_rectangle();

const std::vector<Eigen::Vector2d> kStops{
    {0.0, 0.0}, {0.5, 0.2}, {-0.4, 0.3}, {0.2, -0.2}, {0.7, 0.4}, {-0.6, -0.1}};

/// A robot that turns by `drift_rad` more from stop to stop than its odometry reports; its headings
/// at rest are 0 and half a turn. The path between stops is driven in steps.
class DriftingRobot {
 public:
  DriftingRobot(SmoothRoom room, double drift_rad, const StopAlignmentParams& params = {})
      : alignment(params), room_(std::move(room)), drift_rad_(drift_rad) {}

  void visit(const Eigen::Vector2d& place_m) {
    const double heading_rad = static_cast<double>(visited_m_.size()) * drift_rad_;
    const Pose2 T_map_robot(place_m.x(), place_m.y(), heading_rad);
    if (!visited_m_.empty()) {
      drive(T_odom_robot_ * T_map_last_.inverse() * T_map_robot * Pose2(0.0, 0.0, -drift_rad_));
    }
    T_map_last_ = T_map_robot;
    visited_m_.push_back(place_m);
    std::vector<StopReading> readings;
    for (const double turned_rad : {0.0, 3.1}) {
      const Pose2 turn(0.0, 0.0, turned_rad);
      meter_.follow(T_odom_robot_ * turn);
      sweep(T_map_robot * turn, readings);
    }
    meter_.follow(T_odom_robot_);
    alignment.add_stop(readings);
    for (std::size_t i = T_slam_stands_.size(); i < alignment.stands().size(); ++i) {
      const StopStand& stand = alignment.stands()[i];
      T_slam_stands_.push_back(readings[stand.first].mark.T_odom_robot);
    }
    alignment.align(T_slam_stands_);
  }

  double max_distance_off_m() const {
    double max_m = 0.0;
    const auto scans = alignment.scans();
    for (std::size_t i = 0; i < scans.size(); ++i) {
      max_m = std::max(max_m, (scans[i][0].T_map_robot.position_m() - visited_m_[i]).norm());
    }
    return max_m;
  }

  StopAlignment alignment;

 private:
  void drive(const Pose2& T_odom_robot) {
    const Pose2 T_before = std::exchange(T_odom_robot_, T_odom_robot);
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const Eigen::Vector2d place_m =
          (1.0 - share) * T_before.position_m() + share * T_odom_robot.position_m();
      meter_.follow({place_m.x(), place_m.y(), T_odom_robot.heading_rad()});
    }
  }

  void sweep(const Pose2& T_map_robot, std::vector<StopReading>& readings) {
    for (double pan_rad = -radians(90.0); pan_rad < radians(91.0); pan_rad += radians(4.0)) {
      const Pose2 T_robot_sonar(0.0, 0.0, pan_rad);
      readings.push_back(
          {meter_.mark(), T_robot_sonar, tests::ideal_range_m(T_map_robot * T_robot_sonar, room_)});
    }
  }

  SmoothRoom room_;
  double drift_rad_;
  OdometryMeter meter_;
  Pose2 T_map_last_;
  Pose2 T_odom_robot_;
  std::vector<Eigen::Vector2d> visited_m_;
  std::vector<Pose2> T_slam_stands_;
};

TEST(StopAlignment, TakesOutMostOfADriftOfTheOdometry) {
  DriftingRobot robot(kRoom, radians(2.0));
  for (const Eigen::Vector2d& stop_m : kStops) {
    robot.visit(stop_m);
  }
  EXPECT_LT(robot.max_distance_off_m(), 0.05);
  EXPECT_NEAR(robot.alignment.scans().back().front().T_map_robot.heading_rad(),
              5.0 * radians(2.0),
              radians(2.0));
}

/// The method's poses alone begin too far off for their surfaces to be matched rightly.
TEST(StopAlignment, FindsADriftFromAnotherStart) {
  const auto off_m = [](const StopAlignmentParams& params) {
    DriftingRobot robot(kRoom, radians(8.0), params);
    for (const Eigen::Vector2d& stop_m : kStops) {
      robot.visit(stop_m);
    }
    return robot.max_distance_off_m();
  };
  StopAlignmentParams one_start;
  one_start.min_gain = 1e9;
  EXPECT_GT(off_m(one_start), 0.1);
  EXPECT_LT(off_m({}), 0.03);
}

TEST(StopAlignment, LeavesAnOdometryThatIsRight) {
  DriftingRobot robot(kRoom, 0.0);
  for (const Eigen::Vector2d& stop_m : kStops) {
    robot.visit(stop_m);
  }
  EXPECT_LT(robot.max_distance_off_m(), 0.03);
}

TEST(StopAlignment, KeepsToTheOdometryWhereNothingIsInRange) {
  DriftingRobot robot({}, 0.0);
  for (const Eigen::Vector2d& stop_m : kStops) {
    robot.visit(stop_m);
  }
  EXPECT_LT(robot.max_distance_off_m(), 1e-6);
}

TEST(StopAlignment, FindsTheTwoHeadingsOfASweepAllRound) {
  DriftingRobot robot(kRoom, 0.0);
  robot.visit({0.0, 0.0});
  ASSERT_EQ(robot.alignment.stands().size(), 2U);
  EXPECT_EQ(robot.alignment.stands()[0].resting, 46U);
  EXPECT_EQ(robot.alignment.stands()[1].first, 46U);
  EXPECT_EQ(robot.alignment.scans().front().size(), 92U);
  EXPECT_EQ(robot.max_distance_off_m(), 0.0) << "one stop stays";
}

TEST(StopAlignment, MovesTheNewestStopsOnly) {
  StopAlignmentParams params;
  params.window = 3;
  DriftingRobot robot(kRoom, radians(0.2), params);
  for (const Eigen::Vector2d& stop_m : kStops) {
    robot.visit(stop_m);
  }
  const auto before = robot.alignment.T_map_stands();
  robot.visit(kStops[0]);
  ASSERT_EQ(before.size(), 12U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(before[i].position_m(), robot.alignment.T_map_stands()[i].position_m()) << i;
  }
  EXPECT_NE(before[11].position_m(), robot.alignment.T_map_stands()[11].position_m());
}

TEST(StopAlignment, MovesMoreStopsNowAndThen) {
  StopAlignmentParams params;
  params.window = 3;
  params.wide_every = 7;
  DriftingRobot robot(kRoom, radians(0.2), params);
  for (const Eigen::Vector2d& stop_m : kStops) {
    robot.visit(stop_m);
  }
  const auto before = robot.alignment.T_map_stands();
  robot.visit(kStops[0]);
  for (std::size_t stop = 1; stop < kStops.size(); ++stop) {
    EXPECT_NE(before[2 * stop].position_m(), robot.alignment.T_map_stands()[2 * stop].position_m())
        << stop;
  }
}

TEST(StopAlignment, RefusesInvalidParameters) {
  StopAlignmentParams params;
  params.window = 1;
  EXPECT_THROW(StopAlignment{params}, std::invalid_argument);
  params = {};
  params.wide_every = 0;
  EXPECT_THROW(StopAlignment{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
