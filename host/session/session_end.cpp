// SPDX-License-Identifier: MIT
#include "host/session/session_end.hpp"

namespace echomap::session {

namespace {

using console::ExitCode;

struct EndName {
  ExitCode code;
  const char* outcome;
};

EndName name_of(SessionEnd end) {
  switch (end) {
    case SessionEnd::kInterrupted:
      return {ExitCode::kInterrupted, "interrupted"};
    case SessionEnd::kSafetyStop:
      return {ExitCode::kSafetyStop, "safety-stop"};
    case SessionEnd::kFirmwareMismatch:
      return {ExitCode::kFirmwareMismatch, "firmware-mismatch"};
    case SessionEnd::kConfigInvalid:
      return {ExitCode::kConfigInvalid, "configuration-invalid"};
    case SessionEnd::kTakenOver:
      return {ExitCode::kNoRobot, "taken-over"};
    case SessionEnd::kLinkLost:
      break;
  }
  return {ExitCode::kLinkLost, "link-lost"};
}

}  // namespace

ExitCode exit_code_of(SessionEnd end) { return name_of(end).code; }

std::string outcome_of(SessionEnd end) { return name_of(end).outcome; }

std::string_view safety_stop(protocol::MotionOutcome outcome) {
  switch (outcome) {
    case protocol::MotionOutcome::kLifted:
      return "the robot was lifted and its pose is lost\n"
             "  next: put it down and start again";
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
