// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/console/exit_code.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::session {

/// Why a session cannot go on.
enum class SessionEnd : std::uint8_t {
  kInterrupted,
  kLinkLost,
  kSafetyStop,        ///< The board has stopped and disarmed by itself.
  kFirmwareMismatch,  ///< The board came back with firmware that cannot be spoken to.
  kConfigInvalid,     ///< The board does not take the profile.
  kTakenOver,         ///< Another program has the robot now.
};

/// What the shell sees of it.
console::ExitCode exit_code_of(SessionEnd end);

/// "interrupted", "link-lost", ..., as summary.json says it.
std::string outcome_of(SessionEnd end);

/// Why a board that ended a motion so has disarmed by itself and what to do, in words; empty where
/// it has not.
std::string_view safety_stop(protocol::MotionOutcome outcome);

}  // namespace echomap::session
