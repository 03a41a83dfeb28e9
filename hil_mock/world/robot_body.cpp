// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_body.hpp"

#include <cmath>
#include <stdexcept>

namespace echomap::world {

/// This run's true sizes, relative to the profile's.
struct RobotBody::Errors {
  double left_diameter = 1.0;
  double right_diameter = 1.0;
  double track = 1.0;
  double left_gain = 1.0;
  double right_gain = 1.0;
};

void EncoderChanges::clear() {
  left.clear();
  right.clear();
}

RobotBody::Errors RobotBody::draw_errors(const DriveParams& drive, NoiseStream& noise) {
  Errors errors;
  const double common = drive.wheel_diameter_stddev * noise.normal();
  const double mismatch = drive.wheel_mismatch_stddev * noise.normal();
  errors.left_diameter = 1.0 + common - 0.5 * mismatch;
  errors.right_diameter = 1.0 + common + 0.5 * mismatch;
  errors.track = 1.0 + drive.track_stddev * noise.normal();
  errors.left_gain = 1.0 + drive.motor_gain_stddev * noise.normal();
  errors.right_gain = 1.0 + drive.motor_gain_stddev * noise.normal();
  return errors;
}

RobotBody::RobotBody(const FloorPlan& plan,
                     const DriveParams& drive,
                     const BodyParams& body,
                     NoiseStream noise)
    : RobotBody(plan, drive, body, draw_errors(drive, noise), noise) {}

RobotBody::RobotBody(const FloorPlan& plan,
                     const DriveParams& drive,
                     const BodyParams& body,
                     const Errors& errors,
                     NoiseStream noise)
    : plan_(plan),
      body_(body),
      slip_m_per_sqrt_m_(drive.slip_m_per_sqrt_m),
      track_m_(drive.track_m * errors.track),
      left_(drive, drive.wheel_diameter_m * errors.left_diameter, errors.left_gain),
      right_(drive, drive.wheel_diameter_m * errors.right_diameter, errors.right_gain),
      noise_(noise),
      T_world_robot_(plan.T_world_start()),
      collisions_(body) {
  const double sizes[] = {drive.wheel_diameter_m,
                          drive.track_m,
                          drive.counts_per_turn,
                          drive.no_load_speed_m_per_s,
                          drive.time_constant_s,
                          drive.coast_time_constant_s,
                          body.radius_m};
  for (const double size : sizes) {
    if (!(size > 0.0)) {
      throw std::invalid_argument("robot: every size, speed and time constant must be positive");
    }
  }
  if (plan.clearance_m(T_world_robot_.position_m()) < body.radius_m) {
    throw std::invalid_argument("start: a wall is nearer than the robot's radius");
  }
  if (hole_distance_m(plan, T_world_robot_.position_m()) < body.radius_m) {
    throw std::invalid_argument("start: a hole is nearer than the robot's radius");
  }
}

void RobotBody::step(double dt_s, const WheelDuty& duty, EncoderChanges& changes) {
  const double left_m = left_.step(dt_s, {duty.left, duty.left_coasting}, changes.left);
  const double right_m = right_.step(dt_s, {duty.right, duty.right_coasting}, changes.right);
  roll(rolling_.left * slipped(left_m), rolling_.right * slipped(right_m));
  const geometry::Pose2 T_world_out = pushed_out(plan_, T_world_robot_, body_.radius_m);
  if (!lifted_) {
    collisions_.note((T_world_robot_.inverse() * T_world_out).position_m(), dt_s);
  }
  T_world_robot_ = T_world_out;
}

void RobotBody::scale_counts(double scale) {
  left_.scale_counts(scale);
  right_.scale_counts(scale);
}

void RobotBody::place(const geometry::Pose2& T_world_robot) {
  T_world_robot_ = T_world_robot;
  lifted_ = false;
}

Contacts RobotBody::contacts() const {
  return lifted_ || !body_.has_bumpers ? Contacts{} : contacts_at(plan_, T_world_robot_, body_);
}

WheelSupport RobotBody::support() const {
  return lifted_ ? WheelSupport{false, false} : wheel_support(plan_, T_world_robot_, track_m_);
}

double RobotBody::slipped(double rolled_m) {
  return rolled_m + slip_m_per_sqrt_m_ * std::sqrt(std::abs(rolled_m)) * noise_.normal();
}

/// Both wheels on circles about one centre; the chord of the arc points half of the turn aside.
void RobotBody::roll(double left_m, double right_m) {
  const WheelSupport on_floor = support();
  if (!on_floor.left || !on_floor.right) {
    return;
  }
  const double turn_rad = (right_m - left_m) / track_m_;
  const double arc_m = 0.5 * (left_m + right_m);
  const double half_rad = 0.5 * turn_rad;
  const double chord_m = half_rad == 0.0 ? arc_m : arc_m * std::sin(half_rad) / half_rad;
  T_world_robot_ =
      T_world_robot_ *
      geometry::Pose2(chord_m * std::cos(half_rad), chord_m * std::sin(half_rad), turn_rad);
}

}  // namespace echomap::world
