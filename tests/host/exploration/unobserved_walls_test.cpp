// SPDX-License-Identifier: MIT
#include "host/exploration/unobserved_walls.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::exploration {
namespace {

using mapping::CellState;
using mapping::RasterMap;

/// The wall x = 2 from y = 0 to 1, its floor at smaller x.
const geometry::Segment kWall{{2.0, 0.0}, {2.0, 1.0}};

TEST(UnobservedWalls, AreThoseThatADoorMayBeIn) {
  const UnobservedWallParams params;
  const double half_m = 0.5 * (params.min_length_m + params.door_m);
  const auto unobserved = unobserved_walls(
      {kWall, {{0.0, 0.0}, {half_m, 0.0}}, {{0.0, 0.0}, {0.19, 0.0}}}, 0.5, params);
  ASSERT_EQ(unobserved.size(), 2U);
  EXPECT_NEAR(unobserved[1].floor_m2, 0.5 * params.floor_chance * 0.5 * half_m, 1e-12);
  EXPECT_EQ(unobserved[0].wall.to_m, kWall.to_m);
  EXPECT_NEAR(unobserved[0].floor_m2, params.floor_chance * 0.5, 1e-12);
  EXPECT_NEAR((before_m(unobserved[0], 0.1) - Eigen::Vector2d(1.9, 0.5)).norm(), 0.0, 1e-12);
}

TEST(FacingRad, IsTheBearingOfTheFootOfThePerpendicular) {
  const auto bearing_rad = facing_rad(tests::free_floor(), {1.0, 0.7}, kWall, {});
  ASSERT_TRUE(bearing_rad);
  EXPECT_NEAR(*bearing_rad, 0.0, 1e-9);
}

TEST(FacingRad, IsEmptyBesideAndBehindAndFarFromTheWall) {
  for (const Eigen::Vector2d& from_m : {Eigen::Vector2d(1.0, 1.2),
                                        Eigen::Vector2d(1.0, 0.95),
                                        Eigen::Vector2d(1.0, -0.1),
                                        Eigen::Vector2d(2.5, 0.5),
                                        Eigen::Vector2d(-0.9, 0.5)}) {
    EXPECT_FALSE(facing_rad(tests::free_floor(), from_m, kWall, {})) << from_m.transpose();
  }
}

TEST(FacingRad, IsEmptyWhereSomethingStandsBetween) {
  RasterMap map = tests::free_floor();
  map.set(map.cell_at({1.5, 0.7}), CellState::kOccupied);
  EXPECT_FALSE(facing_rad(map, {1.0, 0.71}, kWall, {}));
  map = tests::free_floor();
  map.set(map.cell_at({1.98, 0.7}), CellState::kOccupied);
  EXPECT_TRUE(facing_rad(map, {1.0, 0.71}, kWall, {})) << "that is the wall itself";
}

}  // namespace
}  // namespace echomap::exploration
