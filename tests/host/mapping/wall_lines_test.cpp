// SPDX-License-Identifier: MIT
#include "host/mapping/wall_lines.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

TEST(DirectedLine, HasTheFloorToItsLeft) {
  const DirectedLine line{{1, 2}, {0, 1}};
  EXPECT_DOUBLE_EQ(line.left_m({0.5, 7}), 0.5);
  EXPECT_EQ(line.foot_of({0.5, 7}), Eigen::Vector2d(1, 7));
}

TEST(DirectedLine, CrossesEveryLineThatIsNotParallel) {
  const DirectedLine east{{0, 1}, {1, 0}};
  EXPECT_EQ(east.crossing({{3, 0}, {0, 1}}).value(), Eigen::Vector2d(3, 1));
  EXPECT_FALSE(east.crossing({{0, 2}, {-1, 0}}));
}

TEST(MergedWalls, PutsPiecesOfOneWallTogetherByTheirLengths) {
  const auto walls = merged_walls({{{0, 0}, {1, 0}}, {{2, 0.02}, {5, 0.02}}}, 0.05);
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_EQ(walls[0].pieces.size(), 2U);
  EXPECT_NEAR(walls[0].line.left_m({3.5, 0.02}), 0.0, 0.003);
  EXPECT_GT(walls[0].line.direction.x(), 0.99);
}

TEST(MergedWalls, KeepsBothSidesOfAThinWallApart) {
  EXPECT_EQ(merged_walls({{{0, 0}, {1, 0}}, {{1, 0.03}, {0, 0.03}}}, 0.05).size(), 2U);
  EXPECT_EQ(merged_walls({{{0, 0}, {1, 0}}, {{2, 0.2}, {3, 0.2}}}, 0.05).size(), 2U);
}

TEST(MergedWalls, PassesOverPiecesWithoutALength) {
  EXPECT_TRUE(merged_walls({{{1, 1}, {1, 1}}}, 0.05).empty());
}

}  // namespace
}  // namespace echomap::mapping
