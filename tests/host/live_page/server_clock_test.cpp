// SPDX-License-Identifier: MIT
#include "host/live_page/server_clock.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

TEST(ServerClock, CountsMilliseconds) {
  const double before_ms = server_clock_ms();
  EXPECT_GE(before_ms, 0.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_GE(server_clock_ms(), before_ms + 20.0);
}

}  // namespace
}  // namespace echomap::live_page
