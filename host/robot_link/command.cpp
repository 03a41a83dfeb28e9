// SPDX-License-Identifier: MIT
#include "host/robot_link/command.hpp"

namespace echomap::robot_link {

std::string_view to_string(CommandOutcome outcome) {
  switch (outcome) {
    case CommandOutcome::kAccepted:
      return "accepted";
    case CommandOutcome::kDisarmed:
      return "disarmed";
    case CommandOutcome::kBusy:
      return "busy";
    case CommandOutcome::kOutOfRange:
      return "out of range";
    case CommandOutcome::kBlocked:
      return "blocked by a contact, a cliff or a hanging wheel";
    case CommandOutcome::kRefused:
      return "refused";
    case CommandOutcome::kNotUnderstood:
      return "not understood by the firmware";
    case CommandOutcome::kLinkLost:
      return "link lost";
    case CommandOutcome::kRobotReset:
      return "robot was reset";
  }
  return "unknown";
}

}  // namespace echomap::robot_link
