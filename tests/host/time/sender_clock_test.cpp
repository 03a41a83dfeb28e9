// SPDX-License-Identifier: MIT
#include "host/time/sender_clock.hpp"

#include <gtest/gtest.h>

namespace echomap::time {
namespace {

HostTime at_s(double seconds) {
  return HostTime(HostClock::duration(static_cast<std::int64_t>(seconds * 1e6 + 0.5)));
}

double host_s(const SenderClock& clock, double sender_s) {
  const auto instant = clock.host_time(sender_s);
  return instant ? std::chrono::duration<double>(instant->time_since_epoch()).count() : -1.0;
}

TEST(SenderClock, KnowsNothingBeforeTheFirstMessage) { EXPECT_FALSE(SenderClock().host_time(1.0)); }

TEST(SenderClock, BelievesTheFastestMessage) {
  SenderClock clock;
  clock.add(1000.0, at_s(5.2));
  EXPECT_NEAR(host_s(clock, 1000.0), 5.2, 1e-6);
  clock.add(1001.0, at_s(6.01));
  EXPECT_NEAR(host_s(clock, 1000.0), 5.01, 1e-6);
  clock.add(1002.0, at_s(7.5));
  EXPECT_NEAR(host_s(clock, 1002.0), 7.01, 1e-6);
}

TEST(SenderClock, FollowsAClockThatDriftsAwayWithinAMinute) {
  SenderClock clock;
  clock.add(0.0, at_s(10.0));
  for (int i = 1; i <= 130; ++i) {
    clock.add(i, at_s(10.0 + 1.001 * i));
  }
  EXPECT_NEAR(host_s(clock, 130.0), 10.0 + 1.001 * 130, 0.061);
  EXPECT_LT(host_s(clock, 130.0), 10.0 + 1.001 * 130);
}

}  // namespace
}  // namespace echomap::time
