// SPDX-License-Identifier: MIT
#include "host/slam/scan_map.hpp"

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

mapping::CellState state_at(const mapping::OccupancyGrid& grid, double x_m, double y_m) {
  return grid.state(grid.cell_at({x_m, y_m}));
}

TEST(ScanMap, KnowsNothingWithoutScans) { EXPECT_TRUE(map_of_scans({}, {}, {}).bounds().empty()); }

TEST(ScanMap, DrawsThinBeamsFromWhereTheRobotWas) {
  const geometry::Pose2 T_map_robot(1.02, 0.02, 0.0);
  const sensors::RangeScan scan{{}, {}, {{0.0, 2.0}}, 0.0, 10.0};
  const auto grid = map_of_scans(std::vector(6, T_map_robot), std::vector(6, scan), {});
  EXPECT_EQ(state_at(grid, 2.02, 0.02), mapping::CellState::kFree);
  EXPECT_EQ(state_at(grid, 3.02, 0.02), mapping::CellState::kOccupied);
  EXPECT_EQ(state_at(grid, 0.52, 0.02), mapping::CellState::kUnknown);
}

TEST(ScanMap, DoesNotDrawTheAxisOfALoneConeAsAWall) {
  const sensors::RangeScan scan{{}, {}, {{0.0, 2.0}}, 0.5, 4.0};
  const auto grid = map_of_scans({geometry::Pose2(1.0, 0.0, 0.0)}, {scan}, {});
  EXPECT_EQ(state_at(grid, 1.5, 0.0), mapping::CellState::kFree);
  EXPECT_NE(state_at(grid, 3.0, 0.0), mapping::CellState::kOccupied);
}

}  // namespace
}  // namespace echomap::slam
