// SPDX-License-Identifier: MIT
#include "host/pipeline/joined_sessions.hpp"

#include <algorithm>

namespace echomap::pipeline {

void JoinedSessions::begin_next() {
  sink_.end_scan();
  sink_.on_hazards({.stamp = last_stamp_});
  stamp_shift_.reset();
  travel_shift_.reset();
}

void JoinedSessions::on_odometry(const sensors::OdometryObservation& observation) {
  sink_.on_odometry({joined(observation.stamp), joined(observation.travel)});
}

void JoinedSessions::on_sonar(const sensors::SonarObservation& observation) {
  auto shifted = observation;
  shifted.stamp = joined(observation.stamp);
  shifted.travel = joined(observation.travel);
  sink_.on_sonar(shifted);
}

void JoinedSessions::on_hazards(const sensors::HazardObservation& observation) {
  auto shifted = observation;
  shifted.stamp = joined(observation.stamp);
  sink_.on_hazards(shifted);
}

void JoinedSessions::on_infrared(const sensors::InfraredObservation& observation) {
  auto shifted = observation;
  shifted.stamp = joined(observation.stamp);
  shifted.travel = joined(observation.travel);
  sink_.on_infrared(shifted);
}

void JoinedSessions::on_carried(const sensors::CarriedObservation& observation) {
  sink_.on_carried(
      {joined(observation.stamp), joined(observation.travel), observation.T_map_robot});
}

void JoinedSessions::on_pose_fix(const sensors::PoseFixObservation& observation) {
  sink_.on_pose_fix({joined(observation.stamp), observation.T_map_robot});
}

void JoinedSessions::on_yaw(const sensors::YawObservation& observation) {
  sink_.on_yaw({joined(observation.stamp), observation.yaw});
}

void JoinedSessions::on_battery(const sensors::BatteryObservation& observation) {
  sink_.on_battery({joined(observation.stamp), observation.voltage_v});
}

time::RobotTime JoinedSessions::joined(time::RobotTime stamp) {
  if (!stamp_shift_) {
    stamp_shift_ = last_stamp_ - stamp;
  }
  const time::RobotTime shifted = stamp + *stamp_shift_;
  last_stamp_ = std::max(last_stamp_, shifted);
  return shifted;
}

sensors::WheelTravel JoinedSessions::joined(const sensors::WheelTravel& travel) {
  if (!travel_shift_) {
    travel_shift_ = {last_travel_.left_m - travel.left_m, last_travel_.right_m - travel.right_m};
  }
  last_travel_ = {travel.left_m + travel_shift_->left_m, travel.right_m + travel_shift_->right_m};
  return last_travel_;
}

}  // namespace echomap::pipeline
