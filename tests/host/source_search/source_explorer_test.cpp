// SPDX-License-Identifier: MIT
#include "host/source_search/source_explorer.hpp"

#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <variant>

#include <gtest/gtest.h>

#include "tests/support/source_world.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::source_search {
namespace {

using exploration::Finished;
using exploration::FinishReason;
using exploration::Motion;
using exploration::MotionResult;
using geometry::Pose2;

/// An empty room of 6 x 4 m in a map that is whole.
mapping::OccupancyGrid known_room() {
  mapping::OccupancyGrid grid;
  const double resolution_m = grid.resolution_m();
  const int columns = static_cast<int>(std::lround(6.0 / resolution_m));
  const int rows = static_cast<int>(std::lround(4.0 / resolution_m));
  for (int i = 0; i < columns * rows; ++i) {
    const int x = i % columns;
    const int y = i / columns;
    const bool is_wall = x == 0 || y == 0 || x == columns - 1 || y == rows - 1;
    grid.add({x, y}, is_wall ? 300 : -300);
  }
  return grid;
}

SourceSearchParams in_a_known_room() {
  SourceSearchParams params;
  params.explores = false;
  params.frontier.navigator.follower.speed_m_per_s = 0.2;
  return params;
}

/// Carries out motions ideally, and counts pulses on the way.
class IdealRobot {
 public:
  IdealRobot(const Eigen::Vector2d& source_m, double strength)
      : source_m_(source_m), strength_(strength) {}

  SourceReadings& readings() { return readings_; }
  pipeline::Snapshot snapshot() const { return tests::snapshot_of(known_room(), trajectory_); }

  void move(const Motion& motion) {
    if (const auto* turn = std::get_if<exploration::Turn>(&motion)) {
      go(0.0, turn->angle_rad, 1.0);
    } else if (const auto* drive = std::get_if<exploration::Drive>(&motion)) {
      go(drive->distance_m, 0.0, std::abs(drive->distance_m) / 0.2);
    } else if (const auto* roll = std::get_if<exploration::Roll>(&motion)) {
      go(roll->forward_m_per_s * roll->for_s, roll->turn_rad_per_s * roll->for_s, roll->for_s);
    } else if (const auto* stand = std::get_if<exploration::Stand>(&motion)) {
      go(0.0, 0.0, stand->for_s);
    }
  }

 private:
  void go(double distance_m, double angle_rad, double for_s) {
    const int steps = std::max(1, static_cast<int>(std::ceil(for_s / 0.1)));
    for (int i = 0; i < steps; ++i) {
      const Pose2 last = trajectory_.back().T_map_robot;
      now_s_ += for_s / steps;
      trajectory_.push_back(
          tests::pose_at(now_s_, last * Pose2(distance_m / steps, 0.0, angle_rad / steps)));
      const double distance2_m2 =
          (trajectory_.back().T_map_robot.position_m() - source_m_).squaredNorm();
      const double rate = 0.4 + strength_ / (distance2_m2 + 0.01);
      readings_.on_scalar({trajectory_.back().stamp,
                           {},
                           tests::sample_poisson(rate * for_s / steps, random_),
                           for_s / steps});
    }
  }

  Eigen::Vector2d source_m_;
  double strength_;
  double now_s_ = 0.0;
  std::mt19937 random_{1};
  std::vector<pipeline::StampedPose> trajectory_{tests::pose_at(0.0, Pose2(0.6, 0.6, 0.0))};
  SourceReadings readings_{SourceReadingsParams()};
};

FinishReason search(IdealRobot& robot, SourceExplorer& explorer) {
  for (int i = 0; i < 20000; ++i) {
    const Motion motion = explorer.next(robot.snapshot(), MotionResult::kReached);
    if (const auto* finished = std::get_if<Finished>(&motion)) {
      return finished->reason;
    }
    robot.move(motion);
  }
  return FinishReason::kStuck;
}

TEST(SourceExplorer, FindsASourceByWhatTheRobotReads) {
  const Eigen::Vector2d source_m(4.8, 3.0);
  IdealRobot robot(source_m, 10.0);
  const auto found = std::make_shared<SourceSearch>(in_a_known_room());
  SourceExplorer explorer(found, robot.readings());
  EXPECT_EQ(search(robot, explorer), FinishReason::kComplete);
  const SourceEstimate& estimate = found->belief()->estimate();
  EXPECT_EQ(estimate.verdict, SourceVerdict::kFound);
  EXPECT_LT((estimate.best_m - source_m).norm(), 0.2);
}

TEST(SourceExplorer, EndsWhenItsTimeIsOver) {
  IdealRobot robot({4.8, 3.0}, 0.0);
  const auto unsure = std::make_shared<SourceSearch>(in_a_known_room());
  SourceExplorer explorer(unsure, robot.readings(), 5.0);
  EXPECT_EQ(search(robot, explorer), FinishReason::kStopLimit);
  EXPECT_EQ(unsure->belief()->estimate().verdict, SourceVerdict::kUndecided);
  EXPECT_GT(robot.readings().elapsed_s(), 5.0);
}

TEST(SourceExplorer, RefusesNoTime) {
  const SourceReadings readings({});
  EXPECT_THROW(SourceExplorer(std::make_shared<SourceSearch>(in_a_known_room()), readings, 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::source_search
