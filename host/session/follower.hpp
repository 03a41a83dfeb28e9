// SPDX-License-Identifier: MIT
#pragma once

#include "host/pipeline/observation_sink.hpp"
#include "host/session/robot_session.hpp"

namespace echomap::session {

/// Estimates where a connected robot is, by what it senses and by what comes from elsewhere.
class Follower {
 public:
  virtual ~Follower() = default;

  /// Takes what the robot senses.
  virtual pipeline::ObservationSink& sink() = 0;
  /// Called after every step of the session's time: takes what comes from elsewhere.
  virtual void poll(const RobotSession& session) = 0;
  /// The robot is connected and stands. Throws CommandError where the follower cannot begin.
  virtual void begin(RobotSession& session) = 0;
};

}  // namespace echomap::session
