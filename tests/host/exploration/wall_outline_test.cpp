// SPDX-License-Identifier: MIT
#include "host/exploration/wall_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/exploration/walked_room.hpp"

namespace echomap::exploration {
namespace {

using geometry::Polygon;

Polygon outline_of(const std::vector<WallStep>& steps, const Polygon& room) {
  double round_m = 0.0;
  for (std::size_t i = 0; i < room.size(); ++i) {
    round_m += geometry::side(room, i).length_m();
  }
  // A walk inside of a room of right angles is shorter than its walls.
  return wall_outline(steps, round_m - 2.0, T_robot_wall_sensor);
}

double nearest_m(const Polygon& outline, const Eigen::Vector2d& place_m) {
  double nearest_m = 1e9;
  for (const Eigen::Vector2d& corner_m : outline) {
    nearest_m = std::min(nearest_m, (corner_m - place_m).norm());
  }
  return nearest_m;
}

/// A convex room, an L and a T, as paper and issue have them.
const std::vector<Polygon> rooms{
    {{0.0, 0.0}, {2.5, 0.0}, {2.5, 2.0}, {0.0, 2.0}},
    {{0.0, 0.0}, {2.4, 0.3}, {2.0, 2.1}, {0.2, 1.9}},
    {{0.0, 0.0}, {2.6, 0.0}, {2.6, 1.1}, {1.2, 1.1}, {1.2, 2.4}, {0.0, 2.4}},
    {{0.9, 0.0},
     {2.1, 0.0},
     {2.1, 1.3},
     {3.0, 1.3},
     {3.0, 2.5},
     {0.0, 2.5},
     {0.0, 1.3},
     {0.9, 1.3}},
};

TEST(WallOutline, HasTheCornersOfTheRoomAndNoOther) {
  for (const Polygon& room : rooms) {
    const Polygon outline = outline_of(walk_round(room), room);
    EXPECT_EQ(outline.size(), room.size());
    for (const Eigen::Vector2d& corner_m : room) {
      EXPECT_LT(nearest_m(outline, corner_m), 0.002) << corner_m.transpose();
    }
    EXPECT_GT(geometry::signed_area_m2(outline), 0.0);
  }
}

TEST(WallOutline, KeepsItsCornersInNoise) {
  const Polygon& room = rooms[2];
  auto steps = walk_round(room);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    *steps[i].contact.range_m += 0.01 * std::sin(12.9 * double(i));
  }
  steps[100].contact.range_m = 0.4;
  const Polygon outline = outline_of(steps, room);
  EXPECT_EQ(outline.size(), room.size());
  for (const Eigen::Vector2d& corner_m : room) {
    EXPECT_LT(nearest_m(outline, corner_m), 0.02) << corner_m.transpose();
  }
}

TEST(WallOutline, IsAPolygonOfFewCornersInARoundRoom) {
  Polygon round;
  for (int i = 0; i < 120; ++i) {
    const double bearing_rad = 2.0 * std::numbers::pi * i / 120;
    round.emplace_back(1.5 * std::cos(bearing_rad), 1.5 * std::sin(bearing_rad));
  }
  std::vector<WallStep> steps;
  const double range_m = (0.2 - 0.1) / std::sin(-T_robot_wall_sensor.heading_rad());
  for (int i = 0; i < 1700; ++i) {
    const double bearing_rad = 0.004 * i;
    const geometry::Pose2 pose(
        1.3 * std::cos(bearing_rad), 1.3 * std::sin(bearing_rad), bearing_rad + 1.5707963);
    steps.push_back({pose, {false, false, true, range_m}, 1.3 * bearing_rad, bearing_rad});
  }
  const Polygon outline = wall_outline(steps, 1.3 * 6.0, T_robot_wall_sensor);
  EXPECT_GE(outline.size(), 8U);
  EXPECT_LE(outline.size(), 24U);
  for (const Eigen::Vector2d& corner_m : outline) {
    EXPECT_NEAR(corner_m.norm(), 1.5, 0.08);
  }
}

TEST(WallOutline, IsEmptyWithoutAWalk) {
  EXPECT_TRUE(wall_outline({}, 0.0, T_robot_wall_sensor).empty());
}

TEST(WallOutline, RefusesParametersWithoutSense) {
  EXPECT_THROW(wall_outline({}, 0.0, {}, {.straight_m = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
