// SPDX-License-Identifier: MIT
#include "host/robot_link/line_watch.hpp"

#include <gtest/gtest.h>

#include "tests/support/host_times.hpp"

namespace echomap::robot_link {
namespace {

using tests::at_ms;

class LineWatchTest : public testing::Test {
 protected:
  LineWatch watch{RobotLinkParams{}};
};

TEST_F(LineWatchTest, SearchesForTwoSecondsBeforeItCallsALineSilent) {
  EXPECT_EQ(watch.next_state(LinkState::kConnecting, at_ms(100)), LinkState::kConnecting);
  EXPECT_EQ(watch.next_state(LinkState::kConnecting, at_ms(2099)), LinkState::kConnecting);
  EXPECT_EQ(watch.next_state(LinkState::kConnecting, at_ms(2100)), LinkState::kSilent);
  watch.begin_search(at_ms(2100));
  EXPECT_EQ(watch.next_state(LinkState::kSilent, at_ms(4099)), LinkState::kConnecting);
}

TEST_F(LineWatchTest, TellsGarbageFromARobotThatDoesNotHear) {
  watch.begin_search(at_ms(0));
  watch.note_byte(at_ms(1000));
  EXPECT_EQ(watch.next_state(LinkState::kConnecting, at_ms(2500)), LinkState::kGarbage);
  watch.note_frame(at_ms(2500));
  EXPECT_EQ(watch.next_state(LinkState::kGarbage, at_ms(2500)), LinkState::kUnheard);
  EXPECT_EQ(watch.next_state(LinkState::kUnheard, at_ms(4501)), LinkState::kSilent);
}

TEST_F(LineWatchTest, LosesAReadyLinkAfterASecondWithoutFrames) {
  watch.note_frame(at_ms(500));
  watch.note_byte(at_ms(1400));
  EXPECT_EQ(watch.next_state(LinkState::kReady, at_ms(1500)), LinkState::kReady);
  EXPECT_EQ(watch.next_state(LinkState::kReady, at_ms(1501)), LinkState::kLost);
  EXPECT_TRUE(watch.is_lost(at_ms(1501)));
}

TEST_F(LineWatchTest, LeavesStatesThatTimeDoesNotChange) {
  for (const LinkState state : {LinkState::kDescribing, LinkState::kMismatch, LinkState::kLost}) {
    EXPECT_EQ(watch.next_state(state, at_ms(60'000)), state) << static_cast<int>(state);
  }
}

TEST_F(LineWatchTest, SaysHelloEvery50MsUntilTheLinkIsReadyOrSettled) {
  EXPECT_TRUE(watch.is_hello_due(LinkState::kConnecting, at_ms(0)));
  watch.note_hello(at_ms(0));
  EXPECT_FALSE(watch.is_hello_due(LinkState::kConnecting, at_ms(49)));
  EXPECT_TRUE(watch.is_hello_due(LinkState::kConnecting, at_ms(50)));
  EXPECT_TRUE(watch.is_hello_due(LinkState::kLost, at_ms(50)));
  EXPECT_FALSE(watch.is_hello_due(LinkState::kMismatch, at_ms(50)));
  EXPECT_FALSE(watch.is_hello_due(LinkState::kDescribing, at_ms(50)));
}

TEST_F(LineWatchTest, AsksAReadyRobotThatHasFallenQuiet) {
  watch.note_frame(at_ms(1000));
  EXPECT_FALSE(watch.is_hello_due(LinkState::kReady, at_ms(1300)));
  EXPECT_TRUE(watch.is_hello_due(LinkState::kReady, at_ms(1301)));
}

}  // namespace
}  // namespace echomap::robot_link
