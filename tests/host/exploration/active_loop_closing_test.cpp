// SPDX-License-Identifier: MIT
#include "host/exploration/active_loop_closing.hpp"

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/exploration/planning_map.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;

/// A hall of 12 m x 2 m and a robot in it.
class Hall {
 public:
  Hall() {
    mapping::OccupancyGrid floor;
    for (int y = -20; y <= 20; ++y) {
      for (int x = -20; x <= 220; ++x) {
        floor.add({x, y}, -300);
      }
    }
    snapshot_ = tests::snapshot_of(std::move(floor));
  }

  /// Makes a stop there at which the position is known so well.
  void stop(ActiveLoopClosing& loops, double x_m, double stddev_m) {
    const Pose2 T_map_robot(x_m, 0.0, 0.0);
    scans_.push_back({{T_map_robot, T_map_robot, 1.0}});
    snapshot_.scans = std::make_shared<const std::vector<mapping::Scan>>(scans_);
    snapshot_.latest = tests::pose_at(1.0, T_map_robot);
    snapshot_.position_stddev_m = stddev_m;
    loops.add_stop(snapshot_);
  }

  /// The x of the stop to return to before a goal there.
  std::optional<double> return_x_m(ActiveLoopClosing& loops, double goal_x_m) const {
    const mapping::RasterMap map = planning_map(snapshot_, 0.5, 0.09);
    const CostGrid costs = costs_on(map, snapshot_, {});
    TravelField travel;
    travel.search(costs, costs.cell_at(snapshot_.latest.T_map_robot.position_m()));
    const auto stop = loops.choose(snapshot_, {goal_x_m, 0.0}, travel, map);
    return stop ? std::optional(stop->at_m.x()) : std::nullopt;
  }

  void wall_off(double x_m) {
    mapping::OccupancyGrid floor = *snapshot_.grid;
    for (int y = -20; y <= 20; ++y) {
      floor.add({static_cast<int>(x_m / floor.resolution_m()), y}, 900);
    }
    snapshot_.grid = std::make_shared<const mapping::OccupancyGrid>(std::move(floor));
  }

 private:
  pipeline::Snapshot snapshot_;
  std::vector<mapping::Scan> scans_;
};

TEST(ActiveLoopClosing, GoesBackToTheNearestStopWhosePlaceWasKnown) {
  ActiveLoopClosing loops({});
  Hall hall;
  hall.stop(loops, 0.0, 0.0);
  hall.stop(loops, 2.0, 0.1);
  hall.stop(loops, 5.0, 0.4);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), std::nullopt) << "it is known well enough";
  hall.stop(loops, 8.0, 0.6);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), 2.0);
}

TEST(ActiveLoopClosing, GoesOnToAGoalBesideSuchAStop) {
  ActiveLoopClosing loops({});
  Hall hall;
  hall.stop(loops, 0.0, 0.0);
  hall.stop(loops, 2.0, 0.1);
  hall.stop(loops, 8.0, 0.6);
  EXPECT_EQ(hall.return_x_m(loops, 0.5), std::nullopt);
}

TEST(ActiveLoopClosing, GoesOnWhereNoWayLeadsBack) {
  ActiveLoopClosing loops({});
  Hall hall;
  hall.stop(loops, 0.0, 0.0);
  hall.stop(loops, 8.0, 0.6);
  hall.wall_off(4.0);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), std::nullopt);
}

TEST(ActiveLoopClosing, DoesNotGoBackAgainAndAgainWhereThatHasNotHelped) {
  ActiveLoopClosing loops({});
  Hall hall;
  hall.stop(loops, 0.0, 0.0);
  hall.stop(loops, 8.0, 0.6);
  ASSERT_EQ(hall.return_x_m(loops, 10.0), 0.0);
  hall.stop(loops, 0.0, 0.6);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), std::nullopt);
  hall.stop(loops, 8.0, 0.8);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), std::nullopt);
  hall.stop(loops, 8.0, 1.0);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), 0.0);
}

TEST(ActiveLoopClosing, TakesAnotherGoalThatCameBetweenForNoReturn) {
  ActiveLoopClosing loops({});
  Hall hall;
  hall.stop(loops, 0.0, 0.0);
  hall.stop(loops, 8.0, 0.6);
  ASSERT_EQ(hall.return_x_m(loops, 10.0), 0.0);
  ASSERT_EQ(hall.return_x_m(loops, 0.5), std::nullopt) << "after a bump on the way";
  hall.stop(loops, 8.0, 0.6);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), 0.0);
}

TEST(ActiveLoopClosing, HasItsLimitAgainOnceThePositionIsKnown) {
  ActiveLoopClosing loops({});
  Hall hall;
  hall.stop(loops, 0.0, 0.0);
  hall.stop(loops, 8.0, 0.6);
  ASSERT_EQ(hall.return_x_m(loops, 10.0), 0.0);
  hall.stop(loops, 0.0, 0.6);
  hall.stop(loops, 4.0, 0.1);
  hall.stop(loops, 8.0, 0.6);
  EXPECT_EQ(hall.return_x_m(loops, 10.0), 4.0);
}

TEST(ActiveLoopClosing, RejectsInvalidParameters) {
  ActiveLoopClosingParams params;
  params.max_position_stddev_m = 0.0;
  EXPECT_THROW(ActiveLoopClosing{params}, std::invalid_argument);
  params = {};
  params.max_known_share = 1.5;
  EXPECT_THROW(ActiveLoopClosing{params}, std::invalid_argument);
  params = {};
  params.limit_growth = 0.5;
  EXPECT_THROW(ActiveLoopClosing{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
