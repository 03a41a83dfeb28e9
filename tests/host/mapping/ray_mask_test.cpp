// SPDX-License-Identifier: MIT
#include "host/mapping/ray_mask.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "host/geometry/cell_index.hpp"

namespace echomap::mapping {
namespace {

using geometry::CellIndex;
using Cells = std::set<CellIndex>;

/// Amanatides and Woo (1987) to the letter: t_max and t_delta of both axes, the smaller steps. All
/// times are multiplied by |dx| |dy| and so whole numbers.
void walk(LatticePoint from, LatticePoint to, Cells& cells) {
  const std::int64_t side = 1 << kLatticeBits;
  const std::int64_t dx = to.x - from.x;
  const std::int64_t dy = to.y - from.y;
  const auto to_border = [&](std::int64_t at, std::int64_t direction) {
    const std::int64_t in_cell = at & (side - 1);
    return direction > 0 ? side - in_cell : in_cell;
  };
  std::int64_t t_max_x = to_border(from.x, dx) * std::abs(dy);
  std::int64_t t_max_y = to_border(from.y, dy) * std::abs(dx);
  const bool x_is_longer = std::abs(dx) >= std::abs(dy);
  const bool longer_first = (x_is_longer ? dx : dy) > 0;
  CellIndex cell{from.x >> kLatticeBits, from.y >> kLatticeBits};
  const CellIndex end{to.x >> kLatticeBits, to.y >> kLatticeBits};
  cells.insert(cell);
  while (cell != end) {
    const bool x_in_a_tie = x_is_longer == longer_first;
    const bool crosses_x =
        dy == 0 || (dx != 0 && (t_max_x < t_max_y || (t_max_x == t_max_y && x_in_a_tie)));
    if (crosses_x) {
      t_max_x += side * std::abs(dy);
      cell.x += dx > 0 ? 1 : -1;
    } else {
      t_max_y += side * std::abs(dx);
      cell.y += dy > 0 ? 1 : -1;
    }
    cells.insert(cell);
  }
}

void add_ray(LatticePoint from, LatticePoint to, double covered_share, RayMask& mask) {
  const LatticePoint direction{to.x - from.x, to.y - from.y};
  mask.add_rays(from, {&direction, 1}, {&covered_share, 1});
}

Cells marked(const RayMask& mask) {
  Cells cells;
  const auto insert_tile = [&](std::int32_t column, std::int32_t row) {
    const TileBits bits = mask.tile(column, row);
    for (std::int32_t y = 0; y < kTileSide; ++y) {
      for (std::int32_t x = 0; x < kTileSide; ++x) {
        if ((bits[static_cast<std::size_t>(y)] >> x) & 1U) {
          cells.insert({column * kTileSide + x, row * kTileSide + y});
        }
      }
    }
  };
  for (std::int32_t row = 0; row < mask.tile_rows(); ++row) {
    for (std::int32_t column = 0; column < mask.tile_columns(); ++column) {
      insert_tile(column, row);
    }
  }
  return cells;
}

TEST(RayMask, MarksTheCellsOfAmanatidesAndWooOnRandomScans) {
  std::mt19937 random(17);
  for (int scan = 0; scan < 150; ++scan) {
    const auto columns = static_cast<std::int32_t>(1 + random() % 6);
    const auto rows = static_cast<std::int32_t>(1 + random() % 6);
    const auto any_point = [&] {
      const auto any = [&](std::int32_t tiles) {
        const std::uint32_t units = static_cast<std::uint32_t>(tiles) << (kTileBits + kLatticeBits);
        return static_cast<std::int32_t>(random() % units) | 1;
      };
      return LatticePoint{any(columns), any(rows)};
    };
    const LatticePoint sensor = any_point();
    RayMask mask;
    mask.reset(columns, rows);
    Cells expected;
    for (int ray = 0; ray < 40; ++ray) {
      const LatticePoint end = any_point();
      add_ray(sensor, end, 0.0, mask);
      walk(sensor, end, expected);
    }
    ASSERT_EQ(marked(mask), expected) << "scan " << scan;
  }
}

TEST(RayMask, TreatsRaysThroughCornersAndAlongAxesAlike) {
  constexpr std::int32_t kCell = 1 << kLatticeBits;
  constexpr std::int32_t kMiddle = 40 * kCell + 1;
  for (std::int32_t dy = -8; dy <= 8; ++dy) {
    for (std::int32_t dx = -8; dx <= 8; ++dx) {
      RayMask mask;
      mask.reset(2, 2);
      Cells expected;
      const LatticePoint end{kMiddle + dx * kCell / 2, kMiddle + dy * kCell / 2};
      add_ray({kMiddle, kMiddle}, end, 0.0, mask);
      walk({kMiddle, kMiddle}, end, expected);
      ASSERT_EQ(marked(mask), expected) << dx << ' ' << dy;
    }
  }
}

TEST(RayMask, IsExactInTheLargestWindow) {
  constexpr std::int32_t kTiles = kMaxWindowCells / kTileSide;
  constexpr std::int32_t kLast = (kMaxWindowCells << kLatticeBits) - 1;
  RayMask mask;
  mask.reset(kTiles, kTiles);
  Cells expected;
  for (const LatticePoint end : {LatticePoint{kLast, kLast},
                                 LatticePoint{kLast, 1},
                                 LatticePoint{1, kLast},
                                 LatticePoint{kLast, 255},
                                 LatticePoint{kLast, 257},
                                 LatticePoint{kLast, kLast - 2},
                                 LatticePoint{777'777, kLast}}) {
    add_ray({1, 1}, end, 0.0, mask);
    walk({1, 1}, end, expected);
    add_ray({end.x, 1}, {1, end.y}, 0.0, mask);
    walk({end.x, 1}, {1, end.y}, expected);
  }
  EXPECT_EQ(marked(mask), expected);
}

TEST(RayMask, LeavesOutOnlyCellsWithinTheCoveredShare) {
  std::mt19937 random(19);
  constexpr std::int32_t kSide = 4 * kTileSide << kLatticeBits;
  const auto any = [&] { return static_cast<std::int32_t>(random() % kSide) | 1; };
  for (int ray = 0; ray < 500; ++ray) {
    const LatticePoint from{any(), any()};
    const LatticePoint to{any(), any()};
    const double share = static_cast<double>(random() % 110) / 100.0;
    RayMask mask;
    mask.reset(4, 4);
    add_ray(from, to, share, mask);
    const Cells told = marked(mask);
    Cells all;
    walk(from, to, all);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), told.begin(), told.end())) << ray;
    const double covered = share * std::hypot(to.x - from.x, to.y - from.y) / (1 << kLatticeBits);
    for (const CellIndex cell : all) {
      const double range = std::hypot(cell.x + 0.5 - from.x / 256.0, cell.y + 0.5 - from.y / 256.0);
      EXPECT_TRUE(told.contains(cell) || range < covered + 0.708) << ray;
    }
  }
}

/// Those of a mask of two by two tiles whose centre is within a quadrant of a disc.
Cells cells_of(Quadrant quadrant, LatticePoint center, double radius) {
  Cells cells;
  for (std::int32_t y = 0; y < 2 * kTileSide; ++y) {
    for (std::int32_t x = 0; x < 2 * kTileSide; ++x) {
      const std::int32_t right = x * 256 + 128 - center.x;
      const std::int32_t up = y * 256 + 128 - center.y;
      const Quadrant above = right < 0 ? Quadrant::kLeftUp : Quadrant::kRightUp;
      const Quadrant below = right < 0 ? Quadrant::kLeftDown : Quadrant::kRightDown;
      if (std::hypot(right, up) <= radius && quadrant == (up < 0 ? below : above)) {
        cells.insert({x, y});
      }
    }
  }
  return cells;
}

TEST(RayMask, MarksTheQuadrantsOfADisc) {
  std::mt19937 random(21);
  for (const double radius : {0.0, 100.0, 128.0, 1000.0, 11'111.1}) {
    const LatticePoint center{16'001 + static_cast<std::int32_t>(random() % 256) / 2 * 2, 16'129};
    for (const Quadrant quadrant :
         {Quadrant::kRightUp, Quadrant::kLeftUp, Quadrant::kLeftDown, Quadrant::kRightDown}) {
      RayMask mask;
      mask.reset(2, 2);
      mask.add_quadrant(center, quadrant, radius);
      EXPECT_EQ(marked(mask), cells_of(quadrant, center, radius))
          << radius << ' ' << static_cast<int>(quadrant);
    }
  }
}

TEST(RayMask, ForgetsTheLastScan) {
  RayMask mask;
  mask.reset(1, 1);
  add_ray({1, 1}, {1001, 1}, 0.0, mask);
  mask.reset(1, 1);
  EXPECT_TRUE(marked(mask).empty());
}

}  // namespace
}  // namespace echomap::mapping
