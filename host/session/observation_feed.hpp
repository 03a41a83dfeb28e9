// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host/pipeline/observation_sink.hpp"
#include "host/sensors/observation_converter.hpp"
#include "host/sensors/observations.hpp"
#include "host/session/robot_profile.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::session {

/// Takes what the robot senses to a pipeline, in SI units.
class ObservationFeed {
 public:
  /// `sink` outlives the feed.
  ObservationFeed(const RobotProfile& profile, pipeline::ObservationSink& sink)
      : sink_(sink), converter_(profile.geometry, profile.range, profile.sensors) {}

  /// The minor version of the protocol of what follows.
  void set_protocol_minor(std::uint8_t minor) { converter_.set_protocol_minor(minor); }
  /// The robot's counters and clock begin at zero again, so much later than its last message; the
  /// pose goes on.
  void restart(time::RobotClock::duration passed) { converter_.restart(passed); }

  /// Hands on its bumpers, too, where they have changed: odometry comes more often than Status.
  void take(const protocol::Odometry& message);
  void take(const protocol::Echo& message);
  void take(const protocol::Health& message);
  void take(const protocol::Ranges& message);
  void take(const protocol::Gyro& message);
  void take(const protocol::Status& message);
  void take(const protocol::EncoderErrors& message);
  void take(const protocol::Scalar& message);

  /// The last that was told.
  const sensors::HazardObservation& hazards() const { return hazards_; }

 private:
  pipeline::ObservationSink& sink_;
  sensors::ObservationConverter converter_;
  sensors::HazardObservation hazards_;
};

}  // namespace echomap::session
