// SPDX-License-Identifier: MIT
#include "host/pipeline/observation_sink.hpp"

#include <variant>

namespace echomap::pipeline {
namespace {

/// One function for each kind of observation.
struct HandOn {
  void operator()(const sensors::OdometryObservation& one) const { sink.on_odometry(one); }
  void operator()(const sensors::SonarObservation& one) const { sink.on_sonar(one); }
  void operator()(const sensors::HazardObservation& one) const { sink.on_hazards(one); }
  void operator()(const sensors::InfraredObservation& one) const { sink.on_infrared(one); }
  void operator()(const sensors::CarriedObservation& one) const { sink.on_carried(one); }
  void operator()(const sensors::PoseFixObservation& one) const { sink.on_pose_fix(one); }
  void operator()(const sensors::YawObservation& one) const { sink.on_yaw(one); }
  void operator()(const sensors::BatteryObservation& one) const { sink.on_battery(one); }
  void operator()(const sensors::EncoderErrorObservation& one) const {
    sink.on_encoder_errors(one);
  }
  void operator()(const sensors::ScalarObservation& one) const { sink.on_scalar(one); }
  void operator()(const sensors::BeginScan& /*one*/) const { sink.begin_scan(); }
  void operator()(const sensors::EndScan& /*one*/) const { sink.end_scan(); }

  ObservationSink& sink;
};

}  // namespace

void hand_on(const sensors::Observation& observation, ObservationSink& sink) {
  std::visit(HandOn{sink}, observation);
}

}  // namespace echomap::pipeline
