// SPDX-License-Identifier: MIT
#include "host/exploration/possible_doors.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/exploration/cost_grid.hpp"
#include "host/geometry/angle.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::exploration {
namespace {

using mapping::CellState;
using mapping::RasterMap;

/// The wall x = 2 from y = 0 to 0.6, its floor at smaller x.
const geometry::Segment kWall{{2.0, 0.0}, {2.0, 0.6}};

/// Free floor that ends with it.
RasterMap floor_to_wall() {
  RasterMap map = tests::free_floor();
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = map.cell_at({2.0 + 1e-6, 0.0}).x; x < map.columns(); ++x) {
      map.set({x, y}, CellState::kUnknown);
    }
  }
  return map;
}

PastView all_round_from(double x_m, double y_m) { return {{x_m, y_m}, 0.0, std::numbers::pi}; }

TEST(PossibleDoors, AreWideEnoughAndToldByNobody) {
  const RasterMap map = floor_to_wall();
  EXPECT_EQ(possible_doors(map, {kWall}, {}, {}).size(), 1U);
  EXPECT_TRUE(possible_doors(map, {{{2.0, 0.0}, {2.0, 0.45}}}, {}, {}).empty()) << "too narrow";
  EXPECT_TRUE(possible_doors(map, {kWall}, {all_round_from(1.5, 0.3)}, {}).empty());
}

TEST(PossibleDoors, AreToldOnlyFromNearAndBeforeThem) {
  const RasterMap map = floor_to_wall();
  for (const PastView& view : {all_round_from(0.5, 0.3),   // ends and wall are as far as each other
                               all_round_from(1.8, 0.05),  // too near to one end
                               all_round_from(1.5, 0.8),   // beside it
                               all_round_from(2.4, 0.3),   // behind it
                               PastView{{1.5, 0.3}, std::numbers::pi, 0.5}}) {  // it looked away
    EXPECT_EQ(possible_doors(map, {kWall}, {view}, {}).size(), 1U) << view.from_m.transpose();
  }
}

TEST(PossibleDoors, AreNoneWhereTheFloorBehindIsKnown) {
  EXPECT_TRUE(possible_doors(tests::free_floor(), {kWall}, {}, {}).empty());
}

TEST(NearestDoorStand, IsBeforeTheNearestDoorAndNotTwiceTheSame) {
  const RasterMap map = tests::free_floor();
  const CostGrid costs(map, {0.0, 0.3}, {});
  TravelField travel;
  travel.search(costs, map.cell_at({0.0, 0.3}));
  const geometry::Segment farther{{3.0, 1.0}, {3.0, 1.8}};
  const auto stand = nearest_door_stand(map, {farther, kWall}, travel, {}, {});
  ASSERT_TRUE(stand);
  EXPECT_NEAR(stand->at_m.y(), 0.3, 1e-9);
  EXPECT_NEAR(stand->at_m.x(), 1.0, 0.05) << "ends 0.3 m beside are 4 cm farther off at 1.1 m";
  const Eigen::Vector2d moved_m = stand->middle_m + Eigen::Vector2d(0.1, 0.1);
  const auto next = nearest_door_stand(map, {kWall}, travel, {moved_m}, {});
  ASSERT_TRUE(next);
  EXPECT_GT(next->at_m.x(), stand->at_m.x()) << "nearer";
  EXPECT_FALSE(nearest_door_stand(map, {kWall}, travel, {moved_m, moved_m, moved_m}, {}));
}

TEST(NearestDoorStand, IsNoneWhereTheRobotCannotGo) {
  RasterMap map = tests::free_floor();
  for (int y = 0; y < 100; ++y) {
    for (const double x_m : {0.8, 0.85, 0.9}) {
      map.set({map.cell_at({x_m, 0.0}).x, y}, CellState::kOccupied);
    }
  }
  const CostGrid costs(map, {0.0, 0.3}, {});
  TravelField travel;
  travel.search(costs, map.cell_at({0.0, 0.3}));
  EXPECT_FALSE(nearest_door_stand(map, {kWall}, travel, {}, {}));
}

}  // namespace
}  // namespace echomap::exploration
