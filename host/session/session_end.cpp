// SPDX-License-Identifier: MIT
#include "host/session/session_end.hpp"

namespace echomap::session {

console::ExitCode exit_code_of(SessionEnd end) {
  switch (end) {
    case SessionEnd::kInterrupted:
      return console::ExitCode::kInterrupted;
    case SessionEnd::kSafetyStop:
      return console::ExitCode::kSafetyStop;
    case SessionEnd::kFirmwareMismatch:
      return console::ExitCode::kFirmwareMismatch;
    case SessionEnd::kConfigInvalid:
      return console::ExitCode::kConfigInvalid;
    case SessionEnd::kLinkLost:
      break;
  }
  return console::ExitCode::kLinkLost;
}

std::string outcome_of(SessionEnd end) {
  switch (end) {
    case SessionEnd::kInterrupted:
      return "interrupted";
    case SessionEnd::kSafetyStop:
      return "safety-stop";
    case SessionEnd::kFirmwareMismatch:
      return "firmware-mismatch";
    case SessionEnd::kConfigInvalid:
      return "configuration-invalid";
    case SessionEnd::kLinkLost:
      break;
  }
  return "link-lost";
}

std::string_view safety_stop(protocol::MotionOutcome outcome) {
  switch (outcome) {
    case protocol::MotionOutcome::kLifted:
      return "the robot was lifted, and its pose is not known any more\n"
             "  next: put it down and start anew";
    case protocol::MotionOutcome::kRunaway:
      return "a wheel turned against its command\n"
             "  next: check the inversions of motors and encoders in the profile";
    case protocol::MotionOutcome::kOverSpeed:
      return "a wheel was faster than the profile allows\n"
             "  next: check the motors' wires, and over_speed_m_per_s in the profile";
    default:
      return {};
  }
}

}  // namespace echomap::session
