// SPDX-License-Identifier: MIT
#include "host/exploration/tangent_bug.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {
namespace {

using geometry::degrees;
using geometry::Pose2;
using geometry::Segment;

/// A grid of 4 x 4 m, the start in its middle, looking along x.
WaypointCourse course_to(const std::vector<Eigen::Vector2d>& places_m) {
  WaypointCourse course{"test", {2.0, 2.0, 0.0}, {{0, 0}, {79, 79}}, 0.05, {}, {}};
  for (const Eigen::Vector2d& place_m : places_m) {
    course.waypoints.push_back({std::to_string(course.waypoints.size()), place_m});
  }
  return course;
}

/// Carries out what the strategy asks for, exactly, among walls that a thin beam hears.
class Simulation {
 public:
  explicit Simulation(std::vector<Segment> walls = {}) : walls_(std::move(walls)) {}

  /// Motion by motion until the strategy has finished, or `most` drives are done.
  FinishReason run(TangentBug& explorer, std::size_t most = 100) {
    MotionResult last = MotionResult::kReached;
    while (drives_m.size() < most) {
      const Motion motion = explorer.next(snapshot(), last);
      if (const auto* finished = std::get_if<Finished>(&motion)) {
        return finished->reason;
      }
      last = execute(motion);
    }
    return FinishReason::kStopLimit;
  }
  Eigen::Vector2d place_m() const { return T_course_robot_.position_m(); }

  std::vector<double> drives_m;
  std::vector<Eigen::Vector2d> stops_m;
  /// What becomes of a drive that would end there; kReached where it is empty.
  std::function<MotionResult(const Eigen::Vector2d&)> fate;
  bool is_deaf = false;
  MotionResult sweep_result = MotionResult::kReached;

 private:
  MotionResult execute(const Motion& motion) {
    if (const auto* turn = std::get_if<Turn>(&motion)) {
      T_course_robot_ = T_course_robot_ * Pose2(0.0, 0.0, turn->angle_rad);
    } else if (const auto* drive = std::get_if<Drive>(&motion)) {
      return move(drive->distance_m);
    } else if (const auto* sweep = std::get_if<Sweep>(&motion)) {
      listen(*sweep);
      return sweep_result;
    } else if (std::holds_alternative<BeginScan>(motion)) {
      scan_.clear();
    } else if (std::holds_alternative<EndScan>(motion)) {
      last_scan_ = scan_;
    }
    return MotionResult::kReached;
  }
  MotionResult move(double distance_m) {
    const Pose2 T_course_end = T_course_robot_ * Pose2(distance_m, 0.0, 0.0);
    const auto result =
        fate && distance_m > 0.0 ? fate(T_course_end.position_m()) : MotionResult::kReached;
    drives_m.push_back(distance_m);
    if (result == MotionResult::kReached) {
      T_course_robot_ = T_course_end;
      stops_m.push_back(place_m());
    }
    return result;
  }
  void listen(const Sweep& sweep) {
    const auto steps = std::lround((sweep.to_rad - sweep.from_rad) / sweep.step_rad);
    for (int i = 0; i <= steps; ++i) {
      const Pose2 T_course_sonar =
          T_course_robot_ * Pose2(0.0, 0.0, sweep.from_rad + i * sweep.step_rad);
      const Pose2 T_map_course = Pose2(2.0, 2.0, 0.0).inverse();
      scan_.push_back(
          {T_map_course * T_course_robot_, T_map_course * T_course_sonar, range_m(T_course_sonar)});
    }
  }
  std::optional<double> range_m(const Pose2& T_course_sonar) const {
    std::optional<double> nearest_m;
    const Eigen::Vector2d along =
        T_course_sonar * Eigen::Vector2d(1.0, 0.0) - T_course_sonar.position_m();
    for (const Segment& wall : walls_) {
      const auto far_m = geometry::ray_distance_m(T_course_sonar.position_m(), along, wall);
      if (far_m && *far_m < nearest_m.value_or(2.5) && !is_deaf) {
        nearest_m = far_m;
      }
    }
    return nearest_m;
  }
  pipeline::Snapshot snapshot() const {
    pipeline::Snapshot snapshot;
    snapshot.T_odom_robot = Pose2(2.0, 2.0, 0.0).inverse() * T_course_robot_;
    snapshot.latest.T_map_robot = snapshot.T_odom_robot;
    snapshot.last_scan = std::make_shared<const mapping::Scan>(last_scan_);
    return snapshot;
  }

