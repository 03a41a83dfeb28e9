// SPDX-License-Identifier: MIT
#include "host/evaluation/map_difference.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/polygon.hpp"
#include "tests/host/evaluation/cupboard_room.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Polygon;
using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

const Polygon kBox{{0.2, 0.1}, {0.6, 0.1}, {0.6, 0.5}, {0.2, 0.5}};
const Polygon kBoxElsewhere{{1.4, -0.6}, {1.8, -0.6}, {1.8, -0.2}, {1.4, -0.2}};

/// A good map of the room with these boxes in it, whose map frame lies at `T_room_map`.
RasterMap mapped(const std::vector<Polygon>& boxes, const Pose2& T_room_map = {}) {
  RasterMap map(140, 140, 0.05, {-3.5, -3.5});
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d place_m = T_room_map * map.center_m({x, y});
      bool is_wall = geometry::distance_to_sides_m(kRoom, place_m) < 0.04;
      bool is_floor = geometry::contains(kRoom, place_m);
      for (const Polygon& box : boxes) {
        is_wall = is_wall || geometry::distance_to_sides_m(box, place_m) < 0.04;
        is_floor = is_floor && !geometry::contains(box, place_m);
      }
      if (is_wall || is_floor) {
        map.set({x, y}, is_wall ? CellState::kOccupied : CellState::kFree);
      }
    }
  }
  return map;
}

TEST(MapDifference, OfTheSameRoomIsNothing) {
  const auto difference = find_difference(mapped({kBox}), mapped({kBox}, {0.3, -0.2, 0.2}));
  ASSERT_TRUE(difference);
  EXPECT_TRUE(difference->regions.empty());
}

TEST(MapDifference, FindsWhatHasAppeared) {
  const auto difference = find_difference(mapped({}), mapped({kBox}));
  ASSERT_TRUE(difference);
  ASSERT_EQ(difference->regions.size(), 1U);
  const ChangedRegion& region = difference->regions[0];
  EXPECT_EQ(region.kind, ChangeKind::kAppeared);
  EXPECT_LT((region.center_m - Eigen::Vector2d(0.4, 0.3)).norm(), 0.05);
  EXPECT_NEAR(region.size_m.x(), 0.4, 0.11);
  EXPECT_NEAR(region.size_m.y(), 0.4, 0.11);
  EXPECT_GT(region.confidence, 0.9);
}

TEST(MapDifference, FindsWhatWasMovedWhereverTheRobotStarted) {
  const Pose2 T_room_after(0.25, 0.15, -0.3);
  const auto difference = find_difference(mapped({kBox}), mapped({kBoxElsewhere}, T_room_after));
  ASSERT_TRUE(difference);
  ASSERT_EQ(difference->regions.size(), 2U);
  for (const ChangedRegion& region : difference->regions) {
    const Eigen::Vector2d expected_m = region.kind == ChangeKind::kAppeared
                                           ? Eigen::Vector2d(1.6, -0.4)
                                           : Eigen::Vector2d(0.4, 0.3);
    EXPECT_LT((region.center_m - expected_m).norm(), 0.1);
  }
  EXPECT_NE(difference->regions[0].kind, difference->regions[1].kind);
}

TEST(MapDifference, TurnsAroundWithItsMaps) {
  const auto there = find_difference(mapped({}), mapped({kBox}));
  const auto back = find_difference(mapped({kBox}), mapped({}));
  ASSERT_TRUE(there && back);
  ASSERT_EQ(back->regions.size(), 1U);
  EXPECT_EQ(back->regions[0].kind, ChangeKind::kVanished);
  EXPECT_NEAR(back->regions[0].area_m2, there->regions[0].area_m2, 0.02);
}

TEST(MapDifference, CallsNothingAChangeThatOnlyOneMapHasSeen) {
  RasterMap half = mapped({kBox});
  for (int y = 0; y < half.rows(); ++y) {
    for (int x = 75; x < half.columns(); ++x) {
      half.set({x, y}, CellState::kUnknown);
    }
  }
  const auto difference = find_difference(mapped({kBox}), half);
  ASSERT_TRUE(difference);
  EXPECT_TRUE(difference->regions.empty());
}

TEST(MapDifference, OfMapsThatShareNothingIsEmpty) {
  EXPECT_FALSE(find_difference(mapped({}), tests::map_from({"...", ".#.", "..."})));
  EXPECT_FALSE(find_difference(mapped({}), tests::map_from({"   "})));
}

TEST(MapDifference, ChecksItsParameters) {
  MapDifferenceParams params;
  params.reach_m = 0.0;
  EXPECT_THROW(find_difference(mapped({}), mapped({}), params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::evaluation
