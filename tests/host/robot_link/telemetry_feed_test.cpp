// SPDX-License-Identifier: MIT
#include "host/robot_link/telemetry_feed.hpp"

#include <gtest/gtest.h>

#include "tests/host/robot_link/link_fixture.hpp"

namespace echomap::robot_link {
namespace {

class TelemetryFeedTest : public testing::Test {
 protected:
  RecordingListener listener;
  TelemetryFeed feed{listener, std::chrono::milliseconds(200)};
};

TEST_F(TelemetryFeedTest, TakesAStepBackOfMoreThan200MsForAnotherStart) {
  EXPECT_TRUE(feed.continues(5'000'000));
  EXPECT_TRUE(feed.continues(4'900'000)) << "an echo's stamp is older than odometry's";
  EXPECT_TRUE(feed.continues(4'800'000)) << "against the newest";
  EXPECT_FALSE(feed.continues(4'799'999));
  feed.restart();
  EXPECT_TRUE(feed.continues(1000));
}

TEST_F(TelemetryFeedTest, GoesOnOverTheWrapOfTheStamps) {
  EXPECT_TRUE(feed.continues(0xFFFF'FF00));
  EXPECT_TRUE(feed.continues(0x0000'0100));
  EXPECT_TRUE(feed.continues(0xFFFF'FFF0));
}

TEST_F(TelemetryFeedTest, DeliversEachMessageToItsHandler) {
  feed.deliver(protocol::Odometry{1, 2, 3, 4});
  feed.deliver(protocol::Echo{5, 6, 7, 8, 9});
  ASSERT_EQ(listener.odometry.size(), 1U);
  EXPECT_EQ(listener.odometry[0].left_ticks, 2);
  ASSERT_EQ(listener.echoes.size(), 1U);
  EXPECT_EQ(listener.echoes[0].flight_us, 7);
}

TEST_F(TelemetryFeedTest, KeepsTheRobotsOwnCountersForTheStatistics) {
  protocol::Health health{};
  health.frames_bad = 1;
  feed.deliver(health);
  LinkStatistics statistics;
  feed.restart_counters();
  feed.deliver(health);
  feed.add_to(statistics);
  EXPECT_EQ(statistics.robot_frames_bad, 2U);
}

}  // namespace
}  // namespace echomap::robot_link
