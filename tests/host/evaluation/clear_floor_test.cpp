// SPDX-License-Identifier: MIT
#include "host/evaluation/clear_floor.hpp"

#include <gtest/gtest.h>

namespace echomap::evaluation {
namespace {

using mapping::CellState;
using mapping::RasterMap;

/// 9 x 5 cells of 10 cm, free but for a column of obstacles at x = 4.
RasterMap divided() {
  RasterMap map(9, 5, 0.1, {0.0, 0.0});
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 9; ++x) {
      map.set({x, y}, x == 4 ? CellState::kOccupied : CellState::kFree);
    }
  }
  return map;
}

TEST(KeepOff, TakesWhatIsNearerThanTheMargin) {
  RasterMap floor = divided();
  keep_off(
      divided(), [](CellState state) { return state == CellState::kOccupied; }, 0.15, floor);
  EXPECT_EQ(floor.state({3, 2}), CellState::kUnknown);
  EXPECT_EQ(floor.state({5, 2}), CellState::kUnknown);
  EXPECT_EQ(floor.state({2, 2}), CellState::kFree);
  EXPECT_EQ(floor.state({6, 2}), CellState::kFree);
}

TEST(TakeRegion, TakesWhatHangsTogether) {
  RasterMap floor = divided();
  EXPECT_EQ(take_region_m({0, 0}, floor).size(), 4U * 5U);
  EXPECT_TRUE(take_region_m({0, 0}, floor).empty()) << "it was taken";
  EXPECT_TRUE(take_region_m({4, 0}, floor).empty());
  EXPECT_EQ(floor.state({8, 4}), CellState::kFree);
}

TEST(Padded, HasAMarginOfOneUnknownCell) {
  const RasterMap map = padded(divided());
  EXPECT_EQ(map.columns(), 11);
  EXPECT_EQ(map.state({0, 0}), CellState::kUnknown);
  EXPECT_EQ(map.state({1, 1}), CellState::kFree);
}

}  // namespace
}  // namespace echomap::evaluation
