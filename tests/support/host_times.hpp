// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "host/time/host_time.hpp"

namespace echomap::tests {

/// An instant of the host's clock.
inline time::HostTime at_ms(int instant_ms) {
  return time::HostTime(std::chrono::milliseconds(instant_ms));
}

}  // namespace echomap::tests
