// SPDX-License-Identifier: MIT
#include "host/mapping/room_outline.hpp"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "host/geometry/pose2.hpp"
#include "host/geometry/unit_vector.hpp"
#include "tests/host/mapping/outlines.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using geometry::Segment;
using tests::map_from;

/// A room in the shape of an L, 2 x 1.5 m with a corner of 1 x 0.5 m less.
const Polygon kRoomM{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1.5}, {0, 1.5}};

Polygon turned(const Polygon& polygon, const geometry::Pose2& T) {
  Polygon turned;
  for (const Eigen::Vector2d& corner_m : polygon) {
    turned.emplace_back(T * corner_m);
  }
  return turned;
}

std::vector<Segment> walls_of(const Polygon& polygon, double unseen_m = 0.0) {
  std::vector<Segment> walls;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment side = geometry::side(polygon, i);
    const Eigen::Vector2d along = (side.to_m - side.from_m).normalized();
    walls.push_back({side.from_m + unseen_m * along, side.to_m - unseen_m * along});
  }
  return walls;
}

/// Free inside, occupied around; `noise` in a hundred cells at the border are wrongly unknown.
RasterMap raster_of(const Polygon& polygon, std::mt19937::result_type noise = 0) {
  RasterMap map(120, 120, 0.05, {-3.0, -3.0});
  std::mt19937 random(3);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d center_m = map.center_m({x, y});
      const double distance_m = geometry::distance_to_sides_m(polygon, center_m);
      if (distance_m < 0.08 && random() % 100 < noise) {
        continue;
      }
      if (geometry::contains(polygon, center_m)) {
        map.set({x, y}, CellState::kFree);
      } else if (distance_m < 0.05) {
        map.set({x, y}, CellState::kOccupied);
      }
    }
  }
  return map;
}

TEST(RoomOutline, HasTheCornersOfTheWallsHoweverTheRoomIsTurned) {
  for (const double turn_rad : {0.0, 0.1, 0.5, 0.8, 1.3, 3.0}) {
    const Polygon room_m = turned(kRoomM, {0.3, 0.2, turn_rad});
    const RasterMap map = raster_of(turned(room_m, {}));
    const auto outline = room_outline(map, {walls_of(room_m, 0.2), {}});
    ASSERT_TRUE(outline) << turn_rad;
    EXPECT_EQ(outline->outline_m().size(), 6U) << turn_rad;
    EXPECT_LT(max_corner_error_m(room_m, outline->outline_m()), 1e-6) << turn_rad;
    EXPECT_TRUE(outline->holes_m().empty()) << turn_rad;
  }
}

TEST(RoomOutline, IsNotMovedByARaggedBorder) {
  const Polygon room_m = turned(kRoomM, {0.3, 0.2, 0.3});
  const auto outline = room_outline(raster_of(room_m, 20), {walls_of(room_m, 0.2), {}});
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->outline_m().size(), 6U);
  EXPECT_LT(max_corner_error_m(room_m, outline->outline_m()), 0.02);
}

TEST(RoomOutline, HasNoCornerBetweenTwoPartsOfOneWall) {
  // The floor leaves the wall below in steps of a cell, and returns to it at once.
  const Polygon floor_m{{0, 0},
                        {0.4, 0},
                        {0.4, 0.05},
                        {0.8, 0.05},
                        {0.8, 0.1},
                        {1.2, 0.1},
                        {1.2, 0.15},
                        {1.4, 0.15},
                        {1.4, 0},
                        {2, 0},
                        {2, 1.5},
                        {0, 1.5}};
  const auto outline = room_outline(raster_of(floor_m), {{{{0.1, 0}, {1.9, 0}}}, {}});
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->outline_m().size(), 4U);
  EXPECT_LT(max_corner_error_m({{0, 0}, {2, 0}, {2, 1.5}, {0, 1.5}}, outline->outline_m()), 0.02);
}

/// A room of 2.4 x 1.5 m with a wall 0.1 m thick, from `end_m` to the top, in its middle.
Polygon divided_room(double end_m) {
  return {{0, 0},
          {2.4, 0},
          {2.4, 1.5},
          {1.25, 1.5},
          {1.25, end_m},
          {1.15, end_m},
          {1.15, 1.5},
          {0, 1.5}};
}

/// Its fitted walls, without the end of the one in the middle; of that one each side is fitted
/// behind the other.
std::vector<Segment> swapped_walls(double end_m) {
  return {{{0.1, 0}, {2.3, 0}},
          {{2.4, 0.1}, {2.4, 1.4}},
          {{2.3, 1.5}, {1.35, 1.5}},
          {{1.17, 1.4}, {1.17, end_m + 0.1}},
          {{1.23, end_m + 0.1}, {1.23, 1.4}},
          {{1.05, 1.5}, {0.1, 1.5}},
          {{0, 1.4}, {0, 0.1}}};
}

