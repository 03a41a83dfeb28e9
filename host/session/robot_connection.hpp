// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "host/recording/session_recorder.hpp"
#include "host/robot_link/robot_link.hpp"
#include "host/session/pace.hpp"
#include "host/transport/byte_stream.hpp"

namespace echomap::session {

/// A way to a robot: its bytes, its time, and a number that no earlier session with it had.
struct RobotConnection {
  std::unique_ptr<transport::ByteStream> stream;
  std::unique_ptr<Pace> pace;
  std::uint16_t session_id = 1;
  /// How long a link that was ready may be away before the run ends.
  std::chrono::milliseconds patience{10'000};
  /// The robot must not have been reset by opening its port.
  bool no_reset = false;
  /// Whoever lifts the robot puts it down again within five minutes, somewhere, and the run goes
  /// on; else it ends.
  bool may_be_lifted = false;
  /// By what carries the bytes.
  robot_link::RobotLinkParams link{};
  /// Sees every frame; null for nobody. It outlives the session.
  recording::SessionRecorder* recorder = nullptr;
};

}  // namespace echomap::session
