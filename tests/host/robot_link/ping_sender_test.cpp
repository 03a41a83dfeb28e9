// SPDX-License-Identifier: MIT
#include "host/robot_link/ping_sender.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::robot_link {
namespace {

time::HostTime at_ms(int instant_ms) {
  return time::HostTime(std::chrono::milliseconds(instant_ms));
}

int pings_between(PingSender& sender, int from_ms, int to_ms) {
  int count = 0;
  for (int now_ms = from_ms; now_ms < to_ms; now_ms += 10) {
    if (sender.is_due(at_ms(now_ms))) {
      sender.take(at_ms(now_ms));
      ++count;
    }
  }
  return count;
}

TEST(PingSender, AsksOftenAtFirstAndThenOnceASecond) {
  PingSender sender({});
  sender.restart(at_ms(0));
  EXPECT_EQ(pings_between(sender, 0, 20'000), 400);
  EXPECT_EQ(pings_between(sender, 20'000, 30'000), 10);
  sender.restart(at_ms(30'000));
  EXPECT_EQ(pings_between(sender, 30'000, 31'000), 20);
}

TEST(PingSender, KnowsTheLastPingOnlyAndOnce) {
  PingSender sender({});
  sender.restart(at_ms(0));
  const auto first = sender.take(at_ms(0));
  const auto second = sender.take(at_ms(50));
  EXPECT_FALSE(sender.take_answer(first));
  EXPECT_EQ(sender.take_answer(second), at_ms(50));
  EXPECT_FALSE(sender.take_answer(second));
}

TEST(PingSender, RefusesAPeriodOfNothing) {
  EXPECT_THROW(PingSender({.period = std::chrono::seconds(0)}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::robot_link
