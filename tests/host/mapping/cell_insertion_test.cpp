// SPDX-License-Identifier: MIT
#include "host/mapping/cell_insertion.hpp"

#include <random>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using geometry::CellIndex;

/// Much more than the clamp, and what rounds to nothing, among others.
int evidence_of(CellIndex cell) {
  std::seed_seq seed{cell.x, cell.y};
  std::mt19937 random(seed);
  const int kind = static_cast<int>(random() % 4);
  return kind == 0 ? 0 : (kind == 1 ? 2 : static_cast<int>(random() % 4000) - 2000);
}

TEST(InsertCells, DoesToEveryCellWhatAddDoesToOne) {
  const CellBounds bounds{{-70, -130}, {65, 3}};
  OccupancyGrid at_once;
  OccupancyGrid one_by_one;
  for (int round = 0; round < 2; ++round) {
    insert_cells(bounds, evidence_of, at_once);
    for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
      for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
        one_by_one.add({x, y}, evidence_of({x, y}));
      }
    }
  }
  EXPECT_EQ(at_once.bounds(), one_by_one.bounds());
  for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      ASSERT_EQ(at_once.centilogits({x, y}), one_by_one.centilogits({x, y})) << x << ' ' << y;
    }
  }
}

TEST(InsertCells, TouchesNothingWithoutEvidence) {
  OccupancyGrid grid;
  insert_cells(
      {{-5, -5}, {5, 5}}, [](CellIndex) { return 2; }, grid);
  insert_cells(
      {}, [](CellIndex) { return -200; }, grid);
  EXPECT_TRUE(grid.bounds().empty());
  EXPECT_EQ(grid.find_tile({0, 0}), nullptr);
}

}  // namespace
}  // namespace echomap::mapping
