// SPDX-License-Identifier: MIT
#pragma once

#include "host/sensors/observations.hpp"

namespace echomap::pipeline {

/// Takes what a robot senses, in the order in which it arrives.
class ObservationSink {
 public:
  virtual ~ObservationSink() = default;

  virtual void on_odometry(const sensors::OdometryObservation& observation) = 0;
  virtual void on_sonar(const sensors::SonarObservation& observation) = 0;
  virtual void on_hazards(const sensors::HazardObservation& /*observation*/) {}
  virtual void on_infrared(const sensors::InfraredObservation& /*observation*/) {}
  virtual void on_carried(const sensors::CarriedObservation& /*observation*/) {}
  virtual void on_pose_fix(const sensors::PoseFixObservation& /*observation*/) {}
  virtual void on_yaw(const sensors::YawObservation& /*observation*/) {}
  virtual void on_battery(const sensors::BatteryObservation& /*observation*/) {}

  /// Readings from here to `end_scan` are one scan, whatever turns of the body lie between them. A
  /// scan that was left open is ended first.
  virtual void begin_scan() = 0;
  /// Does nothing where no scan is open.
  virtual void end_scan() = 0;
};

}  // namespace echomap::pipeline
