// SPDX-License-Identifier: MIT
#include "host/exploration/epuck_drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

namespace {

void validate(const EpuckDriveParams& params) {
  geometry::ParameterValidator("epuck")
      .positive("known_wall_m", params.known_wall_m)
      .positive("leave_m", params.leave_m)
      .positive("astray_m", params.astray_m)
      .positive("turn_per_rad", params.turn_per_rad)
      .positive("max_off_rad", params.max_off_rad)
      .positive("max_walls", params.max_walls)
      .positive("max_s", params.max_s);
}

/// The place of a way that is nearest to another place.
Eigen::Vector2d nearest_of_m(const geometry::Polygon& travelled_m, const Eigen::Vector2d& place_m) {
  return *std::min_element(
      travelled_m.begin(), travelled_m.end(), [&](const auto& a, const auto& b) {
        return (a - place_m).squaredNorm() < (b - place_m).squaredNorm();
      });
}

}  // namespace

EpuckDrive::EpuckDrive(const EpuckDriveParams& params)
    : params_(params),
      follower_(params.follower),
      ground_(params.reach_m, params.cell_m),
      traversal_(params.traversal) {
  validate(params);
}

Motion EpuckDrive::next(const pipeline::Snapshot& snapshot, MotionResult /*last*/) {
  begin_ = begin_.value_or(snapshot.latest.stamp);
  walk_.follow(snapshot.latest.T_map_robot);
  ground_.cover(walk_.T_map_robot().position_m());
  const InfraredRanges ranges_m = snapshot.infrared.range_m;
  look(ranges_m);
  if (phase_ == Phase::kAcross && !choose_goal()) {
    return Finished{FinishReason::kComplete};
  }
  const std::chrono::duration<double> driven = snapshot.latest.stamp - *begin_;
  if (driven.count() > params_.max_s) {
    return Finished{FinishReason::kNowhereToGo};
  }
  switch (phase_) {
    case Phase::kFirstWall:
      return faces_left_ ? follower_.spin()
                         : Roll{params_.follower.speed_m_per_s, 0.0, params_.follower.tick_s};
    case Phase::kAcross:
      return faces_left_ ? follower_.spin() : go_to_goal();
    default:
      return follower_.follow(ranges_m);
  }
}

void EpuckDrive::look(InfraredRanges ranges_m) {
  if (phase_ == Phase::kFirstWall || phase_ == Phase::kAcross) {
    look_for_wall(ranges_m);
    return;
  }
  const WallStep& step = walk_.add({false, false, follower_.beside_m(ranges_m).has_value(), {}});
  traversal_.add(step);
  const bool is_round = traversal_.state() != Traversal::kUnderway;
  unknown_until_m_ = is_at_known_wall() ? unknown_until_m_ : step.travelled_m;
  if (phase_ == Phase::kRound && is_round) {
    come_round();
  } else if (phase_ == Phase::kRound && step.travelled_m > unknown_until_m_ + params_.astray_m) {
    phase_ = Phase::kAcross;
  } else if (phase_ == Phase::kAlong) {
    const double away_m = (step.T_map_robot.position_m() - leave_at_m_).norm();
    walls_met_ = is_round ? params_.max_walls : walls_met_;
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): it goes along walls to a goal only
    const bool is_covered = ground_.is_covered(*goal_m_);
    phase_ = is_round || away_m < params_.leave_m || is_covered ? Phase::kAcross : phase_;
  }
}

/// A wall on the left comes to lie on the right by a spin through it.
void EpuckDrive::look_for_wall(InfraredRanges ranges_m) {
  if (turns_on_the_spot() && !faces_left_) {
    return;
  }
  if (follower_.is_blocked(ranges_m) || (!faces_left_ && follower_.grazes_right(ranges_m))) {
    meet_wall();
  } else if (follower_.grazes_left(ranges_m)) {
    faces_left_ = true;
  }
}

/// A wall that is known is followed to where it is nearest to the goal, an unknown one all round.
void EpuckDrive::meet_wall() {
  const Eigen::Vector2d& here_m = walk_.T_map_robot().position_m();
  follower_.forget();
  faces_left_ = false;
  walk_.begin();
  ++walls_met_;
  phase_ = Phase::kRound;
  traversal_ = TraversalWatch(params_.traversal);
  unknown_until_m_ = 0.0;
  for (const WallLoop& loop : ground_.loops()) {
    if (goal_m_ && geometry::distance_to_sides_m(loop.path_m, here_m) < params_.known_wall_m) {
      phase_ = Phase::kAlong;
      leave_at_m_ = nearest_of_m(loop.path_m, *goal_m_);
    }
  }
}

bool EpuckDrive::is_at_known_wall() const {
  const Eigen::Vector2d& here_m = walk_.T_map_robot().position_m();
  const auto& loops = ground_.loops();
  return std::any_of(loops.begin(), loops.end(), [&](const WallLoop& loop) {
    return geometry::distance_to_sides_m(loop.path_m, here_m) < params_.known_wall_m;
  });
}

void EpuckDrive::come_round() {
  WallLoop loop;
  loop.is_island = traversal_.state() == Traversal::kRoundIsland;
  for (const WallStep& step : walk_.steps()) {
    loop.path_m.push_back(step.T_map_robot.position_m());
  }
  ground_.add(std::move(loop));
  phase_ = Phase::kAcross;
  goal_m_.reset();
}

bool EpuckDrive::choose_goal() {
  if (goal_m_ && walls_met_ >= params_.max_walls) {
    ground_.give_up(*goal_m_);
    goal_m_.reset();
  }
  if (!goal_m_ || ground_.is_covered(*goal_m_)) {
    goal_m_ = ground_.nearest_left_m(walk_.T_map_robot().position_m());
    walls_met_ = 0;
  }
  return goal_m_.has_value();
}

double EpuckDrive::off_goal_rad() const {
  const geometry::Pose2& pose = walk_.T_map_robot();
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): callers have a goal
  const Eigen::Vector2d offset_m = *goal_m_ - pose.position_m();
  return geometry::angle_between(pose.heading_rad(), std::atan2(offset_m.y(), offset_m.x()));
}

bool EpuckDrive::turns_on_the_spot() const {
  return goal_m_ && std::abs(off_goal_rad()) > params_.max_off_rad;
}

Roll EpuckDrive::go_to_goal() const {
  const auto& follower = params_.follower;
  const double off_rad = off_goal_rad();
  if (turns_on_the_spot()) {
    return {0.0, std::copysign(follower.spin_rad_per_s, off_rad), follower.tick_s};
  }
  return {follower.speed_m_per_s, params_.turn_per_rad * off_rad, follower.tick_s};
}

}  // namespace echomap::exploration
