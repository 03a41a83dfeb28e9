// SPDX-License-Identifier: MIT
#include "firmware/tasks/frame_sender.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "firmware/hal/uart.hpp"
#include "protocol/frame_decoder.hpp"

namespace echomap::tasks {
namespace {

/// Takes everything queued; the sequence numbers of the frames in it.
std::vector<int> sequence_of(drivers::SerialPort& port) {
  protocol::FrameDecoder decoder(protocol::MessagesToHost::find_schema);
  std::vector<int> numbers;
  std::uint8_t byte = 0;
  while (port.on_send_ready(byte)) {
    if (decoder.take(byte) == protocol::DecodeStatus::kFrame) {
      numbers.push_back(decoder.frame().seq);
    }
  }
  return numbers;
}

TEST(FrameSender, NumbersEveryFrameThatWasQueued) {
  drivers::SerialPort port;
  FrameSender sender(port);
  int sent = 0;
  while (sender.answer(protocol::Ack{1, 0})) {
    ++sent;
  }
  EXPECT_EQ(sent, drivers::SerialPort::kSendBytes / 8);
  EXPECT_EQ(sequence_of(port).size(), static_cast<std::size_t>(sent));
  EXPECT_TRUE(sender.answer(protocol::Ack{2, 0}));
  EXPECT_EQ(sequence_of(port), (std::vector<int>{sent}));
}

TEST(FrameSender, AnswersBeyondTheirShareLeaveTelemetryItsRoom) {
  drivers::SerialPort port;
  FrameSender sender(port);
  int answered = 0;
  int told = 0;
  for (int ms = 0; ms < 10'000; ++ms) {
    sender.budget().tick();
    while (sender.answer(protocol::Pong{})) {
      ++answered;
    }
    told += ms % 10 == 0 && sender.tell(protocol::Odometry{}) ? 1 : 0;
    std::uint8_t byte = 0;
    for (int i = 0; i < hal::line_bytes_per_s() / 1000; ++i) {
      port.on_send_ready(byte);
    }
  }
  EXPECT_GE(told, 990);
  EXPECT_GT(answered * 14, 10 * hal::line_bytes_per_s() / 2)
      << "and the rest of the line is theirs";
}

TEST(FrameSender, TelemetryLeavesRoomForTheAnswers) {
  drivers::SerialPort port;
  FrameSender sender(port);
  for (int ms = 0; ms < 100; ++ms) {
    sender.budget().tick();
  }
  while (sender.tell(protocol::Odometry{})) {
  }
  EXPECT_TRUE(sender.budget().take(1)) << "the budget ended before the room";
  sender.delimit();
  EXPECT_TRUE(sender.answer(protocol::HelloReply{}));
  EXPECT_TRUE(sender.answer(protocol::Ack{}));
  EXPECT_TRUE(sender.answer(protocol::Pong{}));
}

TEST(FrameSender, TelemetryWaitsForItsBudgetAndAnswersDoNot) {
  drivers::SerialPort port;
  FrameSender sender(port);
  EXPECT_FALSE(sender.tell(protocol::Odometry{}));
  EXPECT_TRUE(sender.answer(protocol::Pong{}));
  EXPECT_EQ(sequence_of(port), std::vector<int>{0});
  sender.budget().tick();
  EXPECT_TRUE(sender.tell(protocol::Odometry{})) << "17.5 bytes in 1 ms";
  EXPECT_FALSE(sender.tell(protocol::Odometry{}));
}

TEST(FrameSender, DelimiterEndsAPieceOfAFrame) {
  drivers::SerialPort port;
  FrameSender sender(port);
  sender.delimit();
  sender.answer(protocol::Pong{1, 2});
  protocol::FrameDecoder decoder(protocol::MessagesToHost::find_schema);
  decoder.take(9);
  decoder.take(1);
  std::vector<protocol::DecodeStatus> statuses;
  std::uint8_t byte = 0;
  while (port.on_send_ready(byte)) {
    statuses.push_back(decoder.take(byte));
  }
  EXPECT_EQ(statuses.front(), protocol::DecodeStatus::kTruncated);
  EXPECT_EQ(statuses.back(), protocol::DecodeStatus::kFrame);
}

}  // namespace
}  // namespace echomap::tasks
