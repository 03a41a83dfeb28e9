// SPDX-License-Identifier: MIT
#include "tests/support/offline_source_search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "host/models/uniform_sample.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::tests {

namespace {

using exploration::Motion;
using exploration::MotionResult;
using geometry::Pose2;
using source_search::FieldReading;
using source_search::SourceSearch;

/// Motions are carried out in pieces of at most so long: the sensor counts in between.
constexpr double kStepS = 0.25;

/// A map that is right, as a snapshot has it.
mapping::OccupancyGrid known_grid(const mapping::RasterMap& map) {
  mapping::OccupancyGrid grid({.resolution_m = map.resolution_m()});
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const bool is_solid = map.state({x, y}) == mapping::CellState::kOccupied;
      grid.add(grid.cell_at(map.center_m({x, y})), is_solid ? 300 : -300);
    }
  }
  return grid;
}

/// Speeds of a motion and how long it takes.
struct Course {
  double forward_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;
  double for_s = 0.0;
};

Course course_of(const Motion& motion, const OfflineSearch& search) {
  if (const auto* turn = std::get_if<exploration::Turn>(&motion)) {
    return {0.0,
            std::copysign(search.turn_rad_per_s, turn->angle_rad),
            std::abs(turn->angle_rad) / search.turn_rad_per_s};
  }
  if (const auto* drive = std::get_if<exploration::Drive>(&motion)) {
    const double speed_m_per_s = search.params.choice.speed_m_per_s;
    return {std::copysign(speed_m_per_s, drive->distance_m),
            0.0,
            std::abs(drive->distance_m) / speed_m_per_s};
  }
  if (const auto* roll = std::get_if<exploration::Roll>(&motion)) {
    return {roll->forward_m_per_s, roll->turn_rad_per_s, roll->for_s};
  }
  if (const auto* stand = std::get_if<exploration::Stand>(&motion)) {
    return {0.0, 0.0, stand->for_s};
  }
  return {};
}

class SearchingRobot {
 public:
  SearchingRobot(const OfflineSearch& search, const Pose2& start)
      : search_(search), strategy_(search.params), T_map_robot_(start) {}

  SourceSearch& strategy() { return strategy_; }
  double now_s() const { return now_s_; }
  double driven_m() const { return driven_m_; }

  /// One decision and what follows of it; false once it has finished.
  bool go_on(pipeline::Snapshot snapshot,
             const SourceWorld& world,
             const SourceTruth& truth,
             std::mt19937& random,
             std::vector<FieldReading>& readings) {
    snapshot.latest = pose_at(now_s_, T_map_robot_);
    const Motion motion = strategy_.next(snapshot, MotionResult::kReached);
    if (std::holds_alternative<exploration::Finished>(motion)) {
      return false;
    }
    const Course course = course_of(motion, search_);
    for (double done_s = 0.0; done_s < course.for_s;) {
      const double step_s = std::min(kStepS, course.for_s - done_s);
      move(course, step_s);
      count(world.rate(truth, T_map_robot_.position_m(), standoff_m()), step_s, random, readings);
      done_s += step_s;
    }
    return true;
  }

 private:
  double standoff_m() const { return search_.params.belief.grid.field.standoff_m; }

  void move(const Course& course, double step_s) {
    const double turned_rad = course.turn_rad_per_s * step_s;
    const double driven_m = course.forward_m_per_s * step_s;
    T_map_robot_ = T_map_robot_ * Pose2(0.0, 0.0, 0.5 * turned_rad) * Pose2(driven_m, 0.0, 0.0) *
                   Pose2(0.0, 0.0, 0.5 * turned_rad);
    driven_m_ += std::abs(driven_m);
    now_s_ += step_s;
  }

