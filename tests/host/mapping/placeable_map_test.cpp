// SPDX-License-Identifier: MIT
#include "host/mapping/placeable_map.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

/// A floor of 9 x 5 cells of 5 cm, walled on its left.
PlaceableMap floor_by_a_wall() {
  RasterMap map(12, 7, 0.05, {1.0, 2.0});
  for (int y = 1; y < 6; ++y) {
    map.set({1, y}, CellState::kOccupied);
    for (int x = 2; x < 11; ++x) {
      map.set({x, y}, CellState::kFree);
    }
  }
  return PlaceableMap(std::move(map));
}

TEST(PlaceableMap, KnowsItsWallsAndHowNearAPointIsToThem) {
  const PlaceableMap map = floor_by_a_wall();
  ASSERT_EQ(map.walls_m().size(), 5U);
  EXPECT_TRUE(map.walls_m().front().isApprox(Eigen::Vector2d(1.075, 2.075)));
  EXPECT_NEAR(map.wall_at({1.075, 2.175}, 0.1), 1.0, 1e-6);
  EXPECT_NEAR(map.wall_at({1.175, 2.175}, 0.1), std::exp(-0.5), 1e-6);
  EXPECT_LT(map.wall_at({1.525, 2.175}, 0.1), 1e-3);
}

TEST(PlaceableMap, KnowsFloorAndWalls) {
  const PlaceableMap map = floor_by_a_wall();
  EXPECT_TRUE(map.knows({1.075, 2.175}));
  EXPECT_TRUE(map.knows({1.325, 2.175}));
  EXPECT_FALSE(map.knows({1.025, 2.025}));
  EXPECT_FALSE(map.knows({-9.0, 2.0})) << "outside of it";
}

/// Neither wall nor what is unknown, nor the end of the map, may be near.
TEST(PlaceableMap, IsDeepInFloorWhereAllAroundIsFloor) {
  const PlaceableMap map = floor_by_a_wall();
  EXPECT_TRUE(map.is_deep_in_floor({1.325, 2.175}, 0.12));
  EXPECT_FALSE(map.is_deep_in_floor({1.325, 2.175}, 0.16)) << "unknown above and below";
  EXPECT_FALSE(map.is_deep_in_floor({1.125, 2.175}, 0.12)) << "beside the wall";
  EXPECT_FALSE(map.is_deep_in_floor({1.075, 2.175}, 0.01)) << "the wall";
  EXPECT_FALSE(map.is_deep_in_floor({-9.0, 2.0}, 0.01));
  EXPECT_EQ(map.deep_floor_m(0.12).size(), 5U) << "of the middle row";
}

TEST(PlaceableMap, StaysTheSameWhereItIsMoved) {
  PlaceableMap map = floor_by_a_wall();
  const PlaceableMap moved = std::move(map);
  EXPECT_EQ(moved.walls_m().size(), 5U);
  EXPECT_TRUE(moved.is_deep_in_floor({1.325, 2.175}, 0.12));
}

}  // namespace
}  // namespace echomap::mapping
