// SPDX-License-Identifier: MIT
#include "host/mapping/raster_map.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using tests::drawing_of;
using tests::DrawnMap;

TEST(RasterMap, IsUnknownAtFirstAndOutside) {
  const RasterMap map(3, 2, 0.05, {0.0, 0.0});
  EXPECT_EQ(map.state({1, 1}), CellState::kUnknown);
  EXPECT_EQ(map.state({-1, 0}), CellState::kUnknown);
  EXPECT_EQ(map.state({3, 0}), CellState::kUnknown);
  EXPECT_FALSE(map.contains({0, 2}));
}

TEST(RasterMap, FindsTheCellOfACentre) {
  const RasterMap map(20, 30, 0.05, {-0.3, 1.7});
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 20; ++x) {
      EXPECT_EQ(map.cell_at(map.center_m({x, y})), (geometry::CellIndex{x, y}));
    }
  }
}

TEST(RasterMap, CountsCellsAsFarAsTheyCanBeCounted) {
  const RasterMap map(1, 1, 0.05, {0.0, 0.0});
  EXPECT_EQ(map.cell_at({1e300, -1e300}), (geometry::CellIndex{1 << 30, -(1 << 30)}));
}

TEST(RasterMap, RefusesASizeOfNothing) {
  EXPECT_THROW(RasterMap(0, 1, 0.05, {0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(RasterMap(1, 1, 0.0, {0.0, 0.0}), std::invalid_argument);
}

TEST(RasterMap, IsCutOutWithItsPlace) {
  const RasterMap map = tests::map_from({"##.", "#..", " ##"}, 0.5, {1.0, 2.0});
  const RasterMap part = cut_out(map, {{1, 1}, {3, 2}});
  EXPECT_EQ(drawing_of(part), (DrawnMap{"#. ", ".. "}));
  EXPECT_EQ(part.origin_m(), Eigen::Vector2d(1.5, 2.5));
  EXPECT_EQ(drawing_of(cut_out(map, {{-1, -1}, {0, 0}})), (DrawnMap{"  ", "  "}));
  EXPECT_THROW(cut_out(map, CellBounds()), std::invalid_argument);
}

TEST(RasterMap, TellsTheCentresOfTheCellsOfAState) {
  const RasterMap map = tests::map_from({"# .", ".#."}, 0.5, {1.0, 2.0});
  EXPECT_EQ(centers_m(map, CellState::kOccupied),
            (std::vector<Eigen::Vector2d>{{1.75, 2.25}, {1.25, 2.75}}));
  EXPECT_EQ(centers_m(map, CellState::kUnknown), (std::vector<Eigen::Vector2d>{{1.75, 2.75}}));
}

TEST(RasterMap, HasObstaclesInPlaceOfUnknownCells) {
  const RasterMap map = tests::map_from({"# .", ".#."}, 0.5, {1.0, 2.0});
  EXPECT_EQ(drawing_of(with_unknown_occupied(map)), (DrawnMap{"##.", ".#."}));
}

TEST(Rasterize, DrawsTheGridWithAMarginOfUnknownCells) {
  OccupancyGrid grid;
  grid.add({-2, 4}, -200);
  grid.add({-1, 4}, 200);
  grid.add({-2, 5}, 10);
  const RasterMap map = rasterize(grid);
  EXPECT_EQ(drawing_of(map), (DrawnMap{"    ", "    ", " .# ", "    "}));
  EXPECT_NEAR((map.origin_m() - Eigen::Vector2d(-0.15, 0.15)).norm(), 0.0, 1e-12);
}

TEST(Rasterize, MakesOneUnknownCellOfAnUntouchedGrid) {
  EXPECT_EQ(drawing_of(rasterize(OccupancyGrid())), DrawnMap{" "});
}

}  // namespace
}  // namespace echomap::mapping
