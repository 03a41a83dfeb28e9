// SPDX-License-Identifier: MIT
#include "host/evaluation/floor_seen.hpp"

#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kHullM = 0.1;

/// Two rooms of 2 x 1 m with a wall between, in cells of 1 cm: the robot starts in the left one.
/// The wall has a door of so many cells.
RasterMap two_rooms(int door_cells) {
  RasterMap truth(410, 100, 0.01, {0.0, 0.0});
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 410; ++x) {
      const bool wall = x >= 200 && x < 210 && y >= door_cells;
      truth.set({x, y}, wall ? CellState::kOccupied : CellState::kFree);
    }
  }
  return truth;
}

/// A map in the world's place that has everything from x = 0 to `to_m` as floor.
RasterMap floor_to(double to_m) {
  RasterMap map(90, 30, 0.05, {-0.2, -0.2});
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 90; ++x) {
      if (map.center_m({x, y}).x() < to_m) {
        map.set({x, y}, CellState::kFree);
      }
    }
  }
  return map;
}

const Eigen::Vector2d kBeginM(0.5, 0.5);

TEST(FloorSeen, IsTheShareOfTheFloorInReachThatIsOnTheMap) {
  EXPECT_DOUBLE_EQ(floor_seen(floor_to(2.0), {}, two_rooms(0), kBeginM, kHullM), 1.0);
  EXPECT_NEAR(floor_seen(floor_to(1.0), {}, two_rooms(0), kBeginM, kHullM), 0.5, 1e-3);
}

TEST(FloorSeen, ARoomBehindADoorThatIsTooNarrowDoesNotCount) {
  EXPECT_GT(floor_seen(floor_to(2.0), {}, two_rooms(15), kBeginM, kHullM), 0.95);
  EXPECT_NEAR(floor_seen(floor_to(2.0), {}, two_rooms(40), kBeginM, kHullM), 0.5, 0.02);
}

TEST(FloorSeen, IsLookedUpWhereTheMapIsPlaced) {
  const Pose2 T_world_map(2.0, 1.0, std::numbers::pi);
  EXPECT_DOUBLE_EQ(floor_seen(floor_to(2.0), T_world_map, two_rooms(0), kBeginM, kHullM), 1.0);
  EXPECT_LT(floor_seen(floor_to(2.0), Pose2(3.0, 0.0, 0.0), two_rooms(0), kBeginM, kHullM), 0.2);
}

TEST(FloorSeen, TakesTheFloorNextToAStartBesideAWall) {
  EXPECT_DOUBLE_EQ(floor_seen(floor_to(2.0), {}, two_rooms(0), {0.02, 0.02}, kHullM), 1.0);
}

TEST(FloorSeen, RejectsARobotWithoutSize) {
  EXPECT_THROW(floor_seen(floor_to(2.0), {}, two_rooms(0), kBeginM, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::evaluation
