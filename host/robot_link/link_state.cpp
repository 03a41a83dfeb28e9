// SPDX-License-Identifier: MIT
#include "host/robot_link/link_state.hpp"

namespace echomap::robot_link {

std::string_view to_string(LinkState state) {
  switch (state) {
    case LinkState::kConnecting:
      return "connecting";
    case LinkState::kDescribing:
      return "describing";
    case LinkState::kReady:
      return "ready";
    case LinkState::kSilent:
      return "silent";
    case LinkState::kGarbage:
      return "garbage";
    case LinkState::kUnheard:
      return "unheard";
    case LinkState::kMismatch:
      return "mismatch";
    case LinkState::kLost:
      return "lost";
  }
  return "unknown";
}

}  // namespace echomap::robot_link
