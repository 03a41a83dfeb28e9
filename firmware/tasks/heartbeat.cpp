// SPDX-License-Identifier: MIT
#include "firmware/tasks/heartbeat.hpp"

#include "firmware/hal/watchdog.hpp"

namespace echomap {
namespace tasks {

void Heartbeat::ran(Part part) {
  constexpr uint8_t kAllParts = 7;
  ran_ = static_cast<uint8_t>(ran_ | (1U << static_cast<uint8_t>(part)));
  if (ran_ == kAllParts) {
    ran_ = 0;
    hal::kick_watchdog();
  }
}

}  // namespace tasks
}  // namespace echomap
