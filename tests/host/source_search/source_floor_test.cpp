// SPDX-License-Identifier: MIT
#include "host/source_search/source_floor.hpp"

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::source_search {
namespace {

using geometry::CellIndex;

/// Cells of 5 cm; floor to the left.
SourceFloor floor_with_a_way() {
  SourceFloor floor(tests::map_from({"..      ", "..######", "..      "}));
  return floor;
}

TEST(SourceFloor, UnknownCellsAreReachedAsLikelyAsTheWayIsFloor) {
  SourceFloor floor = floor_with_a_way();
  floor.floor_share[{3, 0}] = 0.25F;
  const UnknownReach reach = unknown_reach(floor, 4);
  EXPECT_EQ((reach.share[CellIndex{0, 0}]), 1.0F);
  EXPECT_EQ((reach.share[CellIndex{2, 0}]), 1.0F);
  EXPECT_EQ((reach.share[CellIndex{5, 0}]), 0.25F);
  EXPECT_EQ((reach.share[CellIndex{5, 2}]), 1.0F);
  EXPECT_EQ((reach.steps[CellIndex{5, 2}]), 4);
}

TEST(SourceFloor, WhatIsTooFarOrOccupiedIsNotReached) {
  const UnknownReach reach = unknown_reach(floor_with_a_way(), 4);
  EXPECT_EQ((reach.share[CellIndex{6, 0}]), 0.0F);
  EXPECT_EQ((reach.share[CellIndex{3, 1}]), 0.0F);
}

TEST(SourceFloor, AShortWayLeadsFartherThanALongOneThatIsMoreLikely) {
  SourceFloor floor(tests::map_from({".       ", "## #####", ".       "}));
  floor.floor_share[{1, 0}] = 0.25F;
  const UnknownReach reach = unknown_reach(floor, 5);
  EXPECT_EQ((reach.share[CellIndex{3, 0}]), 1.0F) << "by the other row";
  EXPECT_EQ((reach.share[CellIndex{5, 0}]), 0.25F) << "straight on";
  EXPECT_EQ((reach.share[CellIndex{6, 0}]), 0.0F);
}

TEST(SourceFloor, BeyondItsReachEachWayGoesOn) {
  SourceFloor floor = floor_with_a_way();
  // Two ways of a cell's width, for 2 m.
  EXPECT_NEAR(floor_beyond_m2(floor, 0.2, 0.1, 2.0), 2 * 0.05 * 2.0, 1e-9);
  floor.floor_share[{2, 0}] = 0.5F;
  EXPECT_NEAR(floor_beyond_m2(floor, 0.2, 0.1, 2.0), 1.5 * 0.05 * 2.0, 1e-6);
}

TEST(SourceFloor, SightEndsInWallsAndInTheUnknown) {
  const mapping::RasterMap map = tests::map_from({"..      ", "..######", "........"});
  EXPECT_TRUE(is_in_sight(map, {0.02, 0.02}, {0.38, 0.02}, 0.1, 0.1)) << "known floor";
  EXPECT_FALSE(is_in_sight(map, {0.02, 0.07}, {0.38, 0.07}, 0.1, 0.5)) << "wall";
  EXPECT_TRUE(is_in_sight(map, {0.02, 0.12}, {0.17, 0.12}, 0.1, 0.1)) << "a bit of unknown";
  EXPECT_FALSE(is_in_sight(map, {0.02, 0.12}, {0.38, 0.12}, 0.1, 0.1)) << "much of it";
}

}  // namespace
}  // namespace echomap::source_search
