// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace echomap::live_page {

/// The clock that motions tell and commands that steer give back, milliseconds.
inline double server_clock_ms() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

}  // namespace echomap::live_page
