// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_ekf.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/sensors/odometry.hpp"

namespace echomap::pipeline {
namespace {

using localization::EkfOutcome;

double seconds_of(time::RobotTime stamp) {
  return std::chrono::duration<double>(stamp.time_since_epoch()).count();
}

}  // namespace

RobotEkf::RobotEkf(const sensors::RobotGeometry& robot, const RobotEkfParams& params)
    : robot_(robot), params_(params), heading_(params.heading) {
  geometry::ParameterValidator("robot ekf")
      .positive("max_gated", params.max_gated)
      .positive("start_stddev_m", params.start_stddev_m)
      .positive("start_stddev_rad", params.start_stddev_rad);
}

void RobotEkf::start_at(const localization::PoseGaussian& start) {
  ekf_.emplace(start, params_.ekf);
  gated_in_a_row_ = 0;
}

EkfOutcome RobotEkf::add(const localization::PoseFix& fix) {
  if (is_lifted_ || localization::fault_of(fix)) {
    ++refused_;
    return EkfOutcome::kNotFinite;
  }
  if (landed_ && fix.stamp_s < seconds_of(*landed_)) {
    ++refused_;
    return EkfOutcome::kTooOld;
  }
  return ekf_ && stamp_ && fix.stamp_s > seconds_of(*stamp_) ? hold(fix) : apply(fix);
}

EkfOutcome RobotEkf::hold(const localization::PoseFix& fix) {
  if (held_.size() >= params_.ekf.max_held) {
    ++refused_;
    return EkfOutcome::kTooManyHeld;
  }
  held_.push_back(fix);
  return EkfOutcome::kHeld;
}

void RobotEkf::add_held() {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): odometry came before
  const double now_s = seconds_of(*stamp_);
  const auto due = std::stable_partition(
      held_.begin(), held_.end(), [&](const auto& fix) { return fix.stamp_s > now_s; });
  const std::vector<localization::PoseFix> fixes(due, held_.end());
  held_.erase(due, held_.end());
  for (const localization::PoseFix& fix : fixes) {
    apply(fix);
  }
}

/// Of the past, so that what becomes of it is known at once.
EkfOutcome RobotEkf::apply(const localization::PoseFix& fix) {
  if (!ekf_) {
    start_from(fix);
    return EkfOutcome::kApplied;
  }
  const EkfOutcome outcome = ekf_->update(fix);
  if (outcome == EkfOutcome::kApplied) {
    ++applied_;
    gated_in_a_row_ = 0;
  } else if (outcome != EkfOutcome::kGated) {
    ++refused_;
  } else if (++gated_; ++gated_in_a_row_ >= params_.max_gated) {
    ++times_lost_;
    start_from(fix);
  }
  return outcome;
}

void RobotEkf::start_from(const localization::PoseFix& fix) {
  const double variance_m2 = params_.start_stddev_m * params_.start_stddev_m;
  const double variance_rad2 = params_.start_stddev_rad * params_.start_stddev_rad;
  const Eigen::Vector3d more(variance_m2, variance_m2, variance_rad2);
  const Eigen::Matrix3d covariance = fix.covariance + Eigen::Matrix3d(more.asDiagonal());
  start_at({fix.T_map_robot, covariance});
  ++applied_;
  if (stamp_) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): start_at() has set it
    ekf_->move(seconds_of(*stamp_), T_odom_robot_);
  }
}

void RobotEkf::on_odometry(const sensors::OdometryObservation& observation) {
  const sensors::WheelTravel before = travel_.value_or(observation.travel);
  travel_ = observation.travel;
  const double left_m = observation.travel.left_m - before.left_m;
  const double right_m = observation.travel.right_m - before.right_m;
  const double heading_rad = heading_rad_after((right_m - left_m) / robot_.track_m);
  const double turn_rad = heading_rad - std::exchange(heading_rad_, heading_rad);
  T_odom_robot_ = T_odom_robot_ * sensors::arc_step(0.5 * (left_m + right_m), turn_rad);
  stamp_ = observation.stamp;
  if (ekf_ && ekf_->move(seconds_of(observation.stamp), T_odom_robot_) == EkfOutcome::kApplied) {
    add_held();
    trajectory_.push_back({observation.stamp, ekf_->belief().T_map_robot});
  }
}

void RobotEkf::on_yaw(const sensors::YawObservation& observation) { yaw_ = observation.yaw; }

void RobotEkf::on_hazards(const sensors::HazardObservation& observation) {
  const bool was_lifted = std::exchange(is_lifted_, observation.is_in_the_air());
  if (is_lifted_ && !was_lifted) {
    ++times_lost_;
    ekf_.reset();
    held_.clear();
  }
  if (was_lifted && !is_lifted_) {
    landed_ = observation.stamp;
  }
}

std::optional<localization::PoseGaussian> RobotEkf::belief() const {
  return ekf_ ? std::optional(ekf_->belief()) : std::nullopt;
}

double RobotEkf::heading_rad_after(double wheel_turn_rad) {
  const double before_rad = heading_rad_ - wheel_turn_rad_;  // At the filter's last update.
  wheel_turn_rad_ += wheel_turn_rad;
  if (!yaw_) {
    return before_rad + wheel_turn_rad_;
  }
  const sensors::Yaw last = used_yaw_.value_or(*yaw_);
  const double duration_s = yaw_->measured_s - last.measured_s;
  if (used_yaw_ && duration_s <= 0.0) {
    return before_rad + wheel_turn_rad_;
  }
  const double filtered_rad = heading_.heading_rad();
  used_yaw_ = yaw_;
  const double wheels_rad = std::exchange(wheel_turn_rad_, 0.0);
  if (duration_s <= 0.0) {
    return before_rad + wheels_rad;
  }
  heading_.update({duration_s, yaw_->yaw_rad - last.yaw_rad, wheels_rad});
  return before_rad + geometry::angle_between(filtered_rad, heading_.heading_rad());
}

}  // namespace echomap::pipeline
