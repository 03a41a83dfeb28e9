// SPDX-License-Identifier: MIT
#include "host/exploration/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/segment.hpp"
#include "tests/host/exploration/random_floor.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;

/// Where a motion of wheels without error leads.
Pose2 moved(const Pose2& from, const Motion& motion) {
  if (const auto* turn = std::get_if<Turn>(&motion)) {
    return from * Pose2(0.0, 0.0, turn->angle_rad);
  }
  const auto roll = std::get<Roll>(motion);
  Pose2 at = from;
  constexpr int kSteps = 10;
  for (int i = 0; i < kSteps; ++i) {
    at = at * Pose2(roll.forward_m_per_s * roll.for_s / kSteps,
                    0.0,
                    roll.turn_rad_per_s * roll.for_s / kSteps);
  }
  return at;
}

/// 4 m x 3 m of open floor.
CostGrid costs_of_open_floor() { return {random_floor(80, 60, 0.0, 1), {0.0, 0.0}, of_a_dot()}; }

TEST(PathFollower, StaysNearTheWayAndArrivesAtItsEnd) {
  const CostGrid grid = costs_of_open_floor();
  const std::vector<Eigen::Vector2d> path_m{{0.5, 0.5}, {2.0, 0.6}, {2.2, 2.0}, {1.0, 2.5}};
  PathFollower follower;
  follower.follow(path_m);
  Pose2 at(0.5, 0.5, std::numbers::pi);
  double max_m = 0.0;
  int motions = 0;
  while (const auto motion = follower.next(at, grid)) {
    ASSERT_LT(++motions, 500);
    at = moved(at, *motion);
    double nearest_m = 1e9;
    for (std::size_t i = 1; i < path_m.size(); ++i) {
      nearest_m = std::min(
          nearest_m,
          geometry::distance_m(geometry::Segment{path_m[i - 1], path_m[i]}, at.position_m()));
    }
    max_m = std::max(max_m, nearest_m);
  }
  EXPECT_LE((at.position_m() - path_m.back()).norm(), PathFollowerParams{}.arrived_m);
  EXPECT_LT(max_m, 0.08);
}

TEST(PathFollower, TurnsOnTheSpotWhereTheWayIsBehindIt) {
  PathFollower follower;
  follower.follow({{1.0, 1.0}, {2.0, 1.0}});
  const auto motion = follower.next(Pose2(1.0, 1.0, 2.5), costs_of_open_floor());
  ASSERT_TRUE(motion);
  EXPECT_NEAR(std::get<Turn>(*motion).angle_rad, -2.5, 1e-9);
}

TEST(PathFollower, IsSlowerBesideAWallAndAtTheEnd) {
  mapping::RasterMap map = random_floor(80, 60, 0.0, 1);
  for (int x = 0; x < 80; ++x) {
    map.set({x, 0}, mapping::CellState::kOccupied);
  }
  const CostGrid grid(map, {0.0, 0.0}, {});
  const PathFollowerParams params;
  const auto speed_m_per_s = [&](const Eigen::Vector2d& at_m, const Eigen::Vector2d& to_m) {
    PathFollower follower(params);
    follower.follow({at_m, to_m});
    return std::get<Roll>(*follower.next(Pose2(at_m.x(), at_m.y(), 0.0), grid)).forward_m_per_s;
  };
  EXPECT_EQ(speed_m_per_s({1.0, 1.5}, {3.0, 1.5}), params.speed_m_per_s);
  EXPECT_LT(speed_m_per_s({1.0, 0.2}, {3.0, 0.2}), 0.5 * params.speed_m_per_s);
  EXPECT_LT(speed_m_per_s({1.0, 1.5}, {1.06, 1.5}), 0.8 * params.speed_m_per_s);
  EXPECT_GE(speed_m_per_s({1.0, 0.1}, {3.0, 0.1}), params.min_speed_m_per_s);
}

TEST(PathFollower, HasNothingToDoWithoutAWay) {
  PathFollower follower;
  EXPECT_FALSE(follower.next({}, costs_of_open_floor()));
  follower.follow({});
  EXPECT_FALSE(follower.next({}, costs_of_open_floor()));
  follower.follow({{1.0, 1.0}});
  EXPECT_FALSE(follower.next(Pose2(1.0, 1.0, 0.3), costs_of_open_floor()));
}

TEST(PathFollower, RejectsParametersWithoutSense) {
  PathFollowerParams params;
  params.min_speed_m_per_s = 1.0;
  EXPECT_THROW(PathFollower{params}, std::invalid_argument);
  params = {};
  params.look_ahead_m = 0.01;
  EXPECT_THROW(PathFollower{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
