// SPDX-License-Identifier: MIT
#include "host/evaluation/floor_outline.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace echomap::evaluation {
namespace {

using geometry::Polygon;

const Polygon kHallM{{0, 0}, {4, 0}, {4, 3}, {0, 3}};

Polygon box(double left_m, double bottom_m, double right_m, double top_m) {
  return {{left_m, bottom_m}, {right_m, bottom_m}, {right_m, top_m}, {left_m, top_m}};
}

bool has(const Polygon& outline_m, const Eigen::Vector2d& corner_m) {
  return std::any_of(outline_m.begin(), outline_m.end(), [&](const Eigen::Vector2d& found_m) {
    return (found_m - corner_m).norm() < 1e-9;
  });
}

TEST(FloorOutline, OfAnEmptyRoomIsTheRoom) {
  const Polygon outline_m = floor_outline({kHallM});
  EXPECT_EQ(outline_m.size(), 4U);
  EXPECT_NEAR(geometry::signed_area_m2(outline_m), 12.0, 1e-9);
  EXPECT_TRUE(floor_outline({}).empty());
}

TEST(FloorOutline, LeavesOutWhatStandsFreeOfTheWalls) {
  EXPECT_EQ(floor_outline({kHallM, box(1, 1, 2, 2)}).size(), 4U);
}

TEST(FloorOutline, GoesAroundWhatStandsAtTheWalls) {
  EXPECT_EQ(floor_outline({kHallM, box(1, 2, 2, 3)}).size(), 8U) << "at a wall";
  const Polygon corner_m = floor_outline({kHallM, box(3, 0, 4, 1)});
  EXPECT_EQ(corner_m.size(), 6U) << "in a corner";
  EXPECT_TRUE(has(corner_m, {3, 1}));
  EXPECT_FALSE(has(corner_m, {4, 0}));
}

TEST(FloorOutline, HasNoCornerBetweenTwoThingsInARow) {
  EXPECT_EQ(floor_outline({kHallM, box(1, 2, 2, 3), box(2, 2, 3, 3)}).size(), 8U);
  EXPECT_EQ(floor_outline({kHallM, box(1, 2, 2, 3), box(2, 1.5, 3, 3)}).size(), 10U);
}

TEST(FloorOutline, IsThatOfTheLargestPart) {
  const Polygon outline_m = floor_outline({kHallM, box(1, 0, 1.2, 3)});
  EXPECT_NEAR(geometry::signed_area_m2(outline_m), 2.8 * 3.0, 1e-9);
}

}  // namespace
}  // namespace echomap::evaluation
