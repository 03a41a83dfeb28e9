// SPDX-License-Identifier: MIT
#include "host/exploration/unknown_islands.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::exploration {
namespace {

using mapping::CellState;

/// '.' is floor, '#' occupied, ' ' unknown; the first row is the lowest.
mapping::RasterMap map_of(const std::vector<std::string>& rows) {
  mapping::RasterMap map(
      static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), 0.05, {0.0, 0.0});
  for_each_cell(map, [&](geometry::CellIndex cell) {
    const char drawn = rows[static_cast<std::size_t>(cell.y)][static_cast<std::size_t>(cell.x)];
    map.set(cell,
            drawn == '.'   ? CellState::kFree
            : drawn == '#' ? CellState::kOccupied
                           : CellState::kUnknown);
  });
  return map;
}

TEST(OccupiedRimShares, AreThoseOfEachIsland) {
  auto shares = occupied_rim_shares(
      map_of({"..........", ". .. .  ..", "...  .  ..", "....#.##..", ".........."}));
  EXPECT_FLOAT_EQ((shares[{1, 1}]), 0.0F);
  EXPECT_FLOAT_EQ((shares[{4, 1}]), 1.0F / 8.0F);
  EXPECT_FLOAT_EQ((shares[{3, 2}]), 1.0F / 8.0F);
  EXPECT_FLOAT_EQ((shares[{7, 1}]), 2.0F / 8.0F);
  EXPECT_FLOAT_EQ((shares[{0, 0}]), 1.0F) << "floor";
}

TEST(OccupiedRimShares, AreWholeWhereTheUnknownReachesTheEdgeOfTheMap) {
  auto shares = occupied_rim_shares(map_of({".....", "...  ", ". ...", "....."}));
  EXPECT_FLOAT_EQ((shares[{3, 1}]), 1.0F);
  EXPECT_FLOAT_EQ((shares[{1, 2}]), 0.0F);
}

}  // namespace
}  // namespace echomap::exploration
