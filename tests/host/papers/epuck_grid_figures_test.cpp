// SPDX-License-Identifier: MIT
#include "host/papers/epuck_grid_figures.hpp"

#include <gtest/gtest.h>

#include "host/papers/epuck_field.hpp"
#include "host/papers/room_floor.hpp"

namespace echomap::papers {
namespace {

using mapping::CellState;
using mapping::RasterMap;

constexpr double kCoarseCellM = 0.002;

/// The true floor, with each cell that is no floor and within 2 mm of a wall occupied.
RasterMap true_grid() {
  RasterMap map = floor_of(epuck_field(), kCoarseCellM, 0.02);
  for (geometry::CellIndex cell{0, 0}; cell.y < map.rows(); ++cell.y) {
    for (cell.x = 0; cell.x < map.columns(); ++cell.x) {
      if (map.state(cell) == CellState::kUnknown &&
          epuck_field().clearance_m(map.center_m(cell)) < kCoarseCellM) {
        map.set(cell, CellState::kOccupied);
      }
    }
  }
  return map;
}

TEST(EpuckGridFigures, OfATrueGridAreGood) {
  const EpuckGridFigures figures = epuck_grid_figures(true_grid());
  EXPECT_GT(figures.walls_found, 0.99);
  EXPECT_GE(figures.walls_about, figures.walls_found);
  EXPECT_DOUBLE_EQ(figures.occupied_near, 1.0);
  EXPECT_LT(figures.occupied_rms_m, kCoarseCellM);
  EXPECT_LT(figures.occupied_median_m, kCoarseCellM);
  EXPECT_GT(figures.free_found, 0.98);
  EXPECT_LT(figures.free_wrong, 0.01);
  EXPECT_LT(figures.deepest_m, kCoarseCellM);
  EXPECT_GT(figures.blocks_unknown, 0.9);
}

TEST(EpuckGridFigures, OfAnUnknownGridAreZero) {
  const EpuckGridFigures figures = epuck_grid_figures(RasterMap(400, 300, kCoarseCellM, {0, 0}));
  EXPECT_EQ(figures.walls_found, 0.0);
  EXPECT_EQ(figures.occupied_rms_m, 0.0);
  EXPECT_EQ(figures.free_found, 0.0);
  EXPECT_EQ(figures.free_wrong, 0.0);
  EXPECT_EQ(figures.blocks_unknown, 1.0);
}

TEST(EpuckGridFigures, SmallUnknownClotsBecomeFreeAndTheBlocksStay) {
  RasterMap map = true_grid();
  const geometry::CellIndex hole = map.cell_at({0.2, 0.3});
  map.set(hole, CellState::kUnknown);
  const RasterMap filled = without_small_clots(map);
  EXPECT_EQ(filled.state(hole), CellState::kFree);
  EXPECT_EQ(filled.state(filled.cell_at({0.5, 0.15})), CellState::kUnknown);
}

}  // namespace
}  // namespace echomap::papers
