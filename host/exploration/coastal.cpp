// SPDX-License-Identifier: MIT
#include "host/exploration/coastal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/exploration/loop_closure.hpp"
#include "host/exploration/wall_outline.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

namespace {

/// From something that stands in the room: not back on the way by which the robot came.
constexpr double kLeaveRad = 2.0;
/// A corner that is passed again looks no farther away than this, by odometry.
constexpr double kSameCornerM = 0.8;

void validate(const CoastalParams& params) {
  geometry::ParameterValidator("coastal")
      .positive("tick_s", params.tick_s)
      .positive("speed_m_per_s", params.speed_m_per_s)
      .positive("spin_rad", params.spin_rad)
      .positive("spin_rad_per_s", params.spin_rad_per_s)
      .positive("arc_radius_m", params.arc_radius_m)
      .positive("robot_radius_m", params.robot_radius_m)
      .at_least("min_gap_m", params.min_gap_m, 0.0)
      .at_least("wall_m", params.wall_m, 0.0)
      .at_least("max_overlap_m", params.max_overlap_m, 0.0)
      .positive("max_distance_m", params.max_distance_m);
}

CoastalParams right_handed(CoastalParams params) {
  validate(params);
  if (params.hand == Hand::kLeft) {
    params.T_robot_sensor = mirrored(params.T_robot_sensor);
  }
  const double heading_rad = params.T_robot_sensor.heading_rad();
  if (std::isnan(heading_rad) || heading_rad >= 0.0 || heading_rad <= -std::numbers::pi) {
    throw std::invalid_argument("coastal: the wall sensor looks to the other side");
  }
  return params;
}

/// What the sensor measures where the hull, parallel to the wall, is so near to it as it may be.
double min_range_m(const CoastalParams& params) {
  const geometry::Pose2& sensor = params.T_robot_sensor;
  return (params.robot_radius_m + params.min_gap_m + sensor.y_m()) /
         -std::sin(sensor.heading_rad());
}

}  // namespace

Coastal::Coastal(const CoastalParams& params)
    : params_(right_handed(params)),
      min_range_m_(min_range_m(params_)),
      walk_(params.correction),
      corners_(params.corners),
      traversal_(params.traversal) {}

Motion Coastal::next(const pipeline::Snapshot& snapshot, MotionResult /*last*/) {
  const bool is_left = params_.hand == Hand::kLeft;
  const geometry::Pose2& pose = snapshot.latest.T_map_robot;
  walk_.follow(is_left ? mirrored(pose) : pose);
  const WallContact contact = contact_of(snapshot);
  if (!found_ && (contact.bumped || contact.wall_beside)) {
    begin_walk();
  }
  if (const auto reason = found_ ? reason_to_finish(contact) : std::nullopt) {
    return Finished{*reason};
  }
  const Roll roll =
      found_ ? follow_wall(contact) : Roll{params_.speed_m_per_s, 0.0, params_.tick_s};
  return is_left ? mirrored(roll) : roll;
}

WallContact Coastal::contact_of(const pipeline::Snapshot& snapshot) const {
  const auto& ranges_m = snapshot.infrared.range_m;
  const auto index = params_.sensor_index;
  return {snapshot.hazards.is_touching(),
          snapshot.hazards.virtual_wall,
          snapshot.hazards.wall,
          index < ranges_m.size() ? ranges_m[index] : std::nullopt};
}

void Coastal::begin_walk() {
  found_ = true;
  walk_.begin();
  corners_ = CornerWatch(params_.corners);
  traversal_ = TraversalWatch(params_.traversal);
}

/// Algorithm Follow_wall, lines 6 to 15.
Roll Coastal::follow_wall(const WallContact& contact) {
  const double arc_rad_per_s = params_.speed_m_per_s / params_.arc_radius_m;
  if (traversal_.state() == Traversal::kRoundIsland) {
    ++islands_;
    found_ = false;
    return {0.0, params_.spin_rad_per_s, kLeaveRad / params_.spin_rad_per_s};
  }
  if (contact.bumped) {
    return {0.0, params_.spin_rad_per_s, params_.spin_rad / params_.spin_rad_per_s};
  }
  if (!contact.wall_beside) {
    return {params_.speed_m_per_s, -arc_rad_per_s, params_.tick_s};
  }
  if (contact.range_m && *contact.range_m < min_range_m_) {
    return {params_.speed_m_per_s, arc_rad_per_s, params_.tick_s};
  }
  return {params_.speed_m_per_s, 0.0, params_.tick_s};
}

std::optional<FinishReason> Coastal::reason_to_finish(const WallContact& contact) {
  const WallStep& step = walk_.add(contact);
  corners_.add(step);
  traversal_.add(step);
  if (is_round(step)) {
    return FinishReason::kComplete;
  }
  return step.travelled_m > params_.max_distance_m || islands_ > params_.max_islands
             ? std::optional(FinishReason::kNowhereToGo)
             : std::nullopt;
}

bool Coastal::is_round(const WallStep& step) const {
  if (params_.rule == TraversalRule::kAngleAboutStart) {
    return traversal_.covered_rad() >= geometry::kFullTurnRad;
  }
  if (traversal_.state() != Traversal::kRoundRoom) {
    return false;
  }
  const double behind_m = step.travelled_m - traversal_.round_m();
  const CornerMark* known = corner_behind_a_wall();
  if (known == nullptr) {
    return behind_m > params_.traversal.reach_m;
  }
  const CornerMark* again = passed_again(*known);
  return behind_m > params_.max_overlap_m ||
         (again != nullptr && step.travelled_m > again->travelled_m + params_.wall_m);
}

const CornerMark* Coastal::corner_behind_a_wall() const {
  double last_m = 0.0;
  for (const CornerMark& mark : corners_.marks()) {
    if (mark.travelled_m - last_m > params_.wall_m) {
      return &mark;
    }
    last_m = mark.travelled_m;
  }
  return nullptr;
}

const CornerMark* Coastal::passed_again(const CornerMark& known) const {
  const auto& marks = corners_.marks();
  const auto again = std::find_if(marks.begin(), marks.end(), [&](const CornerMark& mark) {
    return mark.travelled_m > traversal_.round_m() && mark.kind == known.kind &&
           (mark.robot_m - known.robot_m).norm() < kSameCornerM;
  });
  return again == marks.end() ? nullptr : &*again;
}

StrategyProducts Coastal::products() const {
  StrategyProducts products;
  if (traversal_.state() != Traversal::kRoundRoom) {
    return products;
  }
  const double round_m = traversal_.round_m();
  const CornerMark* known = corner_behind_a_wall();
  const bool is_seen_twice = known != nullptr && passed_again(*known) != nullptr;
  products.outline_m = wall_outline(
      is_seen_twice ? closed_walk(walk_.steps(), round_m, params_.T_robot_sensor) : walk_.steps(),
      round_m,
      params_.T_robot_sensor);
  if (params_.hand == Hand::kLeft) {
    for (Eigen::Vector2d& corner_m : products.outline_m) {
      corner_m.y() = -corner_m.y();
    }
    std::reverse(products.outline_m.begin(), products.outline_m.end());
  }
  return products;
}

}  // namespace echomap::exploration