TEST(RoomOutline, CutsOffASmallLoopOfSidesThatCross) {
  const auto outline = room_outline(raster_of(divided_room(1.2)), {swapped_walls(1.2), {}});
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->outline_m().size(), 4U);
  EXPECT_LT(max_corner_error_m({{0, 0}, {2.4, 0}, {2.4, 1.5}, {0, 1.5}}, outline->outline_m()),
            1e-6);
}

TEST(RoomOutline, FollowsTheOtherWallsWhereSomeWouldMakeSidesCross) {
  const auto outline = room_outline(raster_of(divided_room(0.6)), {swapped_walls(0.6), {}});
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->outline_m().size(), 8U);
  EXPECT_LT(max_corner_error_m(divided_room(0.6), outline->outline_m()), 0.05);
  EXPECT_LT(max_corner_error_m({{0, 0}, {2.4, 0}, {2.4, 1.5}}, outline->outline_m()), 1e-6);
}

TEST(RoomOutline, ClosesAnUnseenCornerWhereTwoWallsMeet) {
  const Polygon seen_m{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1.5}, {0.35, 1.5}, {0, 1.15}};
  RasterMap map = raster_of(kRoomM);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (!geometry::contains(seen_m, map.center_m({x, y})) && map.center_m({x, y}).x() < 0.4 &&
          map.center_m({x, y}).y() > 1.1) {
        map.set({x, y}, CellState::kUnknown);
      }
    }
  }
  const auto outline = room_outline(map, {walls_of(kRoomM, 0.4), {}});
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->outline_m().size(), 6U);
  EXPECT_LT(max_corner_error_m(kRoomM, outline->outline_m()), 0.03);
}

TEST(RoomOutline, KeepsANicheThatNoFittedWallIsAt) {
  const Polygon room_m{
      {0, 0}, {2, 0}, {2, 1.5}, {1.4, 1.5}, {1.4, 1.9}, {0.6, 1.9}, {0.6, 1.5}, {0, 1.5}};
  const auto outline = room_outline(raster_of(room_m), {{{{0, 0}, {2, 0}}}, {}});
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->outline_m().size(), 8U);
  EXPECT_LT(max_corner_error_m(room_m, outline->outline_m()), 0.08);
}

TEST(RoomOutline, FollowsTheWallBehindAPatchThatTouchesItByItsTip) {
  RasterMap map = raster_of(kRoomM);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d at_m = map.center_m({x, y});
      if (std::abs(at_m.x() - 1.0) < 0.5 * at_m.y() && at_m.y() < 0.7) {
        map.set({x, y}, CellState::kUnknown);
      }
    }
  }
  const auto outline = room_outline(map, {walls_of(kRoomM), {}});
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->outline_m().size(), 6U);
  EXPECT_EQ(outline->holes_m().size(), 1U);
}

TEST(RoomOutline, HasCirclesAsHolesInPlaceOfTheirBorders) {
  RasterMap map = raster_of(kRoomM);
  const FittedCircle post{{0.5, 0.75}, 0.15, {}};
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if ((map.center_m({x, y}) - post.center_m).norm() < post.radius_m) {
        map.set({x, y}, CellState::kOccupied);
      }
    }
  }
  const auto outline = room_outline(map, {walls_of(kRoomM), {post, {{5.0, 5.0}, 0.1, {}}}});
  ASSERT_TRUE(outline);
  ASSERT_EQ(outline->holes_m().size(), 1U);
  EXPECT_NEAR(-geometry::signed_area_m2(outline->holes_m()[0]),
              std::numbers::pi * post.radius_m * post.radius_m,
              0.004);
}

TEST(RoomOutline, WithoutFeaturesIsThatOfTheGrid) {
  const RasterMap map = raster_of(kRoomM, 10);
  EXPECT_EQ(room_outline(map, {})->outline_m(), polygon_from_raster(map)->outline_m());
  EXPECT_FALSE(room_outline(map_from({"# #"}), {{{{0, 0}, {1, 0}}}, {}}));
}

TEST(RoomOutline, NeverThrowsForOddMapsAndWalls) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.5, 2.5);
  for (int trial = 0; trial < 40; ++trial) {
    RasterMap map(30, 30, 0.05, {0.0, 0.0});
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 30; ++x) {
        map.set({x, y}, static_cast<CellState>(random() % 10 < 7 ? 1 : random() % 3));
      }
    }
    SonarFeatures features;
    for (int i = 0; i < 6; ++i) {
      features.walls.push_back({{place(random), place(random)}, {place(random), place(random)}});
      features.circles.push_back({{place(random), place(random)}, 0.05 + 0.1 * (i % 3), {}});
    }
    features.walls.push_back({{1, 1}, {1, 1}});
    EXPECT_NO_THROW(room_outline(map, features)) << trial;
  }
}

TEST(RoomOutline, RefusesInvalidParameters) {
  RoomOutlineParams params;
  params.sides.sequence.corner_cost_m = -1.0;
  EXPECT_THROW(room_outline(map_from({"."}), {}, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
