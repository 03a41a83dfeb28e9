// SPDX-License-Identifier: MIT
#include "host/exploration/frontier.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::exploration {
namespace {

using geometry::Pose2;
using geometry::radians;
using mapping::OccupancyGrid;

/// Free floor of 4 m x 2 m with its walls, but for the one at the far end of x, around the start.
OccupancyGrid open_room(bool closed = false) {
  OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 60; ++x) {
      const bool wall = x == -20 || std::abs(y) == 20 || (closed && x == 60);
      grid.add({x, y}, wall ? 300 : -300);
    }
  }
  return grid;
}

pipeline::Snapshot told(OccupancyGrid grid, const Pose2& T_map_robot, std::size_t stops = 1) {
  auto snapshot = tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, T_map_robot)});
  snapshot.stops = stops;
  return snapshot;
}

/// The motions of a stop, all of them carried out: those from BeginScan to EndScan.
std::vector<Motion> stop_of(Frontier& explorer, const pipeline::Snapshot& snapshot) {
  std::vector<Motion> motions;
  do {
    motions.push_back(explorer.next(snapshot, MotionResult::kReached));
  } while (!std::holds_alternative<EndScan>(motions.back()) && motions.size() < 20);
  return motions;
}

/// After the first stop, the first motion towards the open end of the room.
Motion first_move(Frontier& explorer, const pipeline::Snapshot& snapshot) {
  stop_of(explorer, snapshot);
  return explorer.next(snapshot, MotionResult::kReached);
}

TEST(Frontier, LooksAllRoundAtFirstInFineSteps) {
  Frontier explorer({});
  auto snapshot = told(OccupancyGrid(), {});
  snapshot.stops = 0;
  const auto motions = stop_of(explorer, snapshot);
  ASSERT_TRUE(std::holds_alternative<BeginScan>(motions.front()));
  double heading_rad = 0.0;
  std::vector<bool> read(90, false);
  for (const Motion& motion : motions) {
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      heading_rad += turn->angle_rad;
    }
    if (const auto* sweep = std::get_if<Sweep>(&motion)) {
      const auto readings = std::lround((sweep->to_rad - sweep->from_rad) / sweep->step_rad) + 1;
      for (int i = 0; i < readings; ++i) {
        const double pan_rad = sweep->from_rad + i * sweep->step_rad;
        EXPECT_LE(std::abs(pan_rad), FrontierParams{}.sweep.pan_limit_rad + 1e-9);
        EXPECT_DOUBLE_EQ(std::abs(sweep->step_rad), FrontierParams{}.sweep.step_rad / 4.0);
        const double bearing_rad = geometry::wrap_angle(heading_rad + pan_rad) + std::numbers::pi;
        read[static_cast<std::size_t>(bearing_rad / (2.0 * std::numbers::pi) * 89.999)] = true;
      }
    }
  }
  EXPECT_GT(std::count(read.begin(), read.end(), true), 80);
}

/// Carries out the way that begins with `motion`, to the sweep at its end.
Pose2 end_of_path(Frontier& explorer, Motion motion, pipeline::Snapshot snapshot) {
  Pose2& at = snapshot.latest.T_map_robot;
  for (int motions = 0; motions < 500 && !std::holds_alternative<BeginScan>(motion); ++motions) {
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      at = at * Pose2(0.0, 0.0, turn->angle_rad);
    } else {
      const auto roll = std::get<Roll>(motion);
      at = at * Pose2(roll.forward_m_per_s * roll.for_s, 0.0, roll.turn_rad_per_s * roll.for_s);
    }
    motion = explorer.next(snapshot, MotionResult::kReached);
  }
  EXPECT_TRUE(std::holds_alternative<BeginScan>(motion));
  return at;
}

TEST(Frontier, GoesTowardsUnknownFloorAndSweepsIt) {
  Frontier explorer({});
  const auto snapshot = told(open_room(), {});
  EXPECT_GT(end_of_path(explorer, first_move(explorer, snapshot), snapshot).x_m(), 1.0);
}

/// A corridor of 1 m along x, known up to 1.5 m or so many cells, and in which nothing has
/// answered.
pipeline::Snapshot silent_corridor(int known_cells = 30) {
  OccupancyGrid grid;
  for (int y = -10; y <= 10; ++y) {
    for (int x = -20; x < known_cells; ++x) {
      grid.add({x, y}, x == -20 || std::abs(y) == 10 ? 300 : -300);
    }
  }
  mapping::Scan silence;
  for (int deg = 0; deg < 360; deg += 4) {
    const Pose2 look(0.0, 0.0, radians(deg));
    silence.push_back({look, look, std::nullopt});
  }
  auto snapshot = told(grid, {});
  snapshot.scans =
      std::make_shared<const std::vector<mapping::Scan>>(std::vector<mapping::Scan>{silence});
  return snapshot;
}

