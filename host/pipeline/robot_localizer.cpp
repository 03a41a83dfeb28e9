// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_localizer.hpp"

#include <algorithm>
#include <utility>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::pipeline {

RobotLocalizer::RobotLocalizer(const mapping::RasterMap& map,
                               const sensors::RobotGeometry& robot,
                               const RobotLocalizerParams& params,
                               std::mt19937 random)
    : robot_(robot),
      params_(params),
      observation_(localization::observation_model(params.preset, map, params.sonar)),
      localizer_(
          *observation_, localization::localizer_params(params.preset, params.sonar), random),
      odometry_(robot.track_m) {
  geometry::ParameterValidator("robot localizer")
      .positive("step_m", params.step_m)
      .positive("step_rad", params.step_rad)
      .positive("max_readings", params.max_readings);
}

void RobotLocalizer::start_at(const geometry::Pose2& T_map_robot,
                              double stddev_m,
                              double stddev_rad) {
  if (!T_odom_updated_) {
    start_ = {T_map_robot, stddev_m, stddev_rad};
    return;
  }
  update({});
  start_outcome_ = localizer_.start_at(T_map_robot, stddev_m, stddev_rad);
}

void RobotLocalizer::start_anywhere() { localizer_.start_anywhere(); }

void RobotLocalizer::on_odometry(const sensors::OdometryObservation& observation) {
  follow(observation.stamp, observation.travel);
}

void RobotLocalizer::on_sonar(const sensors::SonarObservation& observation) {
  follow(observation.stamp, observation.travel);
  if (scan_is_open_ && !is_lifted_) {
    open_scan_.push_back({odometry_.T_odom_robot() * robot_.T_robot_sonar(observation.pan_rad),
                          observation.range_m});
  }
}

void RobotLocalizer::on_hazards(const sensors::HazardObservation& observation) {
  add_contact({observation.bump_left, observation.bump_right, observation.virtual_wall});
  const bool was_lifted = std::exchange(is_lifted_, observation.is_in_the_air());
  if (is_lifted_ && !was_lifted) {
    ++times_lifted_;
    open_scan_.clear();
    start_anywhere();
  }
}

/// A contact counts where it begins; between contacts, models of ranges know nothing new.
void RobotLocalizer::add_contact(const models::ContactReading& contact) {
  observation_->add_contact(contact);
  const bool touches = contact.bump_left || contact.bump_right;
  const bool has_touched = std::exchange(touches_, touches);
  if (touches && !has_touched && T_odom_updated_) {
    update({});
  }
}

void RobotLocalizer::begin_scan() {
  end_scan();
  scan_is_open_ = true;
}

void RobotLocalizer::end_scan() {
  if (!std::exchange(scan_is_open_, false)) {
    return;
  }
  update(evenly_picked(open_scan_, odometry_.T_odom_robot(), params_.max_readings));
  open_scan_.clear();
  ++scans_;
  if (!belief().hypotheses.empty()) {
    trajectory_.push_back({stamp_, belief().hypotheses.front().T_map_robot});
  }
}

void RobotLocalizer::follow(time::RobotTime stamp, const sensors::WheelTravel& travel) {
  odometry_.update(travel);
  stamp_ = std::max(stamp_, stamp);
  if (!T_odom_updated_) {
    update({});
    if (start_) {
      start_outcome_ =
          localizer_.start_at(start_->T_map_robot, start_->stddev_m, start_->stddev_rad);
    }
    return;
  }
  if (has_moved(*T_odom_updated_, odometry_.T_odom_robot(), params_.step_m, params_.step_rad)) {
    update({});
  }
}

void RobotLocalizer::update(const std::vector<localization::RangeReading>& readings) {
  T_odom_updated_ = odometry_.T_odom_robot();
  localizer_.update(*T_odom_updated_, readings);
}

}  // namespace echomap::pipeline
