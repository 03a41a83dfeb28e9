// SPDX-License-Identifier: MIT
#include "host/mapping/map_placement.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::Pose2;

constexpr double kEdgeM = 0.05;

struct Box {
  Eigen::Vector2d low_m;
  Eigen::Vector2d high_m;

  bool holds(const Eigen::Vector2d& point_m, double margin_m) const {
    return (point_m.array() > low_m.array() - margin_m).all() &&
           (point_m.array() < high_m.array() + margin_m).all();
  }
};

/// A room with things in it, as a robot maps it that starts at `T_world_start` and has only seen
/// `seen`.
PlaceableMap map_of_room(const Box& room,
                         const std::vector<Box>& things,
                         const Pose2& T_world_start,
                         const Box& seen) {
  const Eigen::Vector2d middle_m = T_world_start.inverse() * (0.5 * (room.low_m + room.high_m));
  RasterMap map(120, 120, kEdgeM, middle_m.array() - 3.0);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d at_m = T_world_start * map.center_m({x, y});
      const bool in_room = room.holds(at_m, 0.0);
      bool in_thing = false;
      bool near_thing = false;
      for (const Box& thing : things) {
        in_thing = in_thing || thing.holds(at_m, -kEdgeM);
        near_thing = near_thing || thing.holds(at_m, 0.0);
      }
      if (!seen.holds(at_m, 0.0) || in_thing || !room.holds(at_m, kEdgeM)) {
        continue;
      }
      map.set({x, y}, !in_room || near_thing ? CellState::kOccupied : CellState::kFree);
    }
  }
  return PlaceableMap(std::move(map));
}

const Box kRoomBox{{0.0, 0.0}, {4.0, 3.0}};
const Box kAll{{-1.0, -1.0}, {6.0, 6.0}};
const std::vector<Box> kFurniture{{{2.0, 1.4}, {4.0, 3.0}}, {{0.0, 2.4}, {0.9, 3.0}}};

void expect_near(const Pose2& found, const Pose2& expected) {
  EXPECT_NEAR((found.position_m() - expected.position_m()).norm(), 0.0, 0.05);
  EXPECT_NEAR(geometry::angle_between(found.heading_rad(), expected.heading_rad()), 0.0, 0.03);
}

TEST(MapPlacement, FindsAMapThatLiesAnywhereAndHoweverTurned) {
  const Pose2 T_world_previous(1.0, 1.0, 0.3);
  const PlaceableMap previous = map_of_room(kRoomBox, kFurniture, T_world_previous, kAll);
  for (const double heading_rad : {0.0, 1.0, 2.5, -2.0, -0.7}) {
    const Pose2 T_world_later(2.4, 1.7, heading_rad);
    const PlaceableMap later = map_of_room(kRoomBox, kFurniture, T_world_later, kAll);
    const auto sure = sure_placement(find_placements(previous, later));
    ASSERT_TRUE(sure) << heading_rad;
    expect_near(sure->T_previous_later, T_world_previous.inverse() * T_world_later);
    EXPECT_LT(sure->contradicting_m, 0.5);
  }
}

TEST(MapPlacement, FindsAPartOfARoomInTheWhole) {
  const Pose2 T_world_later(0.7, 0.7, -1.2);
  const PlaceableMap previous = map_of_room(kRoomBox, kFurniture, {}, kAll);
  const Box west{{-1.0, -1.0}, {3.2, 6.0}};
  const auto sure = sure_placement(
      find_placements(previous, map_of_room(kRoomBox, kFurniture, T_world_later, west)));
  ASSERT_TRUE(sure);
  expect_near(sure->T_previous_later, T_world_later);
}

TEST(MapPlacement, IsNotSureInARoomThatIsTheSameWhenItIsTurned) {
  const PlaceableMap previous = map_of_room(kRoomBox, {}, {}, kAll);
  const auto placements =
      find_placements(previous, map_of_room(kRoomBox, {}, {1.0, 1.0, 0.5}, kAll));
  ASSERT_GE(placements.size(), 2U);
  EXPECT_GT(placements[1].weight_m(), 0.8 * placements[0].weight_m());
  EXPECT_FALSE(sure_placement(placements));
}

TEST(MapPlacement, IsNotSureOfAnotherRoom) {
  const PlaceableMap previous = map_of_room(kRoomBox, kFurniture, {}, kAll);
  const Box hall{{0.0, 0.0}, {5.2, 2.2}};
  const std::vector<Box> shelves{{{2.0, 1.8}, {4.0, 2.2}}};
  EXPECT_FALSE(
      sure_placement(find_placements(previous, map_of_room(hall, shelves, {1.0, 1.0, 0.5}, kAll))));
}

TEST(MapPlacement, ThereIsNoneOfAMapWithoutWalls) {
  const PlaceableMap empty(RasterMap(1, 1, kEdgeM, {0.0, 0.0}));
  const PlaceableMap room = map_of_room(kRoomBox, kFurniture, {}, kAll);
  EXPECT_TRUE(find_placements(room, empty).empty());
  EXPECT_TRUE(find_placements(empty, room).empty());
  EXPECT_FALSE(sure_placement({}));
}

}  // namespace
}  // namespace echomap::mapping
