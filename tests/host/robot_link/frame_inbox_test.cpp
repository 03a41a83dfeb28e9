// SPDX-License-Identifier: MIT
#include "host/robot_link/frame_inbox.hpp"

#include <gtest/gtest.h>

#include "protocol/frame_encoder.hpp"
#include "tests/host/robot_link/other_messages.hpp"

namespace echomap::robot_link {
namespace {

/// What of a link's statistics an inbox fills in.
LinkStatistics statistics_of(const FrameInbox& inbox) {
  LinkStatistics statistics;
  inbox.add_to(statistics);
  return statistics;
}

class FrameInboxTest : public testing::Test {
 protected:
  template <class M>
  void send(const M& message, std::uint8_t seq, unsigned flip = 0) {
    protocol::FrameEncoder encoder;
    const protocol::ByteSpan frame = encoder.encode(message, seq);
    for (std::uint8_t i = 0; i < frame.size; ++i) {
      const auto byte = static_cast<std::uint8_t>(frame.data[i] ^ (i == 4 ? flip : 0U));
      if (inbox.take(byte, difference) == InboxEvent::kFrame) {
        inbox.count_frame();
      }
    }
  }

  FrameInbox inbox;
  std::optional<SchemaDifference> difference;
};

TEST_F(FrameInboxTest, CountsWhatIsMissingAndWhatIsDamaged) {
  send(protocol::Odometry{}, 5);
  send(protocol::Odometry{}, 6, 0x20);
  send(protocol::Odometry{}, 9);
  EXPECT_EQ(statistics_of(inbox).frames_received, 2U);
  EXPECT_EQ(statistics_of(inbox).frames_bad, 1U);
  EXPECT_EQ(statistics_of(inbox).frames_lost, 3U);
}

TEST_F(FrameInboxTest, TakesTheRobotsOwnMessagesForNoLoss) {
  difference.emplace(read_robot_schema(description_of<other_messages::Newer>()).value());
  send(protocol::Odometry{}, 5);
  send(Compass{}, 6);
  send(protocol::Odometry{}, 7);
  EXPECT_EQ(statistics_of(inbox).frames_foreign, 1U);
  EXPECT_EQ(statistics_of(inbox).frames_bad, 0U);
  EXPECT_EQ(statistics_of(inbox).frames_lost, 0U);
}

TEST_F(FrameInboxTest, CountsThemAsDamagedWhereNothingIsKnownOfThem) {
  send(protocol::Odometry{}, 5);
  send(Compass{}, 6);
  EXPECT_EQ(statistics_of(inbox).frames_foreign, 0U);
  EXPECT_EQ(statistics_of(inbox).frames_bad, 1U);
}

TEST_F(FrameInboxTest, TakesAJumpAfterARestartForNoLoss) {
  send(protocol::Odometry{}, 5);
  inbox.restart();
  send(protocol::Odometry{}, 200);
  EXPECT_EQ(statistics_of(inbox).frames_lost, 0U);
}

}  // namespace
}  // namespace echomap::robot_link
