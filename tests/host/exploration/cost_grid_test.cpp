// SPDX-License-Identifier: MIT
#include "host/exploration/cost_grid.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/exploration/random_floor.hpp"

namespace echomap::exploration {
namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::RasterMap;

constexpr double kCellM = 0.05;

/// A floor with a wall around it, 30 x 20 cells, and a post in it.
RasterMap furnished_floor() {
  RasterMap map(30, 20, kCellM, {-0.5, -0.5});
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const bool wall = x == 0 || y == 0 || x == map.columns() - 1 || y == map.rows() - 1;
      map.set({x, y}, wall ? CellState::kOccupied : CellState::kFree);
    }
  }
  map.set({18, 9}, CellState::kOccupied);
  return map;
}

/// Centre to centre, by looking at all cells.
double to_nearest_obstacle_m(const RasterMap& map, CellIndex cell) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) != CellState::kFree) {
        nearest_m = std::min(nearest_m, kCellM * std::hypot(x - cell.x, y - cell.y));
      }
    }
  }
  return nearest_m;
}

/// Parameters that leave the floor under the robot as it is.
CostGridParams without_standing() {
  CostGridParams params;
  params.standing_m = 0.0;
  return params;
}

TEST(CostGrid, IsClosedAsFarAsItGoesWhereNobodyKnowsWhereSomebodyStands) {
  CostGrid grid(furnished_floor(), {0.0, 0.0}, without_standing());
  grid.close_around({0.0, 0.0}, std::numeric_limits<double>::infinity());
  for (int y = 0; y < grid.rows(); ++y) {
    for (int x = 0; x < grid.columns(); ++x) {
      EXPECT_FALSE(grid.is_open({x, y}));
    }
  }
}

TEST(CostGrid, IsDearAndNotClosedWhereSomebodyStands) {
  CostGrid grid(furnished_floor(), {0.0, 0.0}, without_standing());
  const CostGrid before = grid;
  grid.raise_around({0.0, 0.0}, 0.2, 10.0);
  EXPECT_EQ(grid.costs()[grid.index(grid.cell_at({0.0, 0.0}))], 10 * CostGrid::kPlain);
  for (int y = 0; y < grid.rows(); ++y) {
    for (int x = 0; x < grid.columns(); ++x) {
      EXPECT_EQ(grid.is_open({x, y}), before.is_open({x, y}));
      if (grid.center_m({x, y}).norm() > 0.2) {
        EXPECT_EQ(grid.costs()[grid.index({x, y})], before.costs()[before.index({x, y})]);
      }
    }
  }
}

TEST(CostGrid, ClosesWhatTheHullWouldReachAndNothingElse) {
  const RasterMap map = furnished_floor();
  const CostGridParams params = without_standing();
  const CostGrid grid(map, {0.0, 0.0}, params);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const double away_m = to_nearest_obstacle_m(map, {x, y});
      EXPECT_EQ(grid.is_open({x, y}), away_m > params.robot_radius_m + params.clearance_m - 1e-6)
          << x << ' ' << y << ": " << away_m;
    }
  }
}

TEST(CostGrid, FloorIsTheDearerTheNearerItIsToAnObstacleAndPlainBeyond) {
  const RasterMap map = furnished_floor();
  const CostGridParams params = without_standing();
  const CostGrid grid(map, {0.0, 0.0}, params);
  int wary = 0;
  for (int x = 0; x < map.columns() - 1; ++x) {
    for (int y = 0; y < map.rows(); ++y) {
      if (!grid.is_open({x, y}) || !grid.is_open({x + 1, y})) {
        continue;
      }
      const double here_m = to_nearest_obstacle_m(map, {x, y});
      const double next_m = to_nearest_obstacle_m(map, {x + 1, y});
      const int here = grid.costs()[grid.index({x, y})];
      const int next = grid.costs()[grid.index({x + 1, y})];
      EXPECT_TRUE(here_m == next_m || (here_m < next_m ? here >= next : here <= next));
      const double plain_m = params.robot_radius_m + params.clearance_m + params.wary_m;
      EXPECT_EQ(here == CostGrid::kPlain, here_m > plain_m - 0.005) << here_m;
      wary += here > CostGrid::kPlain ? 1 : 0;
    }
  }
  EXPECT_GT(wary, 50);
}

TEST(CostGrid, UnknownFloorIsClosedAndTheFloorBesideItDear) {
  auto map = furnished_floor();
  for (int x = 8; x < 16; ++x) {
    for (int y = 5; y < 15; ++y) {
      map.set({x, y}, CellState::kUnknown);
    }
  }
  const CostGridParams params = without_standing();
  const CostGrid grid(map, {0.0, 0.0}, params);
  EXPECT_FALSE(grid.is_open({12, 9}));
  ASSERT_TRUE(grid.is_open({7, 10})) << "only the hull reaches over the unknown";
  EXPECT_EQ(grid.costs()[grid.index({7, 10})], CostGrid::kPlain * params.dearest);
}

TEST(CostGrid, AnUnknownStripBetweenFreeCellsIsAFordButNotOneAlongAWall) {
  auto map = furnished_floor();
  for (int y = 1; y < 19; ++y) {
    for (int x = 10; x < 13; ++x) {
      map.set({x, y}, CellState::kUnknown);
    }
    map.set({27, y}, CellState::kUnknown);
    map.set({28, y}, CellState::kUnknown);
  }
  const CostGrid grid(map, {0.0, 0.0}, of_a_dot());
  EXPECT_TRUE(grid.is_open({11, 10}));
  EXPECT_FALSE(grid.is_open({28, 10}));
}

TEST(CostGrid, TheRobotStandsOnOpenFloorEvenWhereTheMapHasAWall) {
  const RasterMap map = furnished_floor();
  const Eigen::Vector2d beside_the_wall_m(-0.40, 0.0);
  const CostGrid grid(map, beside_the_wall_m, {});
  EXPECT_TRUE(grid.is_open(grid.cell_at(beside_the_wall_m)));
  EXPECT_FALSE(grid.is_open({0, 10}));
}

TEST(CostGrid, NothingOutsideOfTheMapIsOpen) {
  const CostGrid grid(furnished_floor(), {0.0, 0.0}, {});
  EXPECT_FALSE(grid.is_open({-1, 5}));
  EXPECT_FALSE(grid.is_open({5, 20}));
  EXPECT_FALSE(grid.is_open(grid.cell_at({1e9, -1e9})));
}

TEST(CostGrid, AMapOfNothingIsClosed) {
  const CostGrid grid(RasterMap(3, 3, kCellM, {0.0, 0.0}), {9.0, 9.0}, {});
  for (int i = 0; i < 9; ++i) {
    EXPECT_FALSE(grid.is_open({i % 3, i / 3}));
  }
}

TEST(CostGrid, RejectsParametersWithoutSense) {
  const RasterMap map = furnished_floor();
  CostGridParams params;
  params.robot_radius_m = 0.0;
  EXPECT_THROW(CostGrid(map, {0.0, 0.0}, params), std::invalid_argument);
  params = {};
  params.dearest = 40.0;
  EXPECT_THROW(CostGrid(map, {0.0, 0.0}, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
