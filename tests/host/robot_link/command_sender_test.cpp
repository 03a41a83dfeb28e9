// SPDX-License-Identifier: MIT
#include "host/robot_link/command_sender.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/host_times.hpp"

namespace echomap::robot_link {
namespace {

using std::chrono::milliseconds;
using tests::at_ms;

std::uint8_t id_of(const std::optional<Command>& command) {
  return std::visit([](const auto& message) { return message.command_id; }, command.value());
}

protocol::Ack accepted(std::uint8_t command_id) { return {command_id, 0}; }

class CommandSenderTest : public testing::Test {
 protected:
  std::optional<Command> take_due(time::HostTime now) {
    return sender.is_due(now) ? std::optional(sender.take(now)) : std::nullopt;
  }

  CommandSender sender{
      {.initial = milliseconds(100), .floor = milliseconds(25), .ceiling = milliseconds(400)}, 3};
};

TEST_F(CommandSenderTest, SendsTheNextCommandOnlyAfterTheAnswer) {
  sender.submit(protocol::Arm{0, 1});
  sender.submit(protocol::Stop{});
  ASSERT_TRUE(std::holds_alternative<protocol::Arm>(take_due(at_ms(0)).value()));
  EXPECT_FALSE(take_due(at_ms(50)));
  ASSERT_TRUE(sender.acknowledge(accepted(1), at_ms(60)));
  const auto second = take_due(at_ms(60));
  ASSERT_TRUE(second && std::holds_alternative<protocol::Stop>(*second));
  EXPECT_EQ(id_of(second), 2);
}

TEST_F(CommandSenderTest, ResendsTheSameIdWithDoubledPatienceAndThenGivesUp) {
  sender.submit(protocol::Stop{});
  EXPECT_EQ(id_of(take_due(at_ms(0))), 1);
  EXPECT_FALSE(take_due(at_ms(99)));
  EXPECT_EQ(id_of(take_due(at_ms(100))), 1);
  EXPECT_FALSE(take_due(at_ms(299)));
  EXPECT_EQ(id_of(take_due(at_ms(300))), 1);
  EXPECT_FALSE(sender.is_exhausted(at_ms(699)));
  EXPECT_TRUE(sender.is_exhausted(at_ms(700)));
  EXPECT_FALSE(take_due(at_ms(700)));
  EXPECT_EQ(sender.resent(), 2U);
}

TEST_F(CommandSenderTest, IgnoresAnswersToOtherCommands) {
  EXPECT_FALSE(sender.acknowledge(accepted(0), at_ms(0)));
  EXPECT_FALSE(sender.acknowledge(accepted(1), at_ms(0)));
  sender.submit(protocol::Stop{});
  EXPECT_FALSE(sender.acknowledge(accepted(0), at_ms(0)));
  take_due(at_ms(0));
  EXPECT_FALSE(sender.acknowledge(accepted(9), at_ms(1)));
  EXPECT_TRUE(sender.acknowledge(accepted(1), at_ms(1)));
  EXPECT_FALSE(sender.acknowledge(accepted(1), at_ms(2)));
}

TEST_F(CommandSenderTest, TakesNoRoundTripFromACommandThatWasResent) {
  sender.submit(protocol::Stop{});
  take_due(at_ms(0));
  take_due(at_ms(100));
  sender.acknowledge(accepted(1), at_ms(101));
  EXPECT_FALSE(sender.timer().smoothed_round_trip());
}

TEST_F(CommandSenderTest, GoesRoundTheIdsWithoutZero) {
  for (int i = 0; i < 600; ++i) {
    sender.submit(protocol::Stop{});
    const std::uint8_t id = id_of(take_due(at_ms(i)));
    ASSERT_EQ(id, i % 255 + 1);
    ASSERT_TRUE(sender.acknowledge(accepted(id), at_ms(i)));
  }
}

TEST_F(CommandSenderTest, AbandonsAllInOrderAndTellsWhichWasSent) {
  const auto first = sender.submit(protocol::Stop{});
  const auto second = sender.submit(protocol::Stop{});
  take_due(at_ms(0));
  const auto results = sender.abandon(CommandOutcome::kRobotReset);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].ticket, first);
  EXPECT_EQ(results[0].command_id, 1);
  EXPECT_EQ(results[1].ticket, second);
  EXPECT_EQ(results[1].command_id, 0);
  EXPECT_EQ(results[1].outcome, CommandOutcome::kRobotReset);
  EXPECT_FALSE(sender.is_exhausted(at_ms(10'000)));
  EXPECT_FALSE(take_due(at_ms(10'000)));
}

TEST_F(CommandSenderTest, RefusesToSendLessThanOnce) {
  EXPECT_THROW(CommandSender({}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::robot_link
