// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/pipeline/observation_sink.hpp"

namespace echomap::pipeline {

/// Makes one session of several: hands on what each senses, with stamps and wheel travel that go on
/// from where the session before ended.
class JoinedSessions final : public AnyObservationSink {
 public:
  /// `sink` outlives this.
  explicit JoinedSessions(ObservationSink& sink) : sink_(sink) {}

  /// What comes from here on is of the next session, whose clock and wheels count from anywhere and
  /// whose robot begins where it stood. Ends a scan that is open; what touched the robot or lifted
  /// it is over.
  void begin_next();

  void on(const sensors::Observation& observation) override;

 private:
  time::RobotTime joined(time::RobotTime stamp);
  sensors::WheelTravel joined(const sensors::WheelTravel& travel);

  ObservationSink& sink_;
  time::RobotTime last_stamp_;  ///< The latest that was handed on.
  sensors::WheelTravel last_travel_;
  /// What this session's own are shifted by; empty until the first of them tells.
  std::optional<time::RobotClock::duration> stamp_shift_ = time::RobotClock::duration::zero();
  std::optional<sensors::WheelTravel> travel_shift_ = sensors::WheelTravel{};
};

}  // namespace echomap::pipeline