FrontierParams no_look_is_worth_it() {
  FrontierParams params;
  params.viewpoints.min_gain_m2 = 100.0;
  params.fine_gain_m2 = 100.0;
  return params;
}

/// The open room, of which somebody else is about to see what this robot would go for.
Company promising(double utility) {
  Company company;
  company.promised.push_back({{2.6, 0.0}, 2.5, utility});
  return company;
}

TEST(Frontier, LeavesToOthersWhatTheyHavePromisedToLookAt) {
  Frontier alone({});
  Frontier accompanied({});
  accompanied.set_company(promising(100.0));
  const auto snapshot = told(open_room(), {});
  first_move(alone, snapshot);
  first_move(accompanied, snapshot);
  ASSERT_TRUE(alone.goal());
  const auto goal = accompanied.goal();
  EXPECT_TRUE(!goal || goal->view.gain_m2 < 0.7 * alone.goal()->view.gain_m2);
}

TEST(Frontier, OutbidsOneWhoPromisesLess) {
  Frontier alone({});
  Frontier accompanied({});
  accompanied.set_company(promising(0.001));
  const auto snapshot = told(open_room(), {});
  first_move(alone, snapshot);
  first_move(accompanied, snapshot);
  ASSERT_TRUE(accompanied.goal());
  EXPECT_EQ(accompanied.goal()->at_m, alone.goal()->at_m);
}

TEST(Frontier, GoesByTheMapOfAllAndNotByItsOwn) {
  Company company;
  company.grid = std::make_shared<const OccupancyGrid>(open_room(true));
  Frontier explorer({});
  explorer.set_company(company);
  const auto motion = first_move(explorer, told(open_room(), {}));
  EXPECT_TRUE(std::holds_alternative<Finished>(motion)) << "for all the room is closed";
}

TEST(Frontier, DecidesAgainOnTheWayWhereItIsAskedTo) {
  Frontier explorer({});
  const auto snapshot = told(open_room(), {});
  first_move(explorer, snapshot);
  ASSERT_TRUE(explorer.goal());
  Company company;
  company.grid = std::make_shared<const OccupancyGrid>(open_room(true));
  explorer.set_company(company);
  EXPECT_FALSE(std::holds_alternative<Finished>(explorer.next(snapshot, MotionResult::kReached)));
  explorer.reconsider();
  EXPECT_TRUE(std::holds_alternative<Finished>(explorer.next(snapshot, MotionResult::kReached)));
  explorer.set_company({});
  explorer.reconsider();
  explorer.next(snapshot, MotionResult::kReached);
  EXPECT_TRUE(explorer.goal()) << "there is floor left after all";
}

TEST(Frontier, LooksOnForLessUntilTheMapHasEnough) {
  FrontierParams params = no_look_is_worth_it();
  params.openings.far_m = 0.01;  // None is seen.
  for (const double fine_m2 : {100.0, 0.03}) {
    params.fine_gain_m2 = fine_m2;
    Frontier explorer(params);
    const auto motion = first_move(explorer, told(open_room(), {}));
    EXPECT_EQ(std::holds_alternative<Finished>(motion), fine_m2 > 1.0);
  }
  params.enough_share = 0.0;
  Frontier satisfied(params);
  EXPECT_TRUE(std::holds_alternative<Finished>(first_move(satisfied, told(open_room(), {}))));
}

TEST(Frontier, StepsOnceIntoAnOpeningWhereNoLookIsWorthIt) {
  Frontier explorer(no_look_is_worth_it());
  const auto snapshot = silent_corridor();
  const Pose2 end = end_of_path(explorer, first_move(explorer, snapshot), snapshot);
  EXPECT_NEAR(end.x_m(), 1.7, 0.1);
  EXPECT_LT(std::abs(end.y_m()), 0.3);
  // The map of this snapshot has the opening still, and the robot before it.
  stop_of(explorer, snapshot);
  const auto motion = explorer.next(snapshot, MotionResult::kReached);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kComplete);
}

