// SPDX-License-Identifier: MIT
#include "host/exploration/company.hpp"

#include <gtest/gtest.h>

#include "host/exploration/planning_map.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using mapping::CellState;

pipeline::Snapshot own_snapshot() {
  mapping::OccupancyGrid grid;
  grid.add({0, 0}, -300);
  return tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, {0.5, 0.0, 0.0})});
}

TEST(Company, OfNobodyLeavesASnapshotAsItIs) {
  const auto own = own_snapshot();
  const auto known = with_company(own, {});
  EXPECT_EQ(known.grid, own.grid);
  EXPECT_EQ(known.scans, own.scans);
  EXPECT_EQ(known.features, own.features);
  EXPECT_EQ(known.trajectory, own.trajectory);
}

TEST(Company, PutsTheMapOfAllInPlaceOfTheRobotsOwn) {
  mapping::OccupancyGrid all;
  all.add({40, 40}, -300);
  Company company;
  company.grid = std::make_shared<const mapping::OccupancyGrid>(all);
  company.scans = std::make_shared<const std::vector<mapping::Scan>>(3);
  const auto own = own_snapshot();
  const auto known = with_company(own, company);
  EXPECT_EQ(known.grid->state({40, 40}), CellState::kFree);
  EXPECT_EQ(known.scans->size(), 3U);
  EXPECT_EQ(own.grid->state({40, 40}), CellState::kUnknown);
}

TEST(Company, HasBeenWhereFloorIsAndTheRobotStandsAtTheEndOfItsOwnWay) {
  Company company;
  company.been_m = {{2.0, 2.0}};
  const auto known = with_company(own_snapshot(), company);
  const auto places_m = places_of(known);
  ASSERT_EQ(places_m.size(), 3U);
  EXPECT_EQ(places_m.front(), Eigen::Vector2d(2.0, 2.0));
  EXPECT_EQ(places_m.back(), Eigen::Vector2d(0.5, 0.0));
  const auto map = planning_map(known, 3.0, 0.09);
  EXPECT_EQ(map.state(map.cell_at({2.0, 2.0})), CellState::kFree);
}

}  // namespace
}  // namespace echomap::exploration
