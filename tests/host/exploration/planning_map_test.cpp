// SPDX-License-Identifier: MIT
#include "host/exploration/planning_map.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/exploration/travel_field.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using mapping::CellState;
using mapping::OccupancyGrid;
using mapping::RasterMap;

TEST(PlanningMap, HasUnknownFloorAroundItAndFloorUnderTheRobot) {
  OccupancyGrid grid;
  grid.add({0, 0}, 300);
  grid.add({40, 0}, -300);
  const auto snapshot = tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, {1.0, 0.0, 0.0})});
  const RasterMap map = planning_map(snapshot, 0.5, 0.1);
  EXPECT_EQ(map.state(map.cell_at({0.025, 0.025})), CellState::kOccupied);
  EXPECT_EQ(map.state(map.cell_at({1.025, 0.025})), CellState::kFree) << "where it stands";
  EXPECT_EQ(map.state(map.cell_at({1.225, 0.025})), CellState::kUnknown);
  EXPECT_TRUE(map.contains(map.cell_at({-0.45, 0.45})));
  EXPECT_EQ(map.state(map.cell_at({-0.45, 0.45})), CellState::kUnknown);
}

TEST(PlanningMap, HasFloorWhereTheRobotHasDrivenThroughAWall) {
  OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 20; ++x) {
      grid.add({x, y}, x == 0 ? 300 : -300);
    }
  }
  std::vector<pipeline::StampedPose> way;
  for (int i = 0; i <= 24; ++i) {
    way.push_back(tests::pose_at(i, {-0.6 + 0.05 * i, 0.025, 0.0}));
  }
  const auto snapshot = tests::snapshot_of(std::move(grid), way);
  const RasterMap map = planning_map(snapshot, 0.1, 0.09);
  EXPECT_EQ(map.state(map.cell_at({0.025, 0.025})), CellState::kFree);
  EXPECT_EQ(map.state(map.cell_at({0.025, 0.225})), CellState::kOccupied) << "beside its way";
  const CostGrid costs = costs_on(map, snapshot, {});
  TravelField travel;
  travel.search(costs, costs.cell_at(way.back().T_map_robot.position_m()));
  EXPECT_TRUE(travel.reaches(costs.cell_at(way.front().T_map_robot.position_m())));
}

TEST(CostsOn, AreOpenWhereTheRobotHasBeen) {
  OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 20; ++x) {
      grid.add({x, y}, x == 0 && y != 0 ? 300 : -300);  // A wall with a gap of one cell.
    }
  }
  const std::vector<pipeline::StampedPose> way{tests::pose_at(1.0, {0.025, 0.025, 0.0}),
                                               tests::pose_at(2.0, {0.6, 0.025, 0.0})};
  const auto snapshot = tests::snapshot_of(std::move(grid), way);
  const RasterMap map = planning_map(snapshot, 0.1, 0.09);
  const CostGrid costs = costs_on(map, snapshot, {});
  EXPECT_TRUE(costs.is_open(costs.cell_at({0.025, 0.025})));
  EXPECT_FALSE(costs.is_open(costs.cell_at({0.025, 0.125}))) << "a wall";
  EXPECT_FALSE(costs.is_open(costs.cell_at({0.125, -0.525}))) << "beside it";
}

TEST(DrawDisc, ChangesOnlyWhatIsToBeChanged) {
  RasterMap map(20, 20, 0.05, {0.0, 0.0});
  map.set({10, 10}, CellState::kOccupied);
  map.set({11, 10}, CellState::kFree);
  draw_disc(map, {0.525, 0.525}, 0.12, {CellState::kUnknown, CellState::kFree}, CellState::kFree);
  EXPECT_EQ(map.state({10, 10}), CellState::kOccupied);
  EXPECT_EQ(map.state({11, 10}), CellState::kFree);
  EXPECT_EQ(map.state({12, 10}), CellState::kFree);
  EXPECT_EQ(map.state({13, 10}), CellState::kUnknown);
  EXPECT_NO_THROW(draw_disc(map, {0.0, 0.0}, 0.3, {CellState::kUnknown}, CellState::kOccupied));
}

}  // namespace
}  // namespace echomap::exploration
