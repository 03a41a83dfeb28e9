// SPDX-License-Identifier: MIT
#include "host/exploration/stop_tour.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "tests/host/exploration/obedient_robot.hpp"

namespace echomap::exploration {
namespace {

const std::vector<TourPlace> kTriangle{
    {"start", {0.0, 0.0}}, {"passed", {1.0, 0.0}, false}, {"far", {1.0, 1.0}}};

TEST(StopTour, SweepsAtEachPlaceInOrderAndPassesThroughTheOthers) {
  StopTour tour({}, kTriangle);
  ObedientRobot robot;
  EXPECT_EQ(robot.drive(tour), FinishReason::kComplete);
  ASSERT_EQ(robot.stops_m.size(), 2U);
  EXPECT_LT(robot.stops_m[0].norm(), 0.05);
  EXPECT_LT((robot.stops_m[1] - Eigen::Vector2d(1.0, 1.0)).norm(), 0.05);
  EXPECT_EQ(tour.products().phases, 3U);
  EXPECT_EQ(tour.products().phases_reached, 3U);
}

TEST(StopTour, SweepsInFinerStepsAtTheMapsFirstStopAlone) {
  for (const std::size_t stops : {0U, 1U}) {
    StopTour tour({}, kTriangle);
    ObedientRobot robot;
    robot.snapshot.stops = stops;
    robot.drive(tour);
    const auto motion =
        std::find_if(robot.motions.begin(), robot.motions.end(), [](const Motion& one) {
          return std::holds_alternative<Sweep>(one);
        });
    ASSERT_NE(motion, robot.motions.end());
    const double step_rad = StopTourParams{}.sweep.step_rad;
    EXPECT_DOUBLE_EQ(std::get<Sweep>(*motion).step_rad, stops == 0 ? step_rad / 4.0 : step_rad);
  }
}

TEST(StopTour, DrivesByWayOfAPlaceThatItOnlyPasses) {
  StopTour tour({}, kTriangle);
  ObedientRobot robot;
  double nearest_m = 1.0;
  robot.drive(tour, [&](const Motion&) {
    const Eigen::Vector2d& at_m = robot.snapshot.latest.T_map_robot.position_m();
    nearest_m = std::min(nearest_m, (at_m - Eigen::Vector2d(1.0, 0.0)).norm());
    return MotionResult::kReached;
  });
  EXPECT_LT(nearest_m, 0.05);
}

TEST(StopTour, BacksOffFromABumpAndGoesOnWithTheNextPlace) {
  StopTour tour({}, kTriangle);
  ObedientRobot robot;
  bool bumped = false;
  const auto reason = robot.drive(tour, [&](const Motion& motion) {
    if (!bumped && std::holds_alternative<Roll>(motion)) {
      bumped = true;
      return MotionResult::kBumped;
    }
    return MotionResult::kReached;
  });
  EXPECT_EQ(reason, FinishReason::kWaypointsMissed);
  EXPECT_EQ(tour.products().phases_reached, 2U);
  EXPECT_EQ(robot.stops_m.size(), 2U);
  const auto backwards = [](const Motion& motion) {
    const auto* drive = std::get_if<Drive>(&motion);
    return drive != nullptr && drive->distance_m < 0.0;
  };
  EXPECT_EQ(std::count_if(robot.motions.begin(), robot.motions.end(), backwards), 1);
}

TEST(StopTour, GivesUpAPlaceThatItDoesNotGetNearerTo) {
  StopTour tour({}, {{"near", {0.5, 0.0}, false}});
  const auto snapshot = tests::snapshot_of(mapping::OccupancyGrid(), {});
  Motion motion;
  for (int i = 0; i < 1000 && !std::holds_alternative<Finished>(motion); ++i) {
    motion = tour.next(snapshot, MotionResult::kReached);
  }
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kWaypointsMissed);
}

TEST(StopTour, EndsWhereNoneOfAStopsSweepsIsCarriedOut) {
  StopTour tour({}, kTriangle);
  ObedientRobot robot;
  const auto reason = robot.drive(tour, [](const Motion& motion) {
    return std::holds_alternative<Sweep>(motion) ? MotionResult::kRefused : MotionResult::kReached;
  });
  EXPECT_EQ(reason, FinishReason::kCannotSense);
}

TEST(StopTour, EndsWhenTheRobotIsLifted) {
  StopTour tour({}, kTriangle);
  const auto motion =
      tour.next(tests::snapshot_of(mapping::OccupancyGrid(), {}), MotionResult::kLifted);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kLifted);
}

TEST(StopTour, RefusesAnEmptyListAndAPlaceThatIsNowhere) {
  EXPECT_THROW(StopTour({}, {}), std::invalid_argument);
  EXPECT_THROW(StopTour({}, {{"nowhere", {NAN, 0.0}}}), std::invalid_argument);
  StopTourParams params;
  params.sweep.step_rad = 0.0;
  EXPECT_THROW(StopTour(params, kTriangle), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
