// SPDX-License-Identifier: MIT
#include "tests/benchmarks/room_symmetry.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/benchmarks/truth_rooms.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::bench {
namespace {

using geometry::radians;

world::FloorPlan room_of(world::Polygon corners_m, std::vector<world::Outline> obstacles = {}) {
  return {"room", {std::move(corners_m), {}}, std::move(obstacles), {1.2, 1.2, 0.0}};
}

TEST(RoomSymmetry, OfARectangleIsAHalfTurn) {
  const auto plan = room_of(world::rectangle(0.0, 0.0, 4.0, 3.0));
  EXPECT_NEAR(symmetry_turn_rad(plan).value(), radians(180.0), 1e-9);
  EXPECT_NEAR(turned_floor_iou(plan, radians(90.0)), 9.0 / 15.0, 0.01);
}

TEST(RoomSymmetry, OfASquareIsAQuarterTurn) {
  const auto plan = room_of(world::rectangle(0.0, 0.0, 3.0, 3.0));
  EXPECT_NEAR(symmetry_turn_rad(plan).value(), radians(90.0), 1e-9);
}

TEST(RoomSymmetry, OfATriangleIsAThirdOfATurn) {
  const auto plan = room_of({{0.0, 0.0}, {4.0, 0.0}, {2.0, 2.0 * std::sqrt(3.0)}});
  EXPECT_NEAR(symmetry_turn_rad(plan).value(), radians(120.0), 1e-9);
}

TEST(RoomSymmetry, EndsWhereAnObstacleStandsOnOneSideOnly) {
  const world::Outline one{world::rectangle(0.2, 0.2, 0.8, 0.8), {}};
  const world::Outline other{world::rectangle(3.2, 2.2, 3.8, 2.8), {}};
  EXPECT_FALSE(symmetry_turn_rad(room_of(world::rectangle(0.0, 0.0, 4.0, 3.0), {one})));
  EXPECT_TRUE(symmetry_turn_rad(room_of(world::rectangle(0.0, 0.0, 4.0, 3.0), {one, other})));
}

TEST(RoomSymmetry, OfTheSixteenRooms) {
  std::vector<std::string> alike;
  for (const std::string& name : truth_room_names()) {
    const world::FloorPlan plan = truth_room(name, {}).plan;
    if (const auto turn_rad = symmetry_turn_rad(plan)) {
      alike.push_back(fmt::format("{} {:.0f}", name, geometry::degrees(*turn_rad)));
    }
  }
  EXPECT_THAT(alike, testing::ElementsAre("round_room 45"));
}

}  // namespace
}  // namespace echomap::bench
