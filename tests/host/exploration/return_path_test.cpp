// SPDX-License-Identifier: MIT
#include "host/exploration/return_path.hpp"

#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include "host/sensors/odometry.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

/// A floor from (-1, -1) to (3, 1), with a wall across it that leaves a gap above y = 0.5.
mapping::OccupancyGrid floor_with_a_wall(bool has_gap) {
  mapping::OccupancyGrid grid;
  for (int y = -20; y < 20; ++y) {
    for (int x = -20; x < 60; ++x) {
      const bool wall = x == 20 && (y < 10 || !has_gap);
      grid.add({x, y}, wall ? 400 : -400);
    }
  }
  return grid;
}

/// Where a robot ends that does as it is told.
geometry::Pose2 end_of_path(mapping::OccupancyGrid grid, geometry::Pose2 T_map_robot) {
  ReturnPath return_path({}, {});
  auto snapshot = tests::snapshot_of(std::move(grid));
  for (int i = 0; i < 2000; ++i) {
    snapshot.latest.T_map_robot = T_map_robot;
    const auto motion = return_path.next(snapshot);
    if (!motion) {
      return T_map_robot;
    }
    if (const auto* turn = std::get_if<Turn>(&*motion)) {
      T_map_robot = T_map_robot * geometry::Pose2(0.0, 0.0, turn->angle_rad);
    } else if (const auto* roll = std::get_if<Roll>(&*motion)) {
      T_map_robot = T_map_robot * sensors::arc_step(roll->forward_m_per_s * roll->for_s,
                                                    roll->turn_rad_per_s * roll->for_s);
    }
  }
  ADD_FAILURE() << "it never ends";
  return T_map_robot;
}

TEST(ReturnPath, LeadsRoundAWallToTheStart) {
  const auto end = end_of_path(floor_with_a_wall(true), {2.0, -0.5, 1.0});
  EXPECT_LT(end.position_m().norm(), 0.1);
}

TEST(ReturnPath, StaysWhereNoWayIsKnown) {
  const auto end = end_of_path(floor_with_a_wall(false), {2.0, -0.5, 1.0});
  EXPECT_NEAR(end.x_m(), 2.0, 1e-9);
}

TEST(ReturnPath, IsDoneAtTheStart) {
  ReturnPath return_path({}, {});
  EXPECT_FALSE(return_path.next(tests::snapshot_of(floor_with_a_wall(true))));
}

}  // namespace
}  // namespace echomap::exploration