  std::vector<Segment> walls_;
  Pose2 T_course_robot_{2.0, 2.0, 0.0};
  mapping::Scan scan_;
  mapping::Scan last_scan_;
};

/// As the simulation does, with beams that are thin.
TangentBugParams pans_all_round() {
  TangentBugParams params;
  params.sweep.pan_limit_rad = std::numbers::pi;
  params.beam_half_angle_rad = 0.02;
  return params;
}

/// Across the way along x, from 2.7 m on.
std::vector<Segment> board(double low_m, double high_m) { return {{{2.7, low_m}, {2.7, high_m}}}; }

TEST(TangentBug, GoesStraightFromWaypointToWaypointWhereNothingStands) {
  TangentBug explorer(pans_all_round(), course_to({{3.0, 2.0}, {3.0, 3.0}, {2.0, 2.0}}));
  Simulation simulation;
  EXPECT_EQ(simulation.run(explorer), FinishReason::kComplete);
  EXPECT_LT((simulation.place_m() - Eigen::Vector2d(2.0, 2.0)).norm(), 0.3);
  for (const PhaseReport& phase : explorer.phases()) {
    EXPECT_TRUE(phase.was_reached) << phase.name;
    EXPECT_LE(phase.moves, 2U);
  }
  EXPECT_EQ(explorer.products().phases, 3U);
  EXPECT_EQ(explorer.products().phases_reached, 3U);
}

TEST(TangentBug, HasReachedAWaypointWithinThirtyCentimetres) {
  TangentBug explorer(pans_all_round(), course_to({{2.29, 2.0}}));
  Simulation simulation;
  EXPECT_EQ(simulation.run(explorer), FinishReason::kComplete);
  EXPECT_TRUE(simulation.drives_m.empty());
  TangentBug farther(pans_all_round(), course_to({{2.31, 2.0}}));
  EXPECT_EQ(simulation.run(farther), FinishReason::kComplete);
  EXPECT_EQ(simulation.drives_m.size(), 1U);
}

TEST(TangentBug, LooksAllRoundBeforeEveryMove) {
  TangentBug explorer(pans_all_round(), course_to({{3.5, 2.0}}));
  Simulation simulation;
  MotionResult last = MotionResult::kReached;
  const pipeline::Snapshot nothing = [] {
    pipeline::Snapshot snapshot;
    snapshot.last_scan = std::make_shared<const mapping::Scan>();
    return snapshot;
  }();
  EXPECT_TRUE(std::holds_alternative<BeginScan>(explorer.next(nothing, last)));
  const auto sweep = std::get<Sweep>(explorer.next(nothing, last));
  EXPECT_NEAR(degrees(sweep.to_rad - sweep.from_rad + sweep.step_rad), 360.0, 1e-9);
  EXPECT_TRUE(std::holds_alternative<EndScan>(explorer.next(nothing, last)));
  EXPECT_NEAR(std::get<Turn>(explorer.next(nothing, last)).angle_rad, 0.0, 1e-9);
  EXPECT_NEAR(std::get<Drive>(explorer.next(nothing, last)).distance_m, 0.8, 1e-9);
}

TEST(TangentBug, GoesRoundABoardOnTheSideOfTheShorterWay) {
  TangentBug explorer(pans_all_round(), course_to({{3.6, 2.0}}));
  Simulation simulation(board(1.2, 2.2));
  EXPECT_EQ(simulation.run(explorer), FinishReason::kComplete);
  ASSERT_FALSE(simulation.stops_m.empty());
  EXPECT_GT(simulation.stops_m.front().y(), 2.1);
  EXPECT_LE(explorer.phases()[0].moves, 5U);
}

TEST(TangentBug, GivesAWaypointUpAfterFiveMoves) {
  TangentBug explorer(pans_all_round(), course_to({{3.6, 2.0}, {2.0, 3.0}}));
  Simulation simulation;
  // Something that the sonar does not hear stops every drive along x.
  simulation.fate = [](const Eigen::Vector2d& end_m) {
    return end_m.x() > 2.2 ? MotionResult::kTimedOut : MotionResult::kReached;
  };
  EXPECT_EQ(simulation.run(explorer), FinishReason::kWaypointsMissed);
  EXPECT_FALSE(explorer.phases()[0].was_reached);
  EXPECT_EQ(explorer.phases()[0].moves, 5U);
  EXPECT_TRUE(explorer.phases()[1].was_reached);
}

TEST(TangentBug, IsNotBackWhereTheLastWaypointIsOutOfReach) {
  TangentBug explorer(pans_all_round(), course_to({{3.6, 2.0}}));
  Simulation simulation;
  simulation.fate = [](const Eigen::Vector2d&) { return MotionResult::kStalled; };
  EXPECT_EQ(simulation.run(explorer), FinishReason::kNotBack);
}

TEST(TangentBug, DrawsAVirtualObstacleWhereItBumpedAndGoesRoundIt) {
  TangentBug explorer(pans_all_round(), course_to({{3.0, 2.0}}));
  Simulation simulation;
  // A low block of 20 cm that the sonar does not hear.
  int bumps = 0;
  simulation.fate = [&](const Eigen::Vector2d& end_m) {
    const bool meets = simulation.place_m().x() < 2.1 && std::abs(end_m.y() - 2.0) < 0.1;
    bumps += meets ? 1 : 0;
    return meets ? MotionResult::kBumped : MotionResult::kReached;
  };
  EXPECT_EQ(simulation.run(explorer), FinishReason::kComplete);
  EXPECT_EQ(bumps, 1);
  ASSERT_GE(simulation.drives_m.size(), 3U);
  EXPECT_LT(simulation.drives_m[1], 0.0);
  const auto grid = explorer.products().confidence;
  EXPECT_GE((*grid)[grid->index(grid->cell_at({2.1, 2.0}))], 0.5F);
  EXPECT_GE((*grid)[grid->index(grid->cell_at({2.1, 2.08}))], 0.5F);
}

TEST(TangentBug, DoesNotGoIntoANarrowOpening) {
  // A gap of 10 cm in the middle of a wall, and a goal behind it.
  const std::vector<Segment> wall{{{2.6, -9.0}, {2.6, 1.95}}, {{2.6, 2.05}, {2.6, 9.0}}};
  TangentBug explorer(pans_all_round(), course_to({{3.5, 2.0}}));
  Simulation simulation(wall);
  EXPECT_EQ(simulation.run(explorer), FinishReason::kNotBack);
  for (const Eigen::Vector2d& stop_m : simulation.stops_m) {
    EXPECT_LT(stop_m.x(), 2.6);
  }
}

TEST(TangentBug, KnowsTheWallsOfItsCourseBeforeAnyEcho) {
  WaypointCourse course = course_to({{3.5, 2.0}});
  // A block of known walls: one line of ones alone is less than what is called clear.
  for (double x_m = 2.5; x_m < 2.8; x_m += 0.05) {
    course.known_walls.push_back({{x_m, 1.6}, {x_m, 2.4}});
  }
  TangentBug explorer(pans_all_round(), course);
  Simulation simulation;
  simulation.is_deaf = true;
  simulation.run(explorer, 1);
  ASSERT_EQ(simulation.stops_m.size(), 1U);
  EXPECT_GT(std::abs(simulation.stops_m[0].y() - 2.0), 0.2);
}

TEST(TangentBug, SaysSoWhereItCannotSense) {
  TangentBug explorer(pans_all_round(), course_to({{3.6, 2.0}}));
  Simulation simulation;
  simulation.sweep_result = MotionResult::kTimedOut;
  EXPECT_EQ(simulation.run(explorer), FinishReason::kCannotSense);
}

TEST(TangentBug, IsAFunctionOfWhatItWasGiven) {
  std::vector<double> first_m;
  for (int run = 0; run < 2; ++run) {
    TangentBug explorer(pans_all_round(), course_to({{3.6, 2.0}, {2.0, 2.0}}));
    Simulation simulation(board(1.5, 2.4));
    simulation.run(explorer);
    if (run == 0) {
      first_m = simulation.drives_m;
    } else {
      EXPECT_EQ(simulation.drives_m, first_m);
    }
  }
  EXPECT_GE(first_m.size(), 3U);
}

TEST(TangentBug, AsPrintedTakesNothingAwayFromItsGrid) {
  const auto confidence_after = [](const TangentBugParams& params) {
    TangentBug explorer(params, course_to({{2.6, 2.0}, {2.0, 2.0}}));
    Simulation(board(1.0, 3.0)).run(explorer);
    const auto grid = explorer.products().confidence;
    double sum = 0.0;
    for (std::size_t i = 0; i < grid->size(); ++i) {
      sum += (*grid)[i];
    }
    return sum;
  };
  EXPECT_GT(confidence_after(as_printed(pans_all_round())), confidence_after(pans_all_round()));
}

TEST(TangentBug, RefusesParametersWithoutSense) {
  const auto refused = [](auto&& change) {
    TangentBugParams params;
    change(params);
    EXPECT_THROW(TangentBug(params, course_to({{3.0, 2.0}})), std::invalid_argument);
  };
  refused([](auto& params) { params.reached_m = 0.0; });
  refused([](auto& params) { params.max_moves = 0; });
  refused([](auto& params) { params.max_move_m = 0.01; });
  refused([](auto& params) { params.sweep.step_rad = 0.0; });
  refused([](auto& params) { params.clear_sum = 0.0; });
  EXPECT_THROW(TangentBug({}, course_to({})), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::exploration
