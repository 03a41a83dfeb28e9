// SPDX-License-Identifier: MIT
#include "host/exploration/path_planner.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/exploration/travel_field.hpp"
#include "tests/host/exploration/random_floor.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::exploration {
namespace {

using geometry::CellIndex;

double price_of(const CostGrid& grid, const PlannedPath& path) {
  double cost_m = 0.0;
  for (std::size_t i = 1; i < path.points_m.size(); ++i) {
    const auto piece_m =
        line_cost_m(grid, grid.cell_at(path.points_m[i - 1]), grid.cell_at(path.points_m[i]));
    EXPECT_TRUE(piece_m.has_value()) << "piece " << i << " leads through a closed cell";
    cost_m += piece_m.value_or(1e9);
  }
  return cost_m;
}

TEST(PathPlanner, FindsAWayWhereThereIsOneAndNoDearerThanStepByStep) {
  PathPlanner planner;
  TravelField field;
  int ways = 0;
  int detours = 0;
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    const CostGrid grid(random_floor(40, 30, 0.002 * seed, seed), {0.0, 0.0}, of_a_dot());
    const CellIndex from{static_cast<std::int32_t>(seed % 40), 3};
    const CellIndex to{static_cast<std::int32_t>(7 * seed % 40), 27};
    field.search(grid, from);
    const auto path = planner.find(grid, from, to);
    ASSERT_EQ(path.has_value(), field.reaches(to)) << "seed " << seed;
    if (!path) {
      continue;
    }
    ++ways;
    EXPECT_EQ(path->points_m.front(), grid.center_m(from));
    EXPECT_EQ(path->points_m.back(), grid.center_m(to));
    EXPECT_NEAR(price_of(grid, *path), path->cost_m, 1e-4) << "seed " << seed;
    EXPECT_LT(path->cost_m, 1.05 * *field.cost_m(to) + 1e-3) << "seed " << seed;
    detours += path->cost_m > 1.011 * *field.cost_m(to) ? 1 : 0;
  }
  EXPECT_GT(ways, 100);
  // Theta* is not optimal; a step across is 1.4 in the field and 1.414 here.
  EXPECT_LT(detours, ways / 10);
}

TEST(PathPlanner, GoesStraightOverOpenFloorAtAnyAngle) {
  const CostGrid grid(random_floor(60, 40, 0.0, 1), {0.0, 0.0}, of_a_dot());
  PathPlanner planner;
  const auto path = planner.find(grid, {10, 10}, {47, 23});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points_m.size(), 2U);
  EXPECT_NEAR(path->cost_m, 0.05 * std::hypot(37, 13), 1e-4);
}

TEST(PathPlanner, KeepsAwayFromAWallThatItCouldGoAlong) {
  mapping::RasterMap map = random_floor(60, 40, 0.0, 1);
  for (int x = 0; x < 60; ++x) {
    map.set({x, 0}, mapping::CellState::kOccupied);
  }
  CostGridParams params;
  params.standing_m = 0.0;
  const CostGrid grid(map, {0.0, 0.0}, params);
  PathPlanner planner;
  const auto path = planner.find(grid, {2, 3}, {57, 3});
  ASSERT_TRUE(path);
  const auto straight_m = line_cost_m(grid, {2, 3}, {57, 3});
  EXPECT_LT(path->cost_m, 0.6 * *straight_m);
}

TEST(PathPlanner, FindsNoneToOrFromAClosedCellOrThroughAWall) {
  const CostGrid grid(tests::map_from({"......", "######", "......"}), {0.0, 0.0}, of_a_dot());
  PathPlanner planner;
  EXPECT_FALSE(planner.find(grid, {0, 0}, {0, 2}));
  EXPECT_FALSE(planner.find(grid, {0, 1}, {0, 0}));
  EXPECT_FALSE(planner.find(grid, {0, 0}, {3, 1}));
  EXPECT_FALSE(planner.find(grid, {0, 0}, {6, 0}));
  EXPECT_TRUE(planner.find(grid, {0, 0}, {5, 0})) << "after a search in vain";
}

TEST(PathPlanner, TheWayToWhereItStandsIsNone) {
  const CostGrid grid(random_floor(5, 5, 0.0, 1), {0.0, 0.0}, of_a_dot());
  PathPlanner planner;
  const auto path = planner.find(grid, {2, 2}, {2, 2});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points_m.size(), 1U);
  EXPECT_EQ(path->cost_m, 0.0);
}

TEST(LineCost, IsTheLengthTimesThePriceOfWhatItCrosses) {
  mapping::RasterMap map = random_floor(30, 30, 0.0, 1);
  const CostGrid open(map, {0.0, 0.0}, of_a_dot());
  EXPECT_NEAR(*line_cost_m(open, {3, 4}, {20, 9}), 0.05 * std::hypot(17, 5), 1e-9);
  EXPECT_NEAR(*line_cost_m(open, {20, 9}, {3, 4}), 0.05 * std::hypot(17, 5), 1e-9);
  map.set({10, 6}, mapping::CellState::kOccupied);
  const CostGrid grid(map, {0.0, 0.0}, of_a_dot());
  EXPECT_FALSE(line_cost_m(grid, {3, 4}, {20, 9}));
  EXPECT_FALSE(line_cost_m(grid, {20, 9}, {3, 4}));
}

}  // namespace
}  // namespace echomap::exploration
