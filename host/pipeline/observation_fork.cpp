// SPDX-License-Identifier: MIT
#include "host/pipeline/observation_fork.hpp"

namespace echomap::pipeline {

void ObservationFork::on_odometry(const sensors::OdometryObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_odometry(observation);
  }
}

void ObservationFork::on_sonar(const sensors::SonarObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_sonar(observation);
  }
}

void ObservationFork::on_hazards(const sensors::HazardObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_hazards(observation);
  }
}

void ObservationFork::on_infrared(const sensors::InfraredObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_infrared(observation);
  }
}

void ObservationFork::on_carried(const sensors::CarriedObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_carried(observation);
  }
}

void ObservationFork::on_pose_fix(const sensors::PoseFixObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_pose_fix(observation);
  }
}

void ObservationFork::on_yaw(const sensors::YawObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_yaw(observation);
  }
}

void ObservationFork::on_battery(const sensors::BatteryObservation& observation) {
  for (ObservationSink* sink : sinks_) {
    sink->on_battery(observation);
  }
}

void ObservationFork::begin_scan() {
  for (ObservationSink* sink : sinks_) {
    sink->begin_scan();
  }
}

void ObservationFork::end_scan() {
  for (ObservationSink* sink : sinks_) {
    sink->end_scan();
  }
}

}  // namespace echomap::pipeline
