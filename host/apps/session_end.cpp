// SPDX-License-Identifier: MIT
#include "host/apps/session_end.hpp"

namespace echomap::apps {

ExitCode exit_code_of(SessionEnd end) {
  switch (end) {
    case SessionEnd::kInterrupted:
      return ExitCode::kInterrupted;
    case SessionEnd::kSafetyStop:
      return ExitCode::kSafetyStop;
    case SessionEnd::kLinkLost:
      break;
  }
  return ExitCode::kLinkLost;
}

std::string_view safety_stop(protocol::MotionOutcome outcome) {
  switch (outcome) {
    case protocol::MotionOutcome::kLifted:
      return "the robot was lifted, and its pose is not known any more";
    case protocol::MotionOutcome::kRunaway:
      return "a wheel turned against its command: check the inversions of motors and encoders in "
             "the profile";
    case protocol::MotionOutcome::kOverSpeed:
      return "a wheel was faster than the profile allows";
    default:
      return {};
  }
}

}  // namespace echomap::apps
