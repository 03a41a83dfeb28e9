// SPDX-License-Identifier: MIT
#include "host/mapping/sector_kernel.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

constexpr std::int32_t kReach = 40;
constexpr EvidenceLimits kLimits{28, 228};

/// Wedges that face right, the widest 0.8 rad off its axis; and a patch around them whose first
/// column is `first_column` and whose rows are those of the sector.
struct FacingRight {
  FacingRight(std::size_t count, const Ring& ring) : rows(count, kReach) {
    std::vector<Wedge> wedges;
    for (std::size_t i = 0; i < count; ++i) {
      const double half_rad = 0.8 * (1.0 - static_cast<double>(i) / static_cast<double>(count));
      wedges.emplace_back(geometry::unit_vector(0.0), geometry::unit_vector(half_rad));
    }
    rows.lay_out(wedges, ring);
  }

  Patch patch(std::int32_t first_column) const {
    return {first_column, {rows.bounds().min.y, rows.bounds().max.y}};
  }

  /// The sum of the heights of the wedges that a cell of the patch is in.
  int sum(const std::vector<std::uint8_t>& heights, std::int32_t row, std::int32_t x) const {
    int sum = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      sum += holds(rows.wedge(i, rows.bounds().min.y), row, x) ? heights[i] : 0;
    }
    const bool is_cut = rows.has_hole() && holds(rows.hole(rows.bounds().min.y), row, x);
    return is_cut ? 0 : sum;
  }

  static bool holds(const RowColumns& columns, std::int32_t row, std::int32_t x) {
    return x >= -columns.minus_from[row] && x < -columns.minus_to[row];
  }

  SectorRows rows;
};

TEST(SectorKernel, AddsUpAnyNumberOfWedges) {
  for (std::size_t count = 1; count <= kMostWedges; ++count) {
    for (const std::int32_t hole : {-1, 90}) {
      for (const std::int32_t first_column : {-20, 0, 3, 10}) {
        const std::vector<std::uint8_t> heights = {7, 3, 254, 5, 2, 1, 9, 4};
        const std::vector<std::uint8_t> used(heights.begin(),
                                             heights.begin() + static_cast<std::ptrdiff_t>(count));
        const FacingRight sector(count, {hole, 400});
        const WedgeSteps steps(used, kReach);
        GridTile tile;
        add_arc(sector.rows, steps, sector.patch(first_column), kLimits, tile.row(0));
        for (std::int32_t row = 0; row < sector.rows.bounds().rows(); ++row) {
          for (std::int32_t x = 0; x < kPatchSide; ++x) {
            const int sum = sector.sum(used, row, first_column + x) & 255;
            ASSERT_EQ(tile.row(row)[x], sum == 0 ? 0 : kEvenByte + sum) << row << ' ' << x;
          }
        }
      }
    }
  }
}

TEST(SectorKernel, LowersFreeFloorToTheLimitAndNoFurther) {
  const FacingRight sector(1, {-1, 100});
  const WedgeSteps steps(std::vector<std::uint8_t>{3}, kReach);
  GridTile tile;
  for (int i = 0; i < 50; ++i) {
    add_floor(sector.rows, steps, sector.patch(-1), kLimits, tile.row(0));
  }
  const std::int32_t apex_row = -sector.rows.bounds().min.y;
  EXPECT_EQ(tile.row(apex_row)[0], 0);
  EXPECT_EQ(tile.row(apex_row)[1], 28);
  EXPECT_EQ(tile.row(apex_row)[11], 28);
  EXPECT_EQ(tile.row(apex_row)[12], 0);
}

TEST(SectorKernel, LeavesWhatIsBesideThePatch) {
  const FacingRight sector(1, {-1, 1600});
  const WedgeSteps steps(std::vector<std::uint8_t>{3}, kReach);
  GridTile tile;
  add_floor(sector.rows, steps, {0, {-2, 2}}, kLimits, tile.row(10));
  for (std::int32_t y = 0; y < kTileSide; ++y) {
    EXPECT_EQ(tile.row(y)[31], y >= 10 && y <= 14 ? 125 : 0) << y;
    EXPECT_EQ(tile.row(y)[32], 0) << y;
  }
}

}  // namespace
}  // namespace echomap::mapping
