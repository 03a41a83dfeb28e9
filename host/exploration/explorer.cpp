// SPDX-License-Identifier: MIT
#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

const char* name_of(FinishReason reason) {
  switch (reason) {
    case FinishReason::kStopLimit:
      return "stop-limit";
    case FinishReason::kNoNewGround:
      return "no-new-ground";
    case FinishReason::kNowhereToGo:
      return "nowhere-to-go";
    case FinishReason::kCannotSense:
      break;
  }
  return "cannot-sense";
}

}  // namespace echomap::exploration
