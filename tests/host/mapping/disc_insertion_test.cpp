// SPDX-License-Identifier: MIT
#include "host/mapping/disc_insertion.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using ::testing::ElementsAre;

TEST(DiscInsertion, TakesTheCellsThatLieWholeInTheDisc) {
  OccupancyGrid grid;
  insert_disc({0.125, 0.125}, 0.13, -200, grid);
  EXPECT_THAT(
      tests::drawing_of(rasterize(grid)),
      ElementsAre("       ", "   .   ", "  ...  ", " ..... ", "  ...  ", "   .   ", "       "));
  EXPECT_EQ(grid.bounds().min, (geometry::CellIndex{0, 0}));
  EXPECT_EQ(grid.centilogits({2, 2}), -200);
}

TEST(DiscInsertion, ADiscThatHoldsNoWholeCellSaysNothing) {
  OccupancyGrid grid;
  insert_disc({0.125, 0.125}, 0.03, -200, grid);
  EXPECT_TRUE(grid.bounds().empty());
}

TEST(DiscInsertion, WhatIsNotFiniteSaysNothing) {
  OccupancyGrid grid;
  insert_disc({std::numeric_limits<double>::quiet_NaN(), 0.0}, 0.2, -200, grid);
  insert_disc({0.0, 0.0}, std::numeric_limits<double>::infinity(), -200, grid);
  EXPECT_TRUE(grid.bounds().empty());
}

}  // namespace
}  // namespace echomap::mapping
