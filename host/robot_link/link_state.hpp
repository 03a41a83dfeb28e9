// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace echomap::robot_link {

/// How the link to the robot stands. All but kReady, kDescribing and kMismatch go on saying Hello,
/// so the link comes back by itself.
enum class LinkState : std::uint8_t {
  kConnecting,  ///< Hello was sent, nothing is decided yet.
  kReady,       ///< The robot speaks our protocol; telemetry and commands flow.
  kDescribing,  ///< The robot has other messages than this host and is asked for them.
  kSilent,      ///< Not one byte came for two seconds: no power, wrong port, no firmware.
  kGarbage,     ///< Bytes came but no frame for two seconds: wrong baud rate or another sketch.
  kUnheard,     ///< Frames come but Hello goes unanswered: the robot does not hear us.
  kBusy,        ///< Another session holds the robot, which says so.
  kMismatch,    ///< Firmware and host differ in messages that are needed.
  kLost,        ///< Was ready; then no frame for a second, or a command found no answer.
};

}  // namespace echomap::robot_link