TEST(Frontier, TriesAnOpeningAgainThatItWasStoppedOnTheWayTo) {
  const FrontierParams params = no_look_is_worth_it();
  Frontier explorer(params);
  auto snapshot = silent_corridor();
  Motion motion = first_move(explorer, snapshot);
  ASSERT_TRUE(explorer.goal());
  EXPECT_GT(explorer.goal()->at_m.x(), 1.0);
  // What it bumps into stands behind where it has listened from.
  snapshot.latest.T_map_robot = Pose2(-0.5, 0.2, std::numbers::pi);
  for (std::size_t bumps = 1; bumps <= params.opening_tries; ++bumps) {
    motion = explorer.next(snapshot, MotionResult::kBumped);
    for (int i = 0; i < 5 && std::holds_alternative<Drive>(motion); ++i) {
      motion = explorer.next(snapshot, MotionResult::kReached);
    }
    EXPECT_EQ(explorer.goal().has_value(), bumps < params.opening_tries) << bumps;
  }
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kComplete);
}

TEST(Frontier, LooksAtAWallThatMayBeADoorThreeTimesAtMost) {
  Frontier explorer(no_look_is_worth_it());
  auto snapshot = told(open_room(true), {});
  mapping::SonarFeatures features;
  features.unheard = {{{3.0, -0.4}, {3.0, 0.4}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  Motion motion = first_move(explorer, snapshot);
  explorer.reconsider();
  double before_m = 0.0;
  for (int tries = 0; tries < 3; ++tries) {
    motion = explorer.next(snapshot, MotionResult::kReached);
    ASSERT_TRUE(explorer.goal()) << "a goal that was given up is no try";
    EXPECT_GT(explorer.goal()->at_m.x(), before_m) << "nearer each time";
    before_m = explorer.goal()->at_m.x();
    snapshot.latest.T_map_robot = end_of_path(explorer, motion, snapshot);
    stop_of(explorer, snapshot);
  }
  motion = explorer.next(snapshot, MotionResult::kReached);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kComplete);
}

TEST(Frontier, GoesOnWhereAnOpeningHasBecomeFloor) {
  Frontier explorer(no_look_is_worth_it());
  auto snapshot = silent_corridor();
  end_of_path(explorer, first_move(explorer, snapshot), snapshot);
  stop_of(explorer, snapshot);
  const auto farther = silent_corridor(35);
  const Pose2 end = end_of_path(explorer, explorer.next(farther, MotionResult::kReached), farther);
  EXPECT_NEAR(end.x_m(), 1.95, 0.1);
}

TEST(Frontier, IsCompleteWhereTheRoomIsClosed) {
  Frontier explorer({});
  const auto motion = first_move(explorer, told(open_room(true), {}));
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kComplete);
}

TEST(Frontier, FacesAWallThatNobodyHasHeardBeforeItIsComplete) {
  auto snapshot = told(open_room(true), {});
  mapping::SonarFeatures features;
  features.unobserved = {{{3.0, -0.5}, {3.0, 0.5}}};
  snapshot.features = std::make_shared<const mapping::SonarFeatures>(features);
  FrontierParams params;
  params.enough_share = 1.0;
  Frontier explorer(params);
  const Pose2 end = end_of_path(explorer, first_move(explorer, snapshot), snapshot);
  EXPECT_GT(end.x_m(), 0.5) << "within range of it";
  EXPECT_LT(std::abs(end.y_m()), 0.4);
}

TEST(Frontier, GoesBackToKnownWallsBeforeItLooksFarther) {
  auto snapshot = told(open_room(), {});
  const mapping::PlacedReading wall_behind{{-0.8, 0.0, 0.0}, {-0.8, 0.0, 0.0}, 0.2};
  const auto scans = std::vector<mapping::Scan>{{wall_behind}};
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(scans);
  for (const double stddev_m : {0.1, 1.0}) {
    Frontier explorer({});
    snapshot.position_stddev_m = 0.0;
    end_of_path(explorer, first_move(explorer, snapshot), snapshot);
    stop_of(explorer, snapshot);
    snapshot.position_stddev_m = stddev_m;
    const Pose2 end =
        end_of_path(explorer, explorer.next(snapshot, MotionResult::kReached), snapshot);
    EXPECT_EQ(end.x_m() < -0.6, stddev_m > 0.5) << end.x_m();
  }
}

