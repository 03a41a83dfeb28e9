// SPDX-License-Identifier: MIT
#include "host/exploration/tangent_bug.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::exploration {

namespace {

using geometry::Pose2;

void validate(const TangentBugParams& params) {
  geometry::ParameterValidator("tangent-bug")
      .positive("reached_m", params.reached_m)
      .positive("min_move_m", params.min_move_m)
      .at_least("max_move_m", params.max_move_m, params.min_move_m)
      .positive("jump_m", params.jump_m)
      .at_least("before_m", params.before_m, 0.0)
      .positive("max_m", params.max_m)
      .at_least("side_clearance_m", params.side_clearance_m, 0.0)
      .positive("robot_radius_m", params.robot_radius_m)
      .at_least("back_off_m", params.back_off_m, 0.0)
      .at_least("clear_margin_m", params.clear_margin_m, 0.0)
      .require(is_possible(params.sweep), "the sweep is impossible: check its range and its steps")
      .positive("max_moves", params.max_moves)
      .positive("half_view_rad", params.half_view_rad)
      .positive("boundary_step_rad", params.boundary_step_rad)
      .positive("clear_sum", params.clear_sum)
      .at_least("clear_half_angle_share", params.clear_half_angle_share, 0.0)
      .positive("beam_half_angle_rad", params.beam_half_angle_rad);
}

mapping::PatchGrid grid_of(const WaypointCourse& course, const TangentBugParams& params) {
  mapping::PatchGrid grid({course.cells, course.cell_m, params.patch});
  for (const geometry::Segment& wall : course.known_walls) {
    grid.mark_wall(wall);
  }
  return grid;
}

double bearing_rad(const Eigen::Vector2d& offset_m) {
  return std::atan2(offset_m.y(), offset_m.x());
}

/// A way of that length at most.
Eigen::Vector2d at_most_m(const Eigen::Vector2d& offset_m, double length_m) {
  return offset_m.norm() > length_m ? Eigen::Vector2d(offset_m.normalized() * length_m) : offset_m;
}

}  // namespace

TangentBugParams as_printed(TangentBugParams params) {
  params.clear_half_angle_share = 0.0;
  params.clear_sum = 80.0;
  return params;
}

TangentBug::TangentBug(const TangentBugParams& params, WaypointCourse course)
    : params_(params),
      course_(std::move(course)),
      grid_(grid_of(course_, params)),
      odometry_(params.heading),
      T_course_robot_(course_.T_course_start) {
  validate(params_);
  if (course_.waypoints.empty()) {
    throw std::invalid_argument("tangent-bug: the course has no waypoint");
  }
  for (const Waypoint& waypoint : course_.waypoints) {
    phases_.push_back({waypoint.name});
  }
}

Motion TangentBug::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  const auto yaw = snapshot.yaw ? std::optional(snapshot.yaw->yaw) : std::nullopt;
  T_course_robot_ = course_.T_course_start * odometry_.update(snapshot.T_odom_robot, yaw);
  note(last);
  if (plan_.empty()) {
    if (activity_ == Activity::kSensing) {
      add_echoes(snapshot);
      plan_move(snapshot);
    } else {
      plan_sensing(snapshot);
    }
  }
  Motion motion = plan_.front();
  plan_.pop_front();
  sweeping_ = std::holds_alternative<Sweep>(motion);
  return motion;
}

StrategyProducts TangentBug::products() const {
  StrategyProducts products;
  products.confidence = std::make_shared<const mapping::CellField>(grid_.confidence());
  products.phases = phases_.size();
  products.phases_reached = static_cast<std::size_t>(std::count_if(
      phases_.begin(), phases_.end(), [](const auto& phase) { return phase.was_reached; }));
  return products;
}

