// SPDX-License-Identifier: MIT
#include "host/slam/stop_graph.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;
using geometry::radians;

/// Stands a metre apart, on a straight line by odometry.
StopGraph straight(std::size_t stands) {
  StopGraph graph;
  for (std::size_t i = 0; i < stands; ++i) {
    GraphStand& stand = graph.stands.emplace_back();
    stand.T_map_robot = Pose2(static_cast<double>(i), 0.0, 0.0);
    if (i > 0) {
      stand.piece_before = OdometryPiece{{1.0, 0.0, 0.0}, 1.0, 0.0, 0.0, 0.0, 0.0};
    }
  }
  return graph;
}

TEST(StopGraph, StaysWithOdometryAlone) {
  StopGraph graph = straight(3);
  align_stops({}, graph);
  EXPECT_NEAR(graph.stands[2].T_map_robot.x_m(), 2.0, 1e-9);
  EXPECT_NEAR(graph.stands[2].T_map_robot.y_m(), 0.0, 1e-9);
}

/// All headings are measured against the same walls: if only that of the first one is off, the
/// first one was turned, and the others lie elsewhere in its frame.
TEST(StopGraph, TurnsTheMapWhereTheFirstHeadingWasOff) {
  StopGraph graph = straight(4);
  for (GraphStand& stand : graph.stands) {
    stand.heading = HeadingEstimate{0.0, radians(0.5)};
  }
  graph.stands[0].heading->heading_rad = radians(4.0);
  align_stops({}, graph);
  EXPECT_EQ(graph.stands[0].T_map_robot.heading_rad(), 0.0);
  EXPECT_LT(graph.stands[3].T_map_robot.heading_rad(), radians(-1.0));
}

TEST(StopGraph, LearnsTheShareOfATurnFromHeadings) {
  StopGraph graph;
  for (int i = 0; i < 8; ++i) {
    GraphStand& stand = graph.stands.emplace_back();
    const double turn_rad = i % 2 == 1 ? 3.0 : -3.0;
    stand.T_map_robot = Pose2(0.0, 0.0, i % 2 == 1 ? 3.0 : 0.0);
    stand.heading = HeadingEstimate{i % 2 == 1 ? 3.06 : 0.0, radians(0.7)};
    if (i > 0) {
      stand.piece_before = OdometryPiece{{0.0, 0.0, turn_rad}, 0.0, turn_rad, 3.0, 0.0, 0.0};
    }
  }
  align_stops({}, graph);
  EXPECT_NEAR(graph.calibrations[0].turn_share(), 0.02, 0.005);
}

TEST(StopGraph, MovesAStandToWhereItsRangesAgreeAndLeavesThoseThatAreHeld) {
  StopGraph graph = straight(3);
  graph.stands[0].is_free = false;
  graph.stands[1].is_free = false;
  graph.features.push_back({{mapping::LandmarkKind::kWall, {5.0, 0.0}}, {}});
  graph.features[0].sightings = {
      {0, {0.0, 0.0}, 5.0, 0.0}, {1, {0.0, 0.0}, 4.0, 0.0}, {2, {0.0, 0.0}, 2.96, 0.0}};
  align_stops({}, graph);
  EXPECT_EQ(graph.stands[1].T_map_robot.x_m(), 1.0);
  EXPECT_GT(graph.stands[2].T_map_robot.x_m(), 2.005);
}

TEST(StopGraph, OdometryCostsNothingAsMeasuredAndTheSquareOfWhatItIsOff) {
  StopGraph graph = straight(3);
  EXPECT_EQ(odometry_cost({}, graph), 0.0);
  graph.stands[2].T_map_robot = Pose2(2.1, 0.0, 0.0);
  const double cost = odometry_cost({}, graph);
  EXPECT_GT(cost, 1.0);
  graph.stands[2].T_map_robot = Pose2(2.2, 0.0, 0.0);
  EXPECT_NEAR(odometry_cost({}, graph), 4.0 * cost, 1e-9);
}

TEST(StopGraph, ACalibrationCostsTheSquareOfItsDeviations) {
  const StopGraphParams params;
  StopGraph graph = straight(1);
  graph.calibrations[0].values = {0.0, 2.0 * params.drift_stddev_rad_per_m, 0.0};
  EXPECT_NEAR(odometry_cost(params, graph), 2.0, 1e-12);
}

/// Two robots whose wheels are off by other shares of a drive, each between two walls of its own:
///
///     | 0 -------- 1 |      | 2 -------- 3 |
TEST(StopGraph, LearnsTheErrorsOfEachRobot) {
  StopGraph graph = straight(4);
  graph.calibrations.resize(2);
  graph.stands[2].piece_before.reset();
  graph.stands[2].robot = 1;
  graph.stands[3].robot = 1;
  graph.relations.push_back({0, 2, Pose2(2.0, 0.0, 0.0), 0.05, 0.05});
  const auto add_walls = [&](std::size_t first, double apart_m) {
    for (const double behind_m : {0.5, 0.7, 0.9, 1.1}) {
      const double at_m = static_cast<double>(first) - behind_m;
      graph.features.push_back({{mapping::LandmarkKind::kWall, {-at_m, radians(180.0)}}, {}});
      graph.features.back().sightings = {
          {first, {0.0, 0.0}, behind_m, radians(180.0)},
          {first + 1, {0.0, 0.0}, behind_m + apart_m, radians(180.0)}};
    }
  };
  add_walls(0, 1.04);
  add_walls(2, 0.96);
  align_stops({}, graph);
  EXPECT_GT(graph.calibrations[0].drive_share(), 0.02);
  EXPECT_LT(graph.calibrations[1].drive_share(), -0.02);
}

TEST(StopGraph, BringsTwoRobotsToWhereTheyAreKnownToBe) {
  StopGraph graph = straight(2);
  graph.stands[1].piece_before.reset();
  graph.stands[1].robot = 1;
  graph.calibrations.resize(2);
  graph.relations.push_back({0, 1, Pose2(1.2, 0.1, 0.3), 0.01, 0.01});
  align_stops({}, graph);
  EXPECT_NEAR(graph.stands[1].T_map_robot.x_m(), 1.2, 0.01);
  EXPECT_NEAR(graph.stands[1].T_map_robot.y_m(), 0.1, 0.01);
  EXPECT_NEAR(graph.stands[1].T_map_robot.heading_rad(), 0.3, 0.01);
}

TEST(StopGraph, KnowsAStandTheLessTheFartherItHasGone) {
  const StopGraph graph = straight(6);
  EXPECT_EQ(covariance_of({}, graph, 0)->norm(), 0.0);
  const auto near = covariance_of({}, graph, 1);
  const auto far = covariance_of({}, graph, 5);
  ASSERT_TRUE(near && far);
  EXPECT_GT((*near)(0, 0), 0.0);
  EXPECT_GT((*far)(1, 1), 4.0 * (*near)(1, 1));
  EXPECT_GT((*far)(2, 2), (*near)(2, 2));
}

TEST(StopGraph, KnowsNothingOfAStandThatNothingTies) {
  StopGraph graph = straight(3);
  graph.stands[2].piece_before.reset();
  EXPECT_FALSE(covariance_of({}, graph, 2));
}

TEST(StopGraph, RefusesInvalidParameters) {
  StopGraphParams params;
  params.odometry_scales.clear();
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
