// SPDX-License-Identifier: MIT
#include "host/exploration/viewpoint_choice.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/exploration/random_floor.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;
using geometry::radians;
using mapping::CellState;
using mapping::RasterMap;

/// A corridor of 5 m x 1 m along x, walled to its sides. `west` and `east` say whether its ends are
/// walled, too; else the floor beyond is unknown. The robot's start is its middle.
RasterMap corridor(bool west, bool east) {
  RasterMap map(140, 60, 0.05, {-3.5, -1.5});
  for (int x = 20; x < 120; ++x) {
    for (int y = 19; y <= 40; ++y) {
      map.set({x, y}, y == 19 || y == 40 ? CellState::kOccupied : CellState::kFree);
    }
  }
  for (int y = 19; y <= 40; ++y) {
    map.set({20, y}, west ? CellState::kOccupied : map.state({20, y}));
    map.set({119, y}, east ? CellState::kOccupied : map.state({119, y}));
  }
  return map;
}

std::optional<Viewpoint> choice(const RasterMap& map,
                                const Pose2& T_map_robot,
                                const std::vector<PastView>& past = {},
                                double min_gain_m2 = 0.1) {
  const CostGrid grid(map, T_map_robot.position_m(), {});
  TravelField travel;
  travel.search(grid, grid.cell_at(T_map_robot.position_m()));
  const ViewGain gain(map, past, {}, {});
  ViewpointParams params;
  params.min_gain_m2 = min_gain_m2;
  params.widths_rad = {radians(180.0), radians(360.0)};
  const auto weighed = weigh_viewpoints(grid,
                                        travel,
                                        find_frontiers(map, grid.cell_at(T_map_robot.position_m())),
                                        gain,
                                        T_map_robot,
                                        params);
  return weighed.empty() ? std::nullopt : std::optional(weighed.front());
}

TEST(ViewpointChoice, GoesToTheOpenEndAndLooksOutOfIt) {
  const auto east = choice(corridor(true, false), {});
  ASSERT_TRUE(east);
  EXPECT_GT(east->at_m.x(), 0.9);
  EXPECT_LT(std::abs(east->view.middle_rad), 0.5 * east->view.width_rad);
  const auto west = choice(corridor(false, true), {});
  ASSERT_TRUE(west);
  EXPECT_LT(west->at_m.x(), -0.9);
  EXPECT_GT(std::abs(west->view.middle_rad), radians(180.0) - 0.5 * west->view.width_rad);
}

TEST(ViewpointChoice, TakesTheNearerOfTwoOpenEnds) {
  const auto chosen = choice(corridor(false, false), Pose2(-1.0, 0.0, 0.0));
  ASSERT_TRUE(chosen);
  EXPECT_LT(chosen->at_m.x(), 0.0);
}

TEST(ViewpointChoice, TurnsToTheOtherEndOnceThisOneHasBeenLookedOutOfInVain) {
  const PastView out_of_the_west{{-2.3, 0.0}, radians(180.0), radians(90.0)};
  const std::vector<PastView> past(3, out_of_the_west);
  const auto chosen = choice(corridor(false, false), Pose2(-1.0, 0.0, 0.0), past);
  ASSERT_TRUE(chosen);
  EXPECT_GT(chosen->at_m.x(), 0.0);
}

TEST(ViewpointChoice, FindsNothingWhereAllIsClosedOrNotWorthIt) {
  EXPECT_FALSE(choice(corridor(true, true), {}));
  EXPECT_FALSE(choice(corridor(true, false), {}, {}, 50.0));
}

TEST(ViewpointChoice, ChoosesOnlyWhatTheRobotCanReach) {
  RasterMap map = corridor(true, false);
  for (int y = 19; y <= 40; ++y) {
    map.set({80, y}, CellState::kOccupied);
  }
  EXPECT_FALSE(choice(map, {}));
}

TEST(ViewpointChoice, OfUnknownFloorAllRoundItLooksAllRoundFromWhereItStands) {
  RasterMap map(60, 60, 0.05, {-1.5, -1.5});
  for (int y = 28; y < 33; ++y) {
    for (int x = 28; x < 33; ++x) {
      map.set({x, y}, CellState::kFree);
    }
  }
  const auto chosen = choice(map, {});
  ASSERT_TRUE(chosen);
  EXPECT_LT(chosen->at_m.norm(), 0.2);
  EXPECT_GT(chosen->view.width_rad, radians(300.0));
}

}  // namespace
}  // namespace echomap::exploration