  void count(double rate,
             double step_s,
             std::mt19937& random,
             std::vector<FieldReading>& readings) {
    if (counting_.dwell_s == 0.0) {
      first_m_ = T_map_robot_.position_m();
    }
    counting_.value += sample_poisson(rate * step_s, random);
    counting_.at_m += step_s * T_map_robot_.position_m();
    counting_.dwell_s += step_s;
    const double moved_m = (T_map_robot_.position_m() - first_m_).norm();
    if (counting_.dwell_s >= search_.reading_s - 1e-9 || moved_m >= search_.reading_m - 1e-9) {
      counting_.at_m /= counting_.dwell_s;
      readings.push_back(counting_);
      counting_ = {};
    }
  }

  const OfflineSearch& search_;
  SourceSearch strategy_;
  Pose2 T_map_robot_;
  FieldReading counting_;
  Eigen::Vector2d first_m_ = Eigen::Vector2d::Zero();  ///< Where that has begun.
  double now_s_ = 0.0;
  double driven_m_ = 0.0;
};

std::vector<source_search::PlannedDwell> plans_but(
    std::vector<std::unique_ptr<SearchingRobot>>& robots, const SearchingRobot* own) {
  std::vector<source_search::PlannedDwell> plans;
  for (const auto& robot : robots) {
    if (robot.get() != own) {
      const auto& plan = robot->strategy().plan();
      plans.insert(plans.end(), plan.begin(), plan.end());
    }
  }
  return plans;
}

OfflineSearchRun result_of(SearchingRobot& robot, const SourceTruth& truth, double found_radius_m) {
  OfflineSearchRun run;
  run.time_s = robot.now_s();
  run.estimate = robot.strategy().belief()->estimate();
  const bool is_none = run.estimate.verdict == source_search::SourceVerdict::kNone;
  if (truth.at_m) {
    run.error_m = (run.estimate.best_m - *truth.at_m).norm();
    run.is_right = run.estimate.verdict == source_search::SourceVerdict::kFound &&
                   run.error_m <= found_radius_m;
  } else {
    run.is_right = is_none;
  }
  return run;
}

}  // namespace

OfflineSearchRun search_offline(const SourceWorld& world,
                                const SourceTruth& truth,
                                const OfflineSearch& search) {
  std::mt19937 random(search.seed);
  const pipeline::Snapshot snapshot = snapshot_of(known_grid(world.map()));
  std::vector<std::unique_ptr<SearchingRobot>> robots;
  for (const Pose2& start : search.starts) {
    robots.push_back(std::make_unique<SearchingRobot>(search, start));
  }
  std::vector<FieldReading> readings;
  for (;;) {
    const auto next =
        std::min_element(robots.begin(), robots.end(), [](const auto& one, const auto& other) {
          return one->now_s() < other->now_s();
        });
    SearchingRobot& robot = **next;
    robot.strategy().set_readings(readings);
    robot.strategy().set_plans_of_others(plans_but(robots, &robot));
    if (!robot.go_on(snapshot, world, truth, random, readings) || robot.now_s() > search.max_s) {
      OfflineSearchRun run = result_of(robot, truth, search.params.belief.found_radius_m);
      run.readings = readings.size();
      for (const auto& each : robots) {
        run.driven_m += each->driven_m();
      }
      return run;
    }
  }
}

std::vector<Pose2> sample_starts(const SourceWorld& world,
                                 std::size_t robots,
                                 double apart_m,
                                 std::mt19937& random) {
  std::vector<Pose2> starts;
  while (starts.size() < robots) {
    const Eigen::Vector2d at_m = world.sample_free(0.25, random);
    const double heading_rad = (2.0 * models::uniform_sample(random) - 1.0) * std::numbers::pi;
    if (std::all_of(starts.begin(), starts.end(), [&](const Pose2& other) {
          return (other.position_m() - at_m).norm() >= apart_m;
        })) {
      starts.emplace_back(at_m.x(), at_m.y(), heading_rad);
    }
  }
  return starts;
}

}  // namespace echomap::tests
