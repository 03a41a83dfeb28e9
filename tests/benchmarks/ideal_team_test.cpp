// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ideal_team.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

using mapping::CellState;
using mapping::RasterMap;

/// A corridor along x, 1 m wide, in cells of 5 cm.
RasterMap corridor(double length_m) {
  RasterMap floor(static_cast<int>(length_m / 0.05), 20, 0.05, {0.0, 0.0});
  for (int y = 0; y < floor.rows(); ++y) {
    for (int x = 0; x < floor.columns(); ++x) {
      floor.set({x, y}, CellState::kFree);
    }
  }
  return floor;
}

/// A wall across it, with a gap of that width.
RasterMap with_wall(RasterMap floor, double at_m, double gap_m) {
  const int column = static_cast<int>(at_m / 0.05);
  for (int y = static_cast<int>(gap_m / 0.05); y < floor.rows(); ++y) {
    floor.set({column, y}, CellState::kOccupied);
  }
  return floor;
}

TEST(IdealTeam, WhatItSeesFromItsStartTakesOneStop) {
  EXPECT_EQ(ideal_team_s(corridor(1.4), {{0.7, 0.5}}), 5.0);
}

TEST(IdealTeam, OneAloneGoesAndStops) {
  // The first look reaches to 2 m, and what is left of 6 m takes two more at the least.
  const auto alone_s = ideal_team_s(corridor(6.0), {{0.5, 0.5}});
  ASSERT_TRUE(alone_s);
  EXPECT_GE(*alone_s, 3 * 5.0 + 2.4 / 0.2);
  EXPECT_LE(*alone_s, 5 * 5.0 + 5.0 / 0.2);
}

TEST(IdealTeam, TwoFromTheMiddleOfACorridorTakeItsTwoHalves) {
  IdealTeamParams shares;
  shares.shared_m2 = 0.0;
  const auto alone_s = ideal_team_s(corridor(12.0), {{5.8, 0.5}}, shares);
  const auto two_s = ideal_team_s(corridor(12.0), {{5.8, 0.5}, {6.2, 0.5}}, shares);
  ASSERT_TRUE(alone_s && two_s);
  EXPECT_LT(*two_s / *alone_s, 0.55);
}

TEST(IdealTeam, RobotsThatHaveNotSeenTheSameDoNotShare) {
  IdealTeamParams never;
  never.shared_m2 = 1000.0;
  const auto alone_s = ideal_team_s(corridor(12.0), {{0.5, 0.5}}, never);
  EXPECT_EQ(ideal_team_s(corridor(12.0), {{0.5, 0.5}, {11.5, 0.5}}, never), alone_s)
      << "the corridor looks alike from both of its ends";
  IdealTeamParams late;
  late.shared_m2 = 1.0;
  const auto late_s = ideal_team_s(corridor(12.0), {{0.5, 0.5}, {11.5, 0.5}}, late);
  IdealTeamParams always;
  always.shared_m2 = 0.0;
  const auto always_s = ideal_team_s(corridor(12.0), {{0.5, 0.5}, {11.5, 0.5}}, always);
  ASSERT_TRUE(alone_s && late_s && always_s);
  EXPECT_LT(*always_s, *late_s) << "nine tenths are there before anything was seen by both";
  EXPECT_LT(*late_s, *alone_s);
}

TEST(IdealTeam, DoesNotSeeThroughWallsNorPassGapsThatAreTooNarrow) {
  const auto open_s = ideal_team_s(corridor(2.6), {{1.0, 0.5}});
  const auto wall_s = ideal_team_s(with_wall(corridor(2.6), 1.3, 0.3), {{1.0, 0.5}});
  ASSERT_TRUE(open_s && wall_s);
  EXPECT_GT(*wall_s, *open_s);
  EXPECT_EQ(ideal_team_s(with_wall(corridor(2.6), 1.3, 0.1), {{0.7, 0.5}}), 5.0)
      << "behind it nothing is in reach";
}

TEST(IdealTeam, RefusesATeamOfNobody) {
  EXPECT_THROW(ideal_team_s(corridor(1.0), {}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::bench