/// "When the bump sensor is initiated, a virtual obstacle is mapped" (section II.B). Then, and
/// where the wheels stuck, the robot backs off and looks again. So it does where a person had it.
void TangentBug::note(MotionResult last) {
  if (last == MotionResult::kTakenOver) {
    plan_.clear();
    activity_ = Activity::kMoving;
    return;
  }
  sweeps_done_ += sweeping_ && last == MotionResult::kReached ? 1 : 0;
  if (activity_ != Activity::kMoving || last == MotionResult::kReached) {
    return;
  }
  plan_.clear();
  if (last == MotionResult::kBumped || last == MotionResult::kHazard) {
    const auto line = models::bumper_line(params_.robot_radius_m, 2.0 * params_.robot_radius_m);
    grid_.add_bump({T_course_robot_ * line.from_m, T_course_robot_ * line.to_m});
  }
  if (last != MotionResult::kInterrupted) {
    activity_ = Activity::kBackingOff;
    plan_ = {Drive{-params_.back_off_m}};
  }
}

void TangentBug::plan_sensing(const pipeline::Snapshot& snapshot) {
  activity_ = Activity::kSensing;
  sweeps_done_ = 0;
  pass_reached();
  if (has_waypoint()) {
    plan_ = round_sweep(params_.sweep, snapshot.latest.T_map_robot.heading_rad() > 0.0);
  } else {
    plan_ = {Finished{outcome()}};
  }
}

void TangentBug::add_echoes(const pipeline::Snapshot& snapshot) {
  const Pose2 T_course_map = T_course_robot_ * snapshot.latest.T_map_robot.inverse();
  for (const mapping::PlacedReading& reading : *snapshot.last_scan) {
    if (reading.range_m) {
      grid_.add_echo(T_course_map * reading.T_map_sonar, *reading.range_m);
    }
  }
  const double clear_rad = params_.clear_half_angle_share * params_.beam_half_angle_rad;
  for (const mapping::PlacedReading& reading : *snapshot.last_scan) {
    if (reading.range_m && clear_rad > 0.0) {
      grid_.clear_cone(
          T_course_map * reading.T_map_sonar, *reading.range_m - params_.clear_margin_m, clear_rad);
    }
  }
}

/// Waypoint by waypoint until one has a way towards it: where there is none, or it has had its
/// moves, the next one (section II.E).
void TangentBug::plan_move(const pipeline::Snapshot& snapshot) {
  activity_ = Activity::kMoving;
  if (sweeps_done_ == 0) {
    plan_ = {Finished{FinishReason::kCannotSense}};
    return;
  }
  for (; has_waypoint(); ++current_, followed_side_ = 0, pass_reached()) {
    PhaseReport& phase = phases_[current_];
    if (phase.moves == params_.max_moves) {
      continue;
    }
    auto offset_m = choose_offset_m(snapshot);
    if (offset_m) {
      trail_m_.push_back(T_course_robot_.position_m());
    } else if (current_ + 1 == phases_.size()) {
      offset_m = offset_out_m();
    }
    if (offset_m) {
      ++phase.moves;
      plan_ = {Turn{geometry::angle_between(T_course_robot_.heading_rad(), bearing_rad(*offset_m))},
               Drive{offset_m->norm()}};
      return;
    }
  }
  plan_ = {Finished{outcome()}};
}

void TangentBug::pass_reached() {
  while (has_waypoint() &&
         (course_.waypoints[current_].position_m - T_course_robot_.position_m()).norm() <=
             params_.reached_m) {
    phases_[current_].was_reached = true;
    followed_side_ = 0;
    ++current_;
  }
}

FinishReason TangentBug::outcome() const {
  if (!phases_.back().was_reached) {
    return FinishReason::kNotBack;
  }
  const bool all = std::all_of(
      phases_.begin(), phases_.end(), [](const PhaseReport& phase) { return phase.was_reached; });
  return all ? FinishReason::kComplete : FinishReason::kWaypointsMissed;
}

/// "If there is no obstacle ahead then it heads for the goal directly otherwise it uses the tangent
/// Bug algorithm" (section II.B).
std::optional<Eigen::Vector2d> TangentBug::choose_offset_m(const pipeline::Snapshot& snapshot) {
  const Eigen::Vector2d goal_m =
      course_.waypoints[current_].position_m - T_course_robot_.position_m();
  const Eigen::Vector2d straight_m = at_most_m(goal_m, params_.max_move_m);
  if (is_clear(straight_m)) {
    followed_side_ = 0;
    return straight_m;
  }
  if (auto offset_m = offset_past_obstacle_m(snapshot, goal_m)) {
    followed_side_ = 0;
    return offset_m;
  }
  return way_along_boundary_m(goal_m);
}

