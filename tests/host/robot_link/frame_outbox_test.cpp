// SPDX-License-Identifier: MIT
#include "host/robot_link/frame_outbox.hpp"

#include <gtest/gtest.h>

#include "protocol/frame_decoder.hpp"
#include "protocol/messages.hpp"

namespace echomap::robot_link {
namespace {

/// What of a link's statistics an outbox fills in.
LinkStatistics statistics_of(const FrameOutbox& outbox) {
  LinkStatistics statistics;
  outbox.add_to(statistics);
  return statistics;
}

constexpr time::HostTime kNow{};

protocol::HelloReply granting(std::uint16_t bytes) {
  protocol::HelloReply reply{};
  reply.receive_credit_bytes = bytes;
  return reply;
}

/// Puts frames of `message` for as long as there is room; how many.
template <class M>
int fill(FrameOutbox& outbox, const M& message, std::size_t spare) {
  int count = 0;
  for (; outbox.has_room<M>(spare); ++count) {
    outbox.put(message, kNow);
  }
  return count;
}

TEST(FrameOutbox, NumbersFramesInTheirOrder) {
  FrameOutbox outbox{CreditParams{}};
  outbox.put(protocol::KeepAlive{200}, kNow);
  outbox.put(protocol::Ping{7}, kNow);
  protocol::FrameDecoder decoder(protocol::MessagesToRobot::find_schema);
  std::vector<std::pair<int, int>> ids_and_seqs;
  for (const std::uint8_t byte : outbox.take_outgoing()) {
    if (decoder.take(byte) == protocol::DecodeStatus::kFrame) {
      ids_and_seqs.emplace_back(decoder.frame().id, decoder.frame().seq);
    }
  }
  const std::vector<std::pair<int, int>> expected{{protocol::KeepAlive::kId, 0},
                                                  {protocol::Ping::kId, 1}};
  EXPECT_EQ(ids_and_seqs, expected);
  EXPECT_TRUE(outbox.take_outgoing().empty());
  EXPECT_EQ(statistics_of(outbox).frames_sent, 2U);
}

TEST(FrameOutbox, LetsNoSetpointStarveCommandsOrKeepAlives) {
  FrameOutbox outbox{CreditParams{}};
  outbox.confirm(granting(128));
  EXPECT_GT(fill(outbox, protocol::DriveSetpoint{}, kSpareOfOthers), 3);
  ASSERT_TRUE(outbox.has_room<Command>(kSpareOfAnswered));
  outbox.put(protocol::MoveTicks{}, kNow);
  ASSERT_TRUE(outbox.has_room<protocol::KeepAlive>(0));
  fill(outbox, protocol::KeepAlive{}, 0);
  EXPECT_LE(outbox.credit().unconfirmed_bytes(), 128U);
  EXPECT_GT(statistics_of(outbox).credit_waits, 0U);
}

TEST(FrameOutbox, FreesTheCreditByAnyAnswer) {
  FrameOutbox outbox{CreditParams{}};
  outbox.confirm(granting(128));
  outbox.put(protocol::Hello{}, kNow);
  outbox.put(protocol::Stop{3}, kNow);
  outbox.put(protocol::Ping{9}, kNow);
  outbox.confirm(granting(128));
  EXPECT_EQ(outbox.credit().unconfirmed_bytes(),
            kFrameBytes<protocol::Stop> + kFrameBytes<protocol::Ping>);
  outbox.confirm(protocol::Ack{3, 0});
  EXPECT_EQ(outbox.credit().unconfirmed_bytes(), kFrameBytes<protocol::Ping>);
  outbox.confirm(protocol::Pong{9, 0});
  EXPECT_EQ(outbox.credit().unconfirmed_bytes(), 0U);
}

}  // namespace
}  // namespace echomap::robot_link
