// SPDX-License-Identifier: MIT
#pragma once

#include "host/sensors/observations.hpp"
#include "host/sensors/range_scan.hpp"

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
  virtual void on_encoder_errors(const sensors::EncoderErrorObservation& /*observation*/) {}
  virtual void on_scalar(const sensors::ScalarObservation& /*observation*/) {}

  /// What only other robots sense, in place of wheels and pings (LogPlayer).
  virtual void on_odometry_pose(const sensors::OdometryPoseObservation& /*observation*/) {}
  virtual void on_range_scan(const sensors::RangeScan& /*scan*/) {}
  virtual void on_landmark(const sensors::LandmarkObservation& /*observation*/) {}

  /// Readings from here to `end_scan` are one scan, whatever turns of the body lie between them. A
  /// scan that was left open is ended first.
  virtual void begin_scan() = 0;
  /// Does nothing where no scan is open.
  virtual void end_scan() = 0;
};

/// Calls the function of the sink that takes this observation.
void hand_on(const sensors::Observation& observation, ObservationSink& sink);

/// Takes all observations of our own robots alike; those of logs go unheard.
class AnyObservationSink : public ObservationSink {
 public:
  virtual void on(const sensors::Observation& observation) = 0;

  void on_odometry(const sensors::OdometryObservation& observation) final { on(observation); }
  void on_sonar(const sensors::SonarObservation& observation) final { on(observation); }
  void on_hazards(const sensors::HazardObservation& observation) final { on(observation); }
  void on_infrared(const sensors::InfraredObservation& observation) final { on(observation); }
  void on_carried(const sensors::CarriedObservation& observation) final { on(observation); }
  void on_pose_fix(const sensors::PoseFixObservation& observation) final { on(observation); }
  void on_yaw(const sensors::YawObservation& observation) final { on(observation); }
  void on_battery(const sensors::BatteryObservation& observation) final { on(observation); }
  void on_encoder_errors(const sensors::EncoderErrorObservation& observation) final {
    on(observation);
  }
  void on_scalar(const sensors::ScalarObservation& observation) final { on(observation); }
  void begin_scan() final { on(sensors::BeginScan{}); }
  void end_scan() final { on(sensors::EndScan{}); }
};

}  // namespace echomap::pipeline