TEST(Frontier, BacksOffFromABumpAndGoesAnotherWay) {
  Frontier explorer({});
  auto snapshot = told(open_room(), {});
  first_move(explorer, snapshot);
  snapshot.hazards.bump_left = true;
  snapshot.hazards.bump_right = true;
  const auto back = explorer.next(snapshot, MotionResult::kBumped);
  ASSERT_TRUE(std::holds_alternative<Drive>(back));
  EXPECT_LT(std::get<Drive>(back).distance_m, 0.0);
  snapshot.hazards = {};
  const auto on = explorer.next(snapshot, MotionResult::kReached);
  const auto* turn = std::get_if<Turn>(&on);
  const auto* roll = std::get_if<Roll>(&on);
  ASSERT_TRUE(turn != nullptr || roll != nullptr);
  EXPECT_TRUE(turn != nullptr || std::abs(roll->turn_rad_per_s) > 0.1) << "straight into it again";
}

TEST(Frontier, LooksFromWhereItWasStoppedRightBeforeItsGoal) {
  Frontier explorer({});
  auto snapshot = told(open_room(), {});
  first_move(explorer, snapshot);
  ASSERT_TRUE(explorer.goal());
  const Eigen::Vector2d goal_m = explorer.goal()->at_m;
  snapshot.latest.T_map_robot = Pose2(goal_m.x() - 0.07, goal_m.y(), 0.0);
  ASSERT_TRUE(std::holds_alternative<Drive>(explorer.next(snapshot, MotionResult::kBumped)));
  snapshot.latest.T_map_robot = Pose2(goal_m.x() - 0.17, goal_m.y(), 0.0);
  EXPECT_TRUE(std::holds_alternative<BeginScan>(explorer.next(snapshot, MotionResult::kReached)));
}

TEST(Frontier, LooksFromAnotherPlaceWhereAScanContradictedItsMap) {
  auto snapshot = told(open_room(), {});
  for (const auto fault : {mapping::ScanFault::kNone, mapping::ScanFault::kElsewhere}) {
    Frontier explorer({});
    snapshot.latest.T_map_robot = {};
    snapshot.last_scan_fault = mapping::ScanFault::kNone;
    const Pose2 first = end_of_path(explorer, first_move(explorer, snapshot), snapshot);
    snapshot.latest.T_map_robot = first;
    snapshot.last_scan_fault = fault;
    stop_of(explorer, snapshot);
    const Motion motion = explorer.next(snapshot, MotionResult::kReached);
    const bool looks_again = std::holds_alternative<BeginScan>(motion);
    EXPECT_EQ(looks_again, fault == mapping::ScanFault::kNone) << "its map has nothing of it yet";
    EXPECT_TRUE(looks_again || (explorer.goal()->at_m - first.position_m()).norm() > 0.2);
  }
}

TEST(Frontier, TakesAContactThatNoMotionToldForABump) {
  Frontier explorer({});
  auto snapshot = told(open_room(), {});
  first_move(explorer, snapshot);
  snapshot.hazards.bump_left = true;
  EXPECT_TRUE(std::holds_alternative<Drive>(explorer.next(snapshot, MotionResult::kReached)));
}

TEST(Frontier, GivesUpWhereNothingMovesIt) {
  Frontier explorer({});
  const auto snapshot = told(open_room(), {});
  Motion motion = first_move(explorer, snapshot);
  for (int i = 0; i < 100 && !std::holds_alternative<Finished>(motion); ++i) {
    motion = explorer.next(snapshot, MotionResult::kStalled);
  }
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kNowhereToGo);
}

TEST(Frontier, SaysThatItCannotSenseWhereNoSweepIsDone) {
  Frontier explorer({});
  const auto snapshot = told(open_room(), {});
  Motion motion = explorer.next(snapshot, MotionResult::kReached);
  for (int i = 0; i < 20 && !std::holds_alternative<Finished>(motion); ++i) {
    const bool sweep = std::holds_alternative<Sweep>(motion);
    motion = explorer.next(snapshot, sweep ? MotionResult::kTimedOut : MotionResult::kReached);
  }
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kCannotSense);
}

TEST(Frontier, LooksAllRoundAnewOnceItWasLifted) {
  Frontier explorer({});
  const auto snapshot = told(open_room(), {});
  first_move(explorer, snapshot);
  EXPECT_TRUE(std::holds_alternative<BeginScan>(explorer.next(snapshot, MotionResult::kLifted)));
}

TEST(Frontier, StopsAfterSoManyStops) {
  Frontier explorer({});
  const auto motion = first_move(explorer, told(open_room(), {}, FrontierParams{}.max_stops));
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kStopLimit);
}

TEST(Frontier, RejectsParametersWithoutSense) {
  FrontierParams params;
  params.sweep.step_rad = 0.0;
  EXPECT_THROW(Frontier{params}, std::invalid_argument);
  params = {};
  params.viewpoints.min_gain_m2 = 0.0;
  EXPECT_THROW(Frontier{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
