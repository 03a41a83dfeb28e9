// SPDX-License-Identifier: MIT
#include "host/live_page/server_clock.hpp"

#include <chrono>

namespace echomap::live_page {

double server_clock_ms() {
  using Clock = std::chrono::steady_clock;
  static const Clock::time_point start = Clock::now();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace echomap::live_page
