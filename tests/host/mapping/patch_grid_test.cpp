// SPDX-License-Identifier: MIT
#include "host/mapping/patch_grid.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using geometry::Pose2;

float at(const PatchGrid& grid, double x_m, double y_m) {
  const CellField& field = grid.confidence();
  return field[field.index(field.cell_at({x_m, y_m}))];
}

/// '#' for 1 and more, 'o' for any other confidence; the top row first.
std::string drawn(const PatchGrid& grid, const CellBounds& cells) {
  const CellField& field = grid.confidence();
  std::string text;
  for (int y = cells.max.y; y >= cells.min.y; --y) {
    for (int x = cells.min.x; x <= cells.max.x; ++x) {
      const float value = field[field.index({x, y})];
      text += value >= 1.0F ? '#' : (value > 0.0F ? 'o' : '.');
    }
    text += '\n';
  }
  return text;
}

TEST(PatchGrid, HasThePapersCells) {
  const PatchGrid grid;
  EXPECT_EQ(grid.confidence().bounds().columns(), 56);
  EXPECT_EQ(grid.confidence().bounds().rows(), 44);
  EXPECT_EQ(grid.confidence().resolution_m(), 0.05);
  EXPECT_EQ(grid.sum_ahead({}, 0.0, 3.0, 4.4), 0.0);
}

TEST(PatchGrid, HasWallsThatAreKnownAsOnes) {
  PatchGrid grid;
  grid.mark_wall({{0.125, 0.125}, {0.275, 0.125}});
  EXPECT_EQ(drawn(grid, {{0, 0}, {7, 4}}),
            "........\n"
            "........\n"
            "..####..\n"
            "........\n"
            "........\n");
}

TEST(PatchGrid, AddsAPatchWhereTheEchoWouldLieOnTheAxis) {
  PatchGrid grid;
  const Pose2 T_grid_sonar(0.225, 0.225, 0.5 * std::numbers::pi);
  grid.add_echo(T_grid_sonar, 0.4);
  EXPECT_FLOAT_EQ(at(grid, 0.225, 0.625), 1.0F);
  EXPECT_NEAR(at(grid, 0.275, 0.625), std::exp(-0.5), 1e-6);
  EXPECT_EQ(drawn(grid, {{1, 9}, {7, 15}}),
            ".......\n"
            "..ooo..\n"
            ".ooooo.\n"
            ".oo#oo.\n"
            ".ooooo.\n"
            "..ooo..\n"
            ".......\n");
  grid.add_echo(T_grid_sonar, 0.4);
  EXPECT_FLOAT_EQ(at(grid, 0.225, 0.625), 2.0F);
}

TEST(PatchGrid, LeavesOutWhatFallsBesideIt) {
  PatchGrid grid;
  grid.add_echo({0.0, 0.0, std::numbers::pi}, 5.0);
  grid.add_echo({0.0, 0.0, std::numbers::pi}, 0.05);
  EXPECT_EQ(drawn(grid, {{0, 0}, {3, 3}}),
            "....\n"
            "....\n"
            "o...\n"
            "o...\n");
}

TEST(PatchGrid, SumsUpARectangleAhead) {
  PatchGrid grid;
  for (const double y_m : {1.025, 1.075, 1.125, 1.225}) {
    grid.mark_wall({{1.525, y_m}, {1.525, y_m}});
  }
  const Pose2 eastward(1.0, 1.075, 0.0);
  EXPECT_EQ(grid.sum_ahead(eastward, 0.1, 0.6, 0.2), 3.0);
  EXPECT_EQ(grid.sum_ahead(eastward, 0.1, 0.6, 0.32), 4.0);
  EXPECT_EQ(grid.sum_ahead(eastward, 0.1, 0.5, 0.2), 0.0);
  EXPECT_EQ(grid.sum_ahead(eastward, 0.6, 0.9, 0.2), 0.0);
  EXPECT_EQ(grid.sum_ahead({1.0, 1.075, std::numbers::pi}, 0.1, 0.6, 0.2), 0.0);
  EXPECT_EQ(grid.sum_ahead({1.525, 0.5, 0.5 * std::numbers::pi}, 0.1, 0.6, 0.2), 2.0);
}

TEST(PatchGrid, AnEchoTakesAwayEchoesThatLieNearerInItsCone) {
  PatchGrid grid;
  const Pose2 sonar(0.225, 1.125, 0.0);
  grid.add_echo(sonar, 0.5);                                   // before the wall
  grid.add_echo({0.225, 1.125, 0.5 * std::numbers::pi}, 0.5);  // aside
  grid.clear_cone(sonar, 0.8, 0.28);
  EXPECT_EQ(at(grid, 0.725, 1.125), 0.0F);
  EXPECT_EQ(at(grid, 0.225, 1.625), 1.0F);
  grid.add_echo(sonar, 1.0);
  grid.clear_cone(sonar, 0.8, 0.28);
  EXPECT_EQ(at(grid, 1.225, 1.125), 1.0F);
}

TEST(PatchGrid, NoEchoTakesAwayKnownWallsAndBumps) {
  PatchGrid grid;
  const Pose2 sonar(0.225, 1.125, 0.0);
  grid.mark_wall({{0.525, 1.125}, {0.525, 1.125}});
  grid.add_bump({{0.825, 1.025}, {0.825, 1.225}});
  EXPECT_GT(at(grid, 0.825, 1.225), 1.0F);
  const float bumped = at(grid, 0.825, 1.125);
  EXPECT_GT(bumped, 2.0F);
  grid.add_echo(sonar, 0.6);
  grid.clear_cone(sonar, 1.5, 0.28);
  EXPECT_FLOAT_EQ(at(grid, 0.525, 1.125), 1.0F);
  EXPECT_EQ(at(grid, 0.825, 1.125), bumped);
}

TEST(PatchGrid, RefusesParametersWithoutSense) {
  PatchGridParams params;
  params.cell_m = 0.0;
  EXPECT_THROW(PatchGrid{params}, std::invalid_argument);
  params = {};
  params.cells = {};
  EXPECT_THROW(PatchGrid{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
