// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/pipeline/observation_sink.hpp"

namespace echomap::pipeline {

/// Hands all that it takes on to others, in the order in which they were added.
class ObservationFork final : public ObservationSink {
 public:
  /// `sink` outlives this, or is removed before.
  void add(ObservationSink& sink) { sinks_.push_back(&sink); }
  void remove(ObservationSink& sink) { std::erase(sinks_, &sink); }

  void on_odometry(const sensors::OdometryObservation& observation) override;
  void on_sonar(const sensors::SonarObservation& observation) override;
  void on_hazards(const sensors::HazardObservation& observation) override;
  void on_infrared(const sensors::InfraredObservation& observation) override;
  void on_carried(const sensors::CarriedObservation& observation) override;
  void on_pose_fix(const sensors::PoseFixObservation& observation) override;
  void on_yaw(const sensors::YawObservation& observation) override;
  void on_battery(const sensors::BatteryObservation& observation) override;
  void begin_scan() override;
  void end_scan() override;

 private:
  std::vector<ObservationSink*> sinks_;
};

}  // namespace echomap::pipeline
