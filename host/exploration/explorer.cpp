// SPDX-License-Identifier: MIT
#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

const char* name_of(FinishReason reason) {
  switch (reason) {
    case FinishReason::kComplete:
      return "complete";
    case FinishReason::kStopLimit:
      return "stop-limit";
    case FinishReason::kNoNewGround:
      return "no-new-ground";
    case FinishReason::kNowhereToGo:
      return "nowhere-to-go";
    case FinishReason::kWaypointsMissed:
      return "waypoints-missed";
    case FinishReason::kNotBack:
      return "not-back";
    case FinishReason::kStuck:
      return "stuck";
    case FinishReason::kLifted:
      return "lifted";
    case FinishReason::kBatteryLow:
      return "battery-low";
    case FinishReason::kSonarSilent:
      return "sonar-silent";
    case FinishReason::kSonarStuck:
      return "sonar-stuck";
    case FinishReason::kWheelFault:
      return "wheel-fault";
    case FinishReason::kLost:
      return "lost";
    case FinishReason::kCannotSense:
      break;
  }
  return "cannot-sense";
}

}  // namespace echomap::exploration