/// The clear point before a discontinuity with the shortest way over it to the goal: the heuristic
/// distance of Kamon, Rimon and Rivlin. Narrow openings do not count (section II.E).
std::optional<Eigen::Vector2d> TangentBug::offset_past_obstacle_m(
    const pipeline::Snapshot& snapshot, const Eigen::Vector2d& goal_m) const {
  const Pose2& T_map_robot = snapshot.latest.T_map_robot;
  const double goal_bearing_rad = bearing_rad(goal_m);
  const double in_map_rad =
      goal_bearing_rad - T_course_robot_.heading_rad() + T_map_robot.heading_rad();
  const auto view = front_view(
      *snapshot.last_scan, T_map_robot, in_map_rad, params_.half_view_rad, params_.max_m);
  std::optional<Eigen::Vector2d> best_m;
  double shortest_m = std::numeric_limits<double>::infinity();
  for (const Discontinuity& torn : discontinuities(view, params_.jump_m)) {
    const double along_rad = goal_bearing_rad + torn.near.bearing_rad;
    const double before_m = torn.near.range_m - params_.before_m;
    const bool is_narrow = torn.width_m < 2.0 * params_.robot_radius_m + params_.narrow_clearance_m;
    if (is_narrow || before_m < params_.min_move_m) {
      continue;
    }
    const Eigen::Vector2d offset_m =
        std::min(before_m, params_.max_move_m) * geometry::unit_vector(along_rad);
    const double length_m = offset_m.norm() + (goal_m - offset_m).norm();
    if (length_m < shortest_m && is_clear(offset_m)) {
      shortest_m = length_m;
      best_m = offset_m;
    }
  }
  return best_m;
}

/// The boundary following of Kamon, Rimon and Rivlin as far as a view of 180 degrees has it: the
/// clear way nearest to that of the goal, on the side that was taken before.
std::optional<Eigen::Vector2d> TangentBug::way_along_boundary_m(const Eigen::Vector2d& goal_m) {
  const auto steps = static_cast<int>(params_.half_view_rad / params_.boundary_step_rad + 1e-9);
  const double length_m = std::min(params_.max_move_m, goal_m.norm());
  const auto offset_to = [&](int side, int step) -> Eigen::Vector2d {
    return length_m *
           geometry::unit_vector(bearing_rad(goal_m) + side * step * params_.boundary_step_rad);
  };
  const auto clear_side = [&](int pass, int step) {
    for (const int side : {1, -1}) {
      const bool is_turn_of_side = followed_side_ == 0 || (side == followed_side_) == (pass == 0);
      if (is_turn_of_side && is_clear(offset_to(side, step))) {
        return side;
      }
    }
    return 0;
  };
  for (int pass = 0; pass < 2; ++pass) {
    for (int step = 1; step <= steps; ++step) {
      if (const int side = clear_side(pass, step); side != 0) {
        followed_side_ = side;
        return offset_to(side, step);
      }
    }
  }
  return std::nullopt;
}

/// Out of a dead end: back to the stop before. The paper's danger checker warns of one; it counts
/// for the last waypoint only, as there is no next one to go on to.
std::optional<Eigen::Vector2d> TangentBug::offset_out_m() {
  if (trail_m_.empty()) {
    return std::nullopt;
  }
  const Eigen::Vector2d offset_m = trail_m_.back() - T_course_robot_.position_m();
  trail_m_.pop_back();
  return offset_m.norm() < params_.min_move_m ? offset_out_m() : std::optional(offset_m);
}

/// "The occupancy grid is used to sum up values of the coordinates that fall in the region of the
/// rectangle" (section II.D, figure 3).
bool TangentBug::is_clear(const Eigen::Vector2d& offset_m) const {
  const Eigen::Vector2d here_m = T_course_robot_.position_m();
  const Pose2 T_course_offset(here_m.x(), here_m.y(), bearing_rad(offset_m));
  const double body_m = params_.robot_radius_m;
  return grid_.sum_ahead(T_course_offset,
                         body_m,
                         body_m + offset_m.norm(),
                         2.0 * (body_m + params_.side_clearance_m)) < params_.clear_sum;
}

}  // namespace echomap::exploration
