// SPDX-License-Identifier: MIT
#include "tests/benchmarks/ideal_map.hpp"

#include <gtest/gtest.h>

namespace echomap::bench {
namespace {

using mapping::CellState;

/// A room of 8 x 2 m with a box off its middle.
world::FloorPlan hall_with_box() {
  return {"hall",
          {{{0.0, 0.0}, {8.0, 0.0}, {8.0, 2.0}, {0.0, 2.0}}, {}},
          {{{{2.0, 0.8}, {2.4, 0.8}, {2.4, 1.2}, {2.0, 1.2}}, {}}},
          {1.0, 1.0, 0.0}};
}

CellState state_at(const mapping::RasterMap& map, double x_m, double y_m) {
  const Eigen::Vector2d in_world_m(x_m, y_m);
  return map.state(map.cell_at(hall_with_box().T_world_start().inverse() * in_world_m));
}

TEST(IdealMap, HasTheFloorThatAStopSees) {
  const auto plan = hall_with_box();
  const auto map = ideal_map(plan, truth_of(plan), {{1.0, 1.0}});
  EXPECT_EQ(state_at(map, 1.52, 1.02), CellState::kFree);
  EXPECT_EQ(state_at(map, 2.72, 1.02), CellState::kUnknown) << "behind the box";
  EXPECT_EQ(state_at(map, 2.22, 1.02), CellState::kUnknown) << "in the box";
  EXPECT_EQ(state_at(map, 4.52, 0.22), CellState::kUnknown) << "beyond its reach";
}

TEST(IdealMap, HasWallsOnlyWhereTheyAreMetStraight) {
  const auto plan = hall_with_box();
  const auto map = ideal_map(plan, truth_of(plan), {{1.0, 1.0}});
  EXPECT_EQ(state_at(map, 1.02, -0.025), CellState::kOccupied);
  EXPECT_NE(state_at(map, 1.72, -0.025), CellState::kOccupied);
  EXPECT_EQ(state_at(map, 2.025, 1.02), CellState::kOccupied) << "the face of the box";
}

TEST(IdealMap, IsNearlyTheTruthFromManyStops) {
  const auto plan = hall_with_box();
  const auto truth = truth_of(plan);
  std::vector<Eigen::Vector2d> stops_m;
  for (double x_m = 0.3; x_m < 8.0; x_m += 0.3) {
    stops_m.insert(stops_m.end(), {{x_m, 0.4}, {x_m, 1.6}});
  }
  const auto agreement =
      evaluation::score_map(ideal_map(plan, truth, stops_m), plan.T_world_start(), truth);
  EXPECT_GT(agreement.free_iou, 0.95);
  EXPECT_GT(agreement.wall_recall, 0.95);
  EXPECT_LT(agreement.wall_rmse_m.value(), 0.03);
}

}  // namespace
}  // namespace echomap::bench
