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
      break;
  }
  return "nowhere-to-go";
}

}  // namespace echomap::exploration
