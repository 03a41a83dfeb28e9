// SPDX-License-Identifier: MIT
#include "host/localization/range_table.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::localization {
namespace {

const mapping::RasterMap kSmallRoom = tests::map_from({"##########",
                                                       "#........#",
                                                       "#........#",
                                                       "#........#",
                                                       "#......#.#",
                                                       "#........#",
                                                       "#........#",
                                                       "##########"},
                                                      0.1);

/// The table's cell of a cell of the map: there is a ring around it.
constexpr geometry::CellIndex in_table(std::int32_t x, std::int32_t y) { return {x + 1, y + 1}; }

double expected_m(RangeTable& table, geometry::CellIndex cell, double heading_rad) {
  table.fill_tile(table.tile_of(cell));
  const auto heading = static_cast<std::size_t>(
      std::lround(heading_rad / (2.0 * std::numbers::pi) * RangeTable::kHeadings));
  return table.expected_of(table.codes_at(cell)[heading % RangeTable::kHeadings])
      .range_m.value_or(-1.0);
}

TEST(RangeTable, ExpectsTheWallThatAThinBeamMeets) {
  RangeTable table(kSmallRoom, {0.0, 2.0});
  const double slack_m = 2.0 / 126.0;
  EXPECT_NEAR(expected_m(table, in_table(2, 1), 0.0), 0.65, slack_m);
  EXPECT_NEAR(expected_m(table, in_table(2, 1), std::numbers::pi), 0.15, slack_m);
  EXPECT_NEAR(expected_m(table, in_table(2, 3), 0.0), 0.45, slack_m);
  EXPECT_NEAR(expected_m(table, in_table(2, 1), std::numbers::pi / 2.0), 0.55, slack_m);
}

TEST(RangeTable, ExpectsTheNearestThingInACone) {
  RangeTable thin(kSmallRoom, {0.0, 2.0});
  RangeTable wide(kSmallRoom, {0.2, 2.0});
  EXPECT_LT(expected_m(wide, in_table(2, 2), 0.0), expected_m(thin, in_table(2, 2), 0.0) - 0.1);
  EXPECT_NEAR(expected_m(wide, in_table(2, 2), 0.0), std::hypot(0.45, 0.05), 0.03);
}

TEST(RangeTable, ExpectsNothingBeyondItsRange) {
  RangeTable table(kSmallRoom, {0.0, 0.3});
  EXPECT_EQ(expected_m(table, in_table(2, 2), 0.0), -1.0);
  EXPECT_NEAR(expected_m(table, in_table(2, 2), std::numbers::pi), 0.15, 0.01);
}

TEST(RangeTable, HasNoFloorInWallsAndAroundTheMap) {
  RangeTable table(kSmallRoom, {0.0, 2.0});
  for (const auto cell : {geometry::CellIndex{0, 0}, in_table(0, 3), in_table(7, 3)}) {
    table.fill_tile(table.tile_of(cell));
    EXPECT_EQ(table.codes_at(cell)[5], RangeTable::kNoFloor);
    EXPECT_FALSE(table.is_floor(cell));
  }
}

TEST(RangeTable, CodesRangesToHalfAPart) {
  const RangeTable table(kSmallRoom, {0.0, 4.0});
  const RangeTable own(kSmallRoom, {0.0, 4.0, true});
  for (double range_m = 0.0; range_m < 4.0; range_m += 0.003) {
    for (const bool is_oblique : {false, true}) {
      const auto expected = table.expected_of(table.code_of({range_m, is_oblique}));
      ASSERT_NEAR(expected.range_m.value(), range_m, 0.5001 * 4.0 / 126.0);
      ASSERT_EQ(expected.is_oblique, is_oblique);
      ASSERT_FALSE(expected.is_unseen);
    }
    const auto unseen = own.expected_of(own.code_of({range_m, false, true}));
    ASSERT_NEAR(unseen.range_m.value(), range_m, 0.5001 * 4.0 / 84.0);
    ASSERT_TRUE(unseen.is_unseen);
    ASSERT_TRUE(own.expected_of(own.code_of({range_m, true})).is_oblique);
  }
  EXPECT_EQ(table.code_of({}), RangeTable::kNothing);
  EXPECT_EQ(table.code_of({4.0, true}), RangeTable::kNothing);
  EXPECT_FALSE(table.expected_of(RangeTable::kNothing).range_m.has_value());
}

TEST(RangeTable, KnowsAWallThatIsSeenAslant) {
  RangeTable table(kSmallRoom, {0.26, 2.0});
  const auto is_oblique = [&](double heading_rad) {
    const auto heading = static_cast<std::size_t>(
        std::lround(heading_rad / (2.0 * std::numbers::pi) * RangeTable::kHeadings));
    return table.expected_of(table.codes_at(in_table(2, 5))[heading]).is_oblique;
  };
  table.fill_tile(table.tile_of(in_table(2, 5)));
  EXPECT_FALSE(is_oblique(std::numbers::pi));
  EXPECT_TRUE(is_oblique(std::numbers::pi + 0.5));
  EXPECT_TRUE(is_oblique(std::numbers::pi - 0.5));
}

/// A room whose right wall nobody has seen but for its lower end, and a thin seam before the left.
const mapping::RasterMap kHalfSeen = tests::map_from({"##############    ",
                                                      "# ............    ",
                                                      "# ............    ",
                                                      "# ............    ",
                                                      "# ............   #",
                                                      "# ............   #",
                                                      "##################"},
                                                     0.1);

TEST(RangeTable, KnowsWhereTheKnownFloorEndsIfAsked) {
  const auto from = in_table(7, 3);
  RangeTable own(kHalfSeen, {0.2, 4.0, true});
  own.fill_tile(own.tile_of(from));
  const auto expected = [&](std::size_t heading) {
    return own.expected_of(own.codes_at(from)[heading]);
  };
  EXPECT_TRUE(expected(0).is_unseen);
  EXPECT_NEAR(expected(0).range_m.value(), 0.65, 0.05);
  EXPECT_FALSE(expected(RangeTable::kHeadings / 2).is_unseen);
  EXPECT_NEAR(expected(RangeTable::kHeadings / 2).range_m.value(), 0.65, 0.05);
  EXPECT_FALSE(expected(RangeTable::kHeadings / 4).is_unseen);
  RangeTable through(kHalfSeen, {0.2, 4.0});
  EXPECT_GT(expected_m(through, from, 0.0), 0.8);
}

TEST(RangeTable, PaysForTheTilesThatAreAskedForOnly) {
  const mapping::RasterMap hall(2000, 2000, 0.05, {0.0, 0.0});
  mapping::RasterMap with_floor = hall;
  with_floor.set({1000, 1000}, mapping::CellState::kFree);
  RangeTable table(with_floor, {0.2, 4.0});
  const std::size_t before = table.memory_bytes();
  table.fill_tile(table.tile_of(in_table(10, 10)));
  EXPECT_EQ(table.memory_bytes(), before);
  table.fill_tile(table.tile_of(in_table(1000, 1000)));
  EXPECT_EQ(table.memory_bytes(), before + 32768);
}

TEST(RangeTable, RefusesSensorsThatAreNone) {
  EXPECT_THROW(RangeTable(kSmallRoom, {-0.1, 4.0}), std::invalid_argument);
  EXPECT_THROW(RangeTable(kSmallRoom, {1.6, 4.0}), std::invalid_argument);
  EXPECT_THROW(RangeTable(kSmallRoom, {0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(RangeTable(kSmallRoom, {0.1, std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
