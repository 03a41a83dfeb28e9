// SPDX-License-Identifier: MIT
#include "host/exploration/navigator.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <variant>

#include <gtest/gtest.h>

#include "tests/host/exploration/obedient_robot.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;
using mapping::CellState;

/// Floor of 4 m x 2 m, from 1 m behind the start to 3 m before it.
mapping::OccupancyGrid floor_around() {
  mapping::OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 60; ++x) {
      grid.add({x, y}, -300);
    }
  }
  return grid;
}

class NavigatorTest : public ::testing::Test {
 protected:
  NavigatorTest() {
    robot.snapshot = tests::snapshot_of(floor_around(), {tests::pose_at(1.0, {})});
    navigator.set_map(navigator.map_of(robot.snapshot, 0.0), robot.snapshot);
  }
  const Pose2& T_map_robot() const { return robot.snapshot.latest.T_map_robot; }

  ObedientRobot robot;
  Navigator navigator{{}};
};

TEST_F(NavigatorTest, LeadsTheRobotToAPlace) {
  const Eigen::Vector2d goal_m(2.0, 0.5);
  navigator.follow_path_to(T_map_robot(), goal_m, 2.1);
  while (const auto motion = navigator.next(T_map_robot())) {
    robot.carry_out(*motion);
  }
  EXPECT_LT((T_map_robot().position_m() - goal_m).norm(), 0.06);
}

TEST_F(NavigatorTest, LeadsRoundSomebodyWhoStandsThere) {
  navigator.set_standing({{{1.0, 0.0}, 0.15}});
  navigator.set_map(navigator.map_of(robot.snapshot, 0.0), robot.snapshot);
  navigator.follow_path_to(T_map_robot(), {2.0, 0.0}, 2.1);
  double nearest_m = 10.0;
  while (const auto motion = navigator.next(T_map_robot())) {
    robot.carry_out(*motion);
    const Eigen::Vector2d at_m = T_map_robot().position_m();
    nearest_m = std::min(nearest_m, (at_m - Eigen::Vector2d(1.0, 0.0)).norm());
  }
  EXPECT_GT(nearest_m, 0.2);
  EXPECT_LT((T_map_robot().position_m() - Eigen::Vector2d(2.0, 0.0)).norm(), 0.06);
}

TEST_F(NavigatorTest, HasNoWayOverSomebodyWhoStaysButAwayFromHim) {
  const Eigen::Vector2d at_m(0.25, 0.0);
  navigator.set_standing({{at_m, 0.3, true}});
  navigator.set_map(navigator.map_of(robot.snapshot, 0.0), robot.snapshot);
  const auto cost_m = [&](const Eigen::Vector2d& goal_m) {
    return navigator.travel().cost_m(navigator.costs().cell_at(goal_m));
  };
  EXPECT_FALSE(cost_m(at_m)) << "the robot stands nearer to him than it would come by itself";
  EXPECT_TRUE(cost_m({-0.5, 0.0}));
  EXPECT_TRUE(cost_m({2.0, 0.5})) << "round him";
}

TEST_F(NavigatorTest, GivesAWayUpThatTakesTooLong) {
  navigator.follow_path_to(T_map_robot(), {2.0, 0.0}, 2.0);
  int motions = 0;
  while (navigator.next(T_map_robot()) && motions < 10'000) {
    ++motions;
  }
  EXPECT_LT(motions, 1'000);
}

TEST_F(NavigatorTest, StaysWhereTheGoalCostsNothing) {
  navigator.follow_path_to(T_map_robot(), {2.0, 0.0}, 0.0);
  EXPECT_FALSE(navigator.next(T_map_robot()));
}

TEST_F(NavigatorTest, RemembersWhatStoppedTheRobotOnTheSideOfTheBumper) {
  robot.snapshot.hazards.bump_left = true;
  EXPECT_TRUE(is_stopped(robot.snapshot, MotionResult::kReached));
  const auto motion = navigator.recover(robot.snapshot, MotionResult::kReached, true);
  ASSERT_TRUE(motion);
  EXPECT_LT(std::get<Drive>(*motion).distance_m, 0.0);
  ASSERT_EQ(navigator.obstacles_m().size(), 1U);
  const Eigen::Vector2d obstacle_m = navigator.obstacles_m().front();
  EXPECT_GT(obstacle_m.x(), 0.1);
  EXPECT_GT(obstacle_m.y(), 0.05);
  const auto map = navigator.map_of(robot.snapshot, 0.0);
  EXPECT_EQ(map.state(map.cell_at(obstacle_m)), CellState::kOccupied);
}

TEST_F(NavigatorTest, AMotionThatTookTooLongMetNothing) {
  EXPECT_FALSE(is_stopped(robot.snapshot, MotionResult::kTimedOut));
  EXPECT_FALSE(is_stopped(robot.snapshot, MotionResult::kReached));
  EXPECT_TRUE(is_stopped(robot.snapshot, MotionResult::kStalled));
}

TEST_F(NavigatorTest, GivesUpAfterTooManyMotionsThatFailedInARow) {
  const std::size_t most = NavigatorParams{}.max_failures;
  for (std::size_t i = 0; i < most; ++i) {
    EXPECT_FALSE(navigator.recover(robot.snapshot, MotionResult::kTimedOut, true));
    EXPECT_FALSE(navigator.recover(robot.snapshot, MotionResult::kReached, true));
  }
  navigator.forget_failures();
  for (std::size_t i = 0; i < most; ++i) {
    EXPECT_FALSE(navigator.recover(robot.snapshot, MotionResult::kBumped, false));
  }
  const auto motion = navigator.recover(robot.snapshot, MotionResult::kBumped, true);
  ASSERT_TRUE(motion);
  EXPECT_TRUE(std::holds_alternative<Finished>(*motion));
}

TEST_F(NavigatorTest, SupposesFloorForOneWay) {
  const Eigen::Vector2d beyond_m(3.3, 0.0);
  auto map = navigator.map_of(robot.snapshot, 1.0);
  navigator.set_map(map, robot.snapshot);
  EXPECT_FALSE(navigator.costs().is_open(navigator.costs().cell_at(beyond_m)));
  for (int x = 0; x < 10; ++x) {
    for (int y = -5; y <= 5; ++y) {
      map.set(map.cell_at({3.05 + 0.05 * x, 0.05 * y}), CellState::kFree);
    }
  }
  navigator.set_hypothetical_map(map, robot.snapshot);
  EXPECT_TRUE(navigator.costs().is_open(navigator.costs().cell_at(beyond_m)));
  EXPECT_FALSE(navigator.travel().reaches(navigator.costs().cell_at(beyond_m)));
}

TEST(Navigator, RejectsInvalidParameters) {
  NavigatorParams params;
  params.obstacle_m = 0.0;
  EXPECT_THROW(Navigator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
