// SPDX-License-Identifier: MIT
#include "host/robot_link/outage_counter.hpp"

#include <gtest/gtest.h>

namespace echomap::robot_link {
namespace {

using std::chrono::milliseconds;

class OutageCounterTest : public testing::Test {
 protected:
  LinkStatistics after(LinkState state, int at_ms) {
    counter.note(state, time::HostTime(milliseconds(at_ms)));
    LinkStatistics statistics;
    counter.add_to(statistics);
    return statistics;
  }

  OutageCounter counter;
};

TEST_F(OutageCounterTest, CountsNothingBeforeTheLinkWasReady) {
  after(LinkState::kConnecting, 0);
  after(LinkState::kSilent, 3000);
  EXPECT_EQ(after(LinkState::kReady, 4000).outages, 0U);
  EXPECT_EQ(after(LinkState::kReady, 5000).outage_time, milliseconds(0));
}

TEST_F(OutageCounterTest, AddsUpOutagesAndTheirTimes) {
  after(LinkState::kReady, 0);
  after(LinkState::kLost, 100);
  after(LinkState::kSilent, 1000);
  EXPECT_EQ(after(LinkState::kReady, 1100).outage_time, milliseconds(1000));
  EXPECT_EQ(after(LinkState::kConnecting, 2000).outages, 2U);
  EXPECT_EQ(after(LinkState::kConnecting, 2300).outage_time, milliseconds(1300));
  EXPECT_EQ(counter.last(), milliseconds(300));
  EXPECT_EQ(after(LinkState::kReady, 2500).outage_time, milliseconds(1500));
  EXPECT_EQ(after(LinkState::kReady, 9000).outages, 2U);
}

}  // namespace
}  // namespace echomap::robot_link
