// SPDX-License-Identifier: MIT
#include "host/exploration/travel_field.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/exploration/random_floor.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::exploration {
namespace {

using geometry::CellIndex;

/// The cheapest ways from one cell by trying all steps until no way becomes cheaper.
std::vector<double> by_brute_force_m(const CostGrid& grid, CellIndex from) {
  constexpr double kAcross = 1.4;
  std::vector<double> costs_m(grid.costs().size(), std::numeric_limits<double>::infinity());
  if (!grid.is_open(from)) {
    return costs_m;
  }
  costs_m[grid.index(from)] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < costs_m.size(); ++i) {
      const CellIndex cell = grid.cell(i);
      for (int step = 0; step < 9; ++step) {
        const CellIndex next{cell.x + step % 3 - 1, cell.y + step / 3 - 1};
        if (step == 4 || !grid.is_open(cell) || !grid.is_open(next)) {
          continue;
        }
        const double price = 0.5 * (grid.costs()[i] + grid.costs()[grid.index(next)]);
        const double length_m = grid.resolution_m() * (step % 2 == 1 ? 1.0 : kAcross);
        const double cost_m = costs_m[i] + length_m * price / CostGrid::kPlain;
        if (cost_m < costs_m[grid.index(next)] - 1e-12) {
          costs_m[grid.index(next)] = cost_m;
          changed = true;
        }
      }
    }
  }
  return costs_m;
}

TEST(TravelField, CostsWhatTheCheapestOfAllWaysCosts) {
  TravelField field;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const CostGrid grid(random_floor(23, 17, 0.02 * seed, seed), {0.0, 0.0}, of_a_dot());
    const CellIndex from{11, 8};
    field.search(grid, from);
    const auto expected_m = by_brute_force_m(grid, from);
    for (std::size_t i = 0; i < expected_m.size(); ++i) {
      const auto cost_m = field.cost_m(grid.cell(i));
      ASSERT_EQ(cost_m.has_value(), std::isfinite(expected_m[i])) << "seed " << seed;
      if (cost_m) {
        ASSERT_NEAR(*cost_m, expected_m[i], 1e-9) << "seed " << seed;
      }
    }
  }
}

TEST(TravelField, ReachesNothingFromAClosedCellOrFromOutside) {
  const CostGrid grid(tests::map_from({".....", ".#...", "....."}), {0.0, 0.0}, of_a_dot());
  TravelField field;
  field.search(grid, {1, 1});
  EXPECT_FALSE(field.reaches({1, 1}));
  EXPECT_FALSE(field.reaches({3, 1}));
  field.search(grid, {77, -3});
  EXPECT_FALSE(field.reaches({3, 1}));
}

TEST(TravelField, HasNoCostBehindAWall) {
  const CostGrid grid(tests::map_from({"......", "######", "......"}), {0.0, 0.0}, of_a_dot());
  TravelField field;
  field.search(grid, {0, 0});
  EXPECT_TRUE(field.reaches({5, 0}));
  EXPECT_FALSE(field.reaches({5, 2}));
  EXPECT_FALSE(field.reaches({6, 0}));
}

}  // namespace
}  // namespace echomap::exploration
