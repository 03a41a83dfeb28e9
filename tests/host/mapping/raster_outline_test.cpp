// SPDX-License-Identifier: MIT
#include "host/mapping/raster_outline.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using geometry::Polygon;
using tests::map_from;

TEST(RasterOutline, GoesAlongTheEdgesOfTheCells) {
  const auto rings = free_floor_rings(map_from({"####", "#..#", "####"}, 0.5, {-1.0, 2.0}));
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(geometry::signed_area_m2(rings[0]), 0.5);
  EXPECT_EQ(rings[0], (Polygon{{0.5, 2.5}, {0.5, 3.0}, {-0.5, 3.0}, {-0.5, 2.5}}));
}

TEST(RasterOutline, FloorMayReachTheEdgeOfTheMap) {
  const auto rings = free_floor_rings(map_from({"..", ".."}, 1.0));
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(geometry::signed_area_m2(rings[0]), 4.0);
}

TEST(RasterOutline, TakesTheLargestPieceOnly) {
  const auto rings = free_floor_rings(map_from({"..#...", "..#...", "..#..."}, 1.0));
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(geometry::signed_area_m2(rings[0]), 9.0);
}

TEST(RasterOutline, BordersWhatItEncloses) {
  const auto rings = free_floor_rings(map_from({".....", ".#...", "...#.", "....."}, 1.0));
  ASSERT_EQ(rings.size(), 3U);
  EXPECT_EQ(geometry::signed_area_m2(rings[0]), 20.0);
  EXPECT_EQ(geometry::signed_area_m2(rings[1]), -1.0);
  EXPECT_EQ(geometry::signed_area_m2(rings[2]), -1.0);
}

TEST(RasterOutline, GivesUpACellThatHangsOnACorner) {
  const auto rings = free_floor_rings(map_from({"...", ".##", ".#.", "..."}, 1.0));
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_FALSE(geometry::polygon_fault(rings[0]));
  const auto pinched = free_floor_rings(map_from({"...", ".#.", "#..", "..."}, 1.0));
  ASSERT_EQ(pinched.size(), 1U);
  EXPECT_FALSE(geometry::polygon_fault(pinched[0]));
  EXPECT_EQ(geometry::signed_area_m2(pinched[0]), 9.0);
}

TEST(RasterOutline, OfNoFloorIsEmpty) {
  EXPECT_TRUE(free_floor_rings(map_from({"# ", " #"})).empty());
}

TEST(RasterOutline, HasNoFaultsAndTheFloorsAreaInRandomMaps) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    RasterMap map(12, 10, 1.0, {0.0, 0.0});
    for (int y = 0; y < 10; ++y) {
      for (int x = 0; x < 12; ++x) {
        map.set({x, y}, random() % 10 < 7 ? CellState::kFree : CellState::kOccupied);
      }
    }
    const auto rings = free_floor_rings(map);
    double floor_m2 = 0.0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      EXPECT_FALSE(geometry::polygon_fault(rings[i])) << trial;
      EXPECT_EQ(geometry::signed_area_m2(rings[i]) > 0.0, i == 0) << trial;
      floor_m2 += geometry::signed_area_m2(rings[i]);
    }
    for (int y = 0; y < 10; ++y) {
      for (int x = 0; x < 12; ++x) {
        bool inside = geometry::contains(rings.front(), map.center_m({x, y}));
        for (std::size_t i = 1; i < rings.size(); ++i) {
          inside = inside && !geometry::contains(rings[i], map.center_m({x, y}));
        }
        EXPECT_TRUE(!inside || map.state({x, y}) == CellState::kFree) << trial;
        floor_m2 -= inside ? 1.0 : 0.0;
      }
    }
    EXPECT_NEAR(floor_m2, 0.0, 1e-9) << trial;
  }
}

}  // namespace
}  // namespace echomap::mapping
