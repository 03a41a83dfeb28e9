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

TEST(SenderClock, DoesNotFollowMessagesOfOtherClocks) {
  SenderClock clock;
  EXPECT_TRUE(clock.add(1000.0, at_s(5.0)));
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(clock.add(9000.0 + 2.0 * i, at_s(5.1 + 0.1 * i))) << "none agrees with another";
  }
  EXPECT_FALSE(clock.add(9100.0, at_s(7.0)));
  EXPECT_FALSE(clock.add(9100.1, at_s(7.1)));
  EXPECT_TRUE(clock.add(1002.2, at_s(7.2)));
  EXPECT_FALSE(clock.add(9100.3, at_s(7.3))) << "not in a row";
  EXPECT_NEAR(host_s(clock, 1003.0), 8.0, 1e-6);
}

TEST(SenderClock, FollowsASenderThatHasStartedAnew) {
  for (const double anew_s : {0.0, 5000.0}) {
    SenderClock clock;
    clock.add(1000.0, at_s(5.0));
    EXPECT_FALSE(clock.add(anew_s, at_s(6.0)));
    EXPECT_FALSE(clock.add(anew_s + 0.1, at_s(6.12)));
    EXPECT_TRUE(clock.add(anew_s + 0.2, at_s(6.21)));
    EXPECT_NEAR(host_s(clock, anew_s), 6.01, 1e-6);
    EXPECT_TRUE(clock.add(anew_s + 0.3, at_s(6.3)));
    EXPECT_NEAR(host_s(clock, anew_s), 6.0, 1e-6);
  }
}

}  // namespace
}  // namespace echomap::time
