// SPDX-License-Identifier: MIT
#include "host/mapping/bump_insertion.hpp"

#include <numbers>

#include <gmock/gmock.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

using ::testing::ElementsAre;

const geometry::Segment kLine{{0.22, -0.12}, {0.22, 0.12}};

TEST(BumpInsertion, MarksTheLineBeforeTheRobotAndNothingElse) {
  OccupancyGrid grid;
  insert_bump({0.0, 0.025, 0.0}, kLine, {}, grid);
  EXPECT_THAT(tests::drawing_of(rasterize(grid)),
              ElementsAre("   ", " # ", " # ", " # ", " # ", " # ", "   "));
  EXPECT_EQ(grid.bounds().min, (geometry::CellIndex{4, -2}));
}

TEST(BumpInsertion, TurnsWithTheRobot) {
  OccupancyGrid grid;
  insert_bump({0.025, 0.0, std::numbers::pi / 2.0}, kLine, {}, grid);
  EXPECT_THAT(tests::drawing_of(rasterize(grid)), ElementsAre("       ", " ##### ", "       "));
  EXPECT_EQ(grid.bounds().min, (geometry::CellIndex{-2, 4}));
}

TEST(BumpInsertion, GivesEveryCellItsEvidenceOnce) {
  OccupancyGrid grid;
  BumpParams params;
  params.hit_centilogits = 100;
  insert_bump({0.0, 0.0, 0.7}, kLine, params, grid);
  int touched = 0;
  for (int y = grid.bounds().min.y; y <= grid.bounds().max.y; ++y) {
    for (int x = grid.bounds().min.x; x <= grid.bounds().max.x; ++x) {
      const auto evidence = grid.centilogits({x, y});
      EXPECT_EQ(evidence.value_or(100), 100) << x << " " << y;
      touched += evidence ? 1 : 0;
    }
  }
  EXPECT_GE(touched, 5);
}

TEST(BumpInsertion, APointIsOneCell) {
  OccupancyGrid grid;
  insert_bump({}, {{0.22, 0.0}, {0.22, 0.0}}, {}, grid);
  EXPECT_EQ(grid.bounds().columns() * grid.bounds().rows(), 1);
  EXPECT_EQ(grid.state({4, 0}), CellState::kOccupied);
}

}  // namespace
}  // namespace echomap::mapping
