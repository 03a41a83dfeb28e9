// SPDX-License-Identifier: MIT
#include "host/exploration/traversal_watch.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/exploration/walked_room.hpp"

namespace echomap::exploration {
namespace {

const geometry::Polygon l_room{
    {-0.6, -0.5}, {2.0, -0.5}, {2.0, 0.6}, {0.6, 0.6}, {0.6, 1.9}, {-0.6, 1.9}};

Traversal after(const std::vector<WallStep>& steps, double share) {
  TraversalWatch watch;
  for (std::size_t i = 0; i < static_cast<std::size_t>(share * double(steps.size())); ++i) {
    watch.add(steps[i]);
  }
  return watch.state();
}

TEST(TraversalWatch, ComesRoundWhereTheWalkIsBackAtItsBeginning) {
  const auto steps = walk_round(l_room);
  EXPECT_EQ(after(steps, 0.7), Traversal::kUnderway);
  EXPECT_EQ(after(steps, 1.0), Traversal::kRoundRoom);
  TraversalWatch watch;
  std::for_each(steps.begin(), steps.end(), [&](const WallStep& step) { watch.add(step); });
  const Eigen::Vector2d begin_m = steps.front().T_map_robot.position_m();
  const auto round = std::find_if(steps.begin(), steps.end(), [&](const WallStep& step) {
    return step.travelled_m == watch.round_m();
  });
  ASSERT_NE(round, steps.end());
  EXPECT_LT((round->T_map_robot.position_m() - begin_m).norm(), 0.45);
}

// In a narrow room the robot comes by its beginning on the other side: without a full turn.
TEST(TraversalWatch, IsNotRoundWhereItComesByWithoutAFullTurn) {
  TraversalWatch watch;
  const WallContact along{false, false, true, 0.08};
  watch.add({{0.0, 0.0, 0.0}, along, 0.0, 0.0});
  watch.add({{1.0, 0.0, 0.0}, along, 1.0, 0.0});
  watch.add({{0.0, 0.1, 3.1}, along, 2.0, std::numbers::pi});
  EXPECT_EQ(watch.state(), Traversal::kUnderway);
}

TEST(TraversalWatch, KnowsAnIslandByTheTurnToTheRight) {
  auto steps = walk_round(l_room);
  for (WallStep& step : steps) {
    step.turned_rad = -step.turned_rad;
  }
  EXPECT_EQ(after(steps, 1.0), Traversal::kRoundIsland);
}

TEST(TraversalWatch, ThePapersAngleIsAFullTurnInARoomThatIsSeenFromTheStart) {
  const geometry::Polygon square{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
  const auto steps = walk_round(square);
  TraversalWatch watch;
  for (const WallStep& step : steps) {
    watch.add(step);
    if (watch.state() != Traversal::kUnderway) {
      break;
    }
  }
  EXPECT_NEAR(watch.covered_rad(), 2.0 * std::numbers::pi, 0.5);
}

TEST(TraversalWatch, RefusesParametersWithoutSense) {
  EXPECT_THROW(TraversalWatch({.reach_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(TraversalWatch({.turn_slack_rad = -0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
