// SPDX-License-Identifier: MIT
#include "firmware/tasks/bulk.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "protocol/schema_description.hpp"
#include "tests/firmware/native_robot.hpp"
#include "tests/support/bulk_content.hpp"

namespace echomap::tasks {
namespace {

using protocol::BulkContent;
using protocol::BulkData;
using protocol::BulkRead;
using tests::NativeRobot;

constexpr auto kDescription = protocol::describe_schema<protocol::AllMessages>();
const std::vector<std::uint8_t> description(std::begin(kDescription.bytes),
                                            std::end(kDescription.bytes));

BulkRead read(BulkContent content, std::uint16_t offset) {
  return {static_cast<std::uint8_t>(content), offset};
}

/// Reads with a window of four, 20 ms for each.
std::vector<std::uint8_t> read_all(NativeRobot& robot, BulkContent content) {
  tests::BulkBuffer buffer;
  for (std::uint16_t offset = 0; offset == 0 || offset < buffer.total();) {
    for (int i = 0; i < Bulk::kWindow; ++i) {
      robot.send(read(content, offset));
      offset = static_cast<std::uint16_t>(offset + protocol::kBulkBytes);
    }
    const std::int64_t from_ns = robot.board.now_ns();
    robot.run_ms(20);
    const auto answers = robot.all<BulkData>(from_ns);
    EXPECT_EQ(answers.size(), std::size_t{Bulk::kWindow});
    for (const BulkData& data : answers) {
      buffer.add(data);
    }
  }
  return buffer.bytes();
}

TEST(Bulk, TellsTheSchemaToWhoeverAsks) {
  NativeRobot robot;
  EXPECT_EQ(read_all(robot, BulkContent::kSchema), description);
}

TEST(Bulk, TellsTheConfigurationThatHolds) {
  NativeRobot robot;
  ASSERT_TRUE(robot.connect(1).has_value());
  protocol::Configuration expected = app::kDefaultConfiguration;
  expected.sonar.ping_gap_ms = 99;
  ASSERT_EQ(robot.command(expected.sonar), protocol::CommandStatus::kAccepted);
  const protocol::ConfigurationBytes bytes = protocol::configuration_bytes(expected);
  EXPECT_EQ(read_all(robot, BulkContent::kConfiguration),
            std::vector<std::uint8_t>(std::begin(bytes.bytes), std::end(bytes.bytes)));
}

TEST(Bulk, SaysTheSameAgain) {
  NativeRobot robot;
  robot.send(read(BulkContent::kSchema, 32));
  robot.send(read(BulkContent::kSchema, 32));
  robot.run_ms(20);
  const auto answers = robot.all<BulkData>();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].total, description.size());
  EXPECT_EQ(tests::bytes_of(answers[0]), tests::bytes_of(answers[1]));
}

TEST(Bulk, HasNothingBeyondTheEndOrOfAnotherContent) {
  NativeRobot robot;
  const auto end = static_cast<std::uint16_t>(description.size());
  const std::vector<std::uint8_t> nothing(protocol::kBulkBytes);
  robot.send(read(BulkContent::kSchema, end));
  robot.send(read(BulkContent::kSchema, UINT16_MAX));
  robot.send(BulkRead{77, 0});
  robot.run_ms(20);
  const auto answers = robot.all<BulkData>();
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].total, end);
  EXPECT_EQ(tests::bytes_of(answers[0]), nothing);
  EXPECT_EQ(answers[1].offset, UINT16_MAX);
  EXPECT_EQ(tests::bytes_of(answers[1]), nothing);
  EXPECT_EQ(answers[2].content, 77);
  EXPECT_EQ(answers[2].total, 0);
  EXPECT_EQ(tests::bytes_of(answers[2]), nothing);
}

TEST(Bulk, ForgetsWhatIsAskedBeyondTheWindow) {
  drivers::SerialPort port;
  FrameSender sender(port);
  const protocol::Configuration configuration = app::kDefaultConfiguration;
  Bulk bulk(sender, configuration);
  for (std::uint16_t i = 0; i < 6; ++i) {
    bulk.ask(read(BulkContent::kSchema, i));
  }
  protocol::FrameDecoder decoder(protocol::MessagesToHost::find_schema);
  std::vector<int> offsets;
  for (int ms = 0; ms < 10; ++ms) {
    bulk.tick();
    std::uint8_t byte = 0;
    while (port.on_send_ready(byte)) {
      if (decoder.take(byte) == protocol::DecodeStatus::kFrame) {
        offsets.push_back(protocol::get_payload<BulkData>(decoder.frame().payload).offset);
      }
    }
  }
  EXPECT_EQ(offsets, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Bulk, LeavesRoomForAnswers) {
  drivers::SerialPort port;
  FrameSender sender(port);
  const protocol::Configuration configuration = app::kDefaultConfiguration;
  Bulk bulk(sender, configuration);
  for (int ms = 0; ms < 10; ++ms) {
    bulk.ask(read(BulkContent::kSchema, 0));
    bulk.tick();
  }
  EXPECT_LT(port.send_room(), drivers::SerialPort::kSendBytes) << "nothing was said";
  sender.delimit();
  EXPECT_TRUE(sender.answer(protocol::HelloReply{}));
  EXPECT_TRUE(sender.answer(protocol::Ack{}));
  EXPECT_TRUE(sender.answer(protocol::Pong{}));
}

}  // namespace
}  // namespace echomap::tasks
