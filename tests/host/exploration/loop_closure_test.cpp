// SPDX-License-Identifier: MIT
#include "host/exploration/loop_closure.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/exploration/walked_room.hpp"

namespace echomap::exploration {
namespace {

const geometry::Polygon room{{0.0, 0.0}, {2.6, 0.0}, {2.6, 1.8}, {0.0, 1.8}};
/// The walk is round about there.
constexpr double kRoundM = 7.2;

double max_m(const std::vector<WallStep>& a, const std::vector<WallStep>& b) {
  double max_m = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    max_m = std::max(max_m, (a[i].T_map_robot.position_m() - b[i].T_map_robot.position_m()).norm());
  }
  return max_m;
}

TEST(LoopClosure, LeavesATrueWalkAlone) {
  const auto truth = walk_round(room);
  EXPECT_LT(max_m(closed_walk(truth, kRoundM, T_robot_wall_sensor), truth), 0.001);
}

// Wheels that are unlike bend the walk evenly: that is what the closure takes for the cause.
TEST(LoopClosure, TakesAnEvenBendOutOfTheWalk) {
  const auto truth = walk_round(room);
  for (const double bend_rad_per_m : {-0.01, 0.005, 0.01}) {
    const auto bent = walk_round(room, bend_rad_per_m);
    const auto closed = closed_walk(bent, kRoundM, T_robot_wall_sensor);
    EXPECT_GT(max_m(bent, truth), 0.03) << bend_rad_per_m;
    EXPECT_LT(max_m(closed, truth), 0.012) << bend_rad_per_m;
  }
}

TEST(LoopClosure, KeepsToTheOdometryWhereNoWallIsSeenTwice) {
  auto bent = walk_round(room, 0.01);
  std::erase_if(bent, [](const WallStep& step) { return step.travelled_m > kRoundM; });
  EXPECT_LT(max_m(closed_walk(bent, kRoundM, T_robot_wall_sensor), bent), 1e-12);
  EXPECT_TRUE(closed_walk({}, kRoundM, T_robot_wall_sensor).empty());
}

TEST(LoopClosure, RefusesParametersWithoutSense) {
  EXPECT_THROW(closed_walk({}, 1.0, {}, {.reach_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(closed_walk({}, 1.0, {}, {.rounds = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
