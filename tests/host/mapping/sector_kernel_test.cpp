// SPDX-License-Identifier: MIT
#include "host/mapping/sector_kernel.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

TEST(SectorKernel, FindsTheWidthOfADiscRowByRow) {
  for (const std::int32_t square : {0, 1, 24, 25, 26, 3600, 3'999'999, 4'000'000}) {
    std::vector<std::int16_t> widths(200);
    half_widths(square, -50, widths);
    for (std::int32_t i = 0; i < 200; ++i) {
      const std::int32_t y = i - 50;
      const std::int32_t width = widths[static_cast<std::size_t>(i)];
      if (y * y > square) {
        ASSERT_EQ(width, -1) << square << ' ' << y;
      } else {
        ASSERT_LE(width * width + y * y, square) << square << ' ' << y;
        ASSERT_GT((width + 1) * (width + 1) + y * y, square) << square << ' ' << y;
      }
    }
  }
}

/// Two rows of ten cells to the right of the apex, three steps each, cut to a ring.
struct TwoRows {
  std::vector<SectorRow> rows{{0, 9, kTileSide}, {0, 9, kTileSide}};
  std::vector<std::int16_t> outer{7, 20};
  std::vector<std::int16_t> inner{-1, 4};
  std::vector<std::uint8_t> steps = std::vector<std::uint8_t>(2 * kTileSide + 10, 3);
  RingRows ring{rows, outer, inner, steps.data()};
};

TEST(SectorKernel, RaisesTheCellsOfARing) {
  const TwoRows two;
  GridTile tile;
  const TouchedCells touched = add_arc(two.ring, {62, -2}, {28, 228}, tile);
  for (std::int32_t x = 0; x < kTileSide; ++x) {
    EXPECT_EQ(tile.row(62)[x], x <= 5 ? 131 : 0) << x;
    EXPECT_EQ(tile.row(63)[x], x >= 3 && x <= 7 ? 131 : 0) << x;
    EXPECT_EQ(tile.row(61)[x], 0) << x;
  }
  EXPECT_EQ(touched.first_row, 62);
  EXPECT_EQ(touched.last_row, 63);
  EXPECT_EQ(touched.first_column, 0);
  EXPECT_EQ(touched.last_column, 7);
}

TEST(SectorKernel, LowersFreeFloorToTheLimitAndNoFurther) {
  const TwoRows two;
  GridTile tile;
  for (int i = 0; i < 50; ++i) {
    add_floor(two.ring, {0, 60}, {28, 228}, tile);
  }
  EXPECT_EQ(tile.row(0)[59], 0);
  EXPECT_EQ(tile.row(0)[60], 28);
  EXPECT_EQ(tile.row(1)[63], 28);
}

TEST(SectorKernel, TellsATileThatTheRingDoesNotReach) {
  const TwoRows two;
  EXPECT_TRUE(reaches(two.ring, {0, 63}));
  EXPECT_FALSE(reaches(two.ring, {0, 64}));
  EXPECT_TRUE(reaches(two.ring, {0, -9}));
  EXPECT_FALSE(reaches(two.ring, {0, -10}));
}

}  // namespace
}  // namespace echomap::mapping
