// SPDX-License-Identifier: MIT
#include "host/exploration/stop_tour.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;

/// Carries out a tour as it is asked to, on a floor where nothing is in the way.
struct ObedientRobot {
  pipeline::Snapshot snapshot = tests::snapshot_of(mapping::OccupancyGrid(), {});
  std::vector<Eigen::Vector2d> stops_m;
  std::vector<Motion> motions;

  /// Answers why the tour ended, or nothing after far too many motions. `result_of` says how a
  /// motion ends.
  template <class ResultOf>
  std::optional<FinishReason> drive(StopTour& tour, const ResultOf& result_of) {
    MotionResult last = MotionResult::kReached;
    for (int i = 0; i < 5000; ++i) {
      motions.push_back(tour.next(snapshot, last));
      const Motion& motion = motions.back();
      if (const auto* finished = std::get_if<Finished>(&motion)) {
        return finished->reason;
      }
      last = result_of(motion);
      carry_out(motion);
    }
    return std::nullopt;
  }
  std::optional<FinishReason> drive(StopTour& tour) {
    return drive(tour, [](const Motion&) { return MotionResult::kReached; });
  }
  void carry_out(const Motion& motion) {
    Pose2& at = snapshot.latest.T_map_robot;
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      at = at * Pose2(0.0, 0.0, turn->angle_rad);
    } else if (const auto* drive = std::get_if<Drive>(&motion)) {
      at = at * Pose2(drive->distance_m, 0.0, 0.0);
    } else if (const auto* roll = std::get_if<Roll>(&motion)) {
      at = at * Pose2(roll->forward_m_per_s * roll->for_s, 0.0, roll->turn_rad_per_s * roll->for_s);
    } else if (std::holds_alternative<BeginScan>(motion)) {
      stops_m.push_back(at.position_m());
    }
  }
};

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
