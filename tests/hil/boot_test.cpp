// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/version.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

class ReleaseImage : public OnEveryBoard {};

INSTANTIATE_TEST_SUITE_P(Images, ReleaseImage, every_image(), image_label);

TEST_P(ReleaseImage, SaysHelloUnaskedAfterPowerOn) {
  robot.run_ms(50);
  const auto reply = robot.last<protocol::HelloReply>();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->session, 0);
  EXPECT_EQ(reply->reset_cause, protocol::kResetPowerOn);
  EXPECT_EQ(robot.heard().size(), 1U) << "telemetry before a host said Hello";
  const double first_ms = double(robot.heard().front().at_ns) * 1e-6;
  RecordProperty("hello_after_ms", std::to_string(first_ms));
  std::printf("%s: unasked Hello %.2f ms after power-on\n", GetParam(), first_ms);
}

TEST_P(ReleaseImage, AnswersHelloWithItsSchema) {
  const auto reply = robot.connect();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->protocol_major, protocol::kProtocolMajor);
  EXPECT_EQ(reply->schema_digest, protocol::kSchemaDigest);
  EXPECT_EQ(reply->firmware_version, protocol::kFirmwareVersion);
  EXPECT_EQ(reply->tick_hz, 1000);
  EXPECT_GE(reply->receive_credit_bytes, 64);
}

TEST_P(ReleaseImage, StreamsOdometryAndAnswersEveryPing) {
  ASSERT_TRUE(robot.connect());
  robot.forget_heard();
  std::uint32_t pings = 0;
  robot.each_ms = [&] {
    if (robot.board().now_ns() / 1'000'000 % 10 == 0) {
      robot.send(protocol::Ping{++pings});
    }
  };
  robot.run_ms(1000);
  robot.each_ms = nullptr;
  robot.run_ms(10);
  const auto pongs = robot.all<protocol::Pong>();
  ASSERT_EQ(pongs.size(), pings);
  for (std::uint32_t i = 0; i < pings; ++i) {
    EXPECT_EQ(pongs[i].token, i + 1);
  }
  EXPECT_NEAR(double(robot.all<protocol::Odometry>().size()), 50.0, 1.0);
  EXPECT_EQ(robot.counters().frames_bad(), 0);
  EXPECT_EQ(robot.counters().frames_lost(), 0);
  const auto health = robot.last<protocol::Health>();
  ASSERT_TRUE(health);
  EXPECT_EQ(health->frames_bad, 0);
  EXPECT_EQ(health->frames_lost, 0);
  EXPECT_EQ(health->receive_overruns, 0);
}

class Reset : public OnEveryBoard {};

INSTANTIATE_TEST_SUITE_P(Boards, Reset, every_board(), image_label);

TEST_P(Reset, PowerCutStartsCountsAndSessionAnew) {
  const auto before = robot.connect();
  ASSERT_TRUE(before);
  robot.board().schedule_encoder_edge(runner::Wheel::kLeft, robot.board().now_ns(), true, false);
  robot.run_ms(30);
  ASSERT_EQ(robot.last<protocol::Odometry>()->left_ticks, 1);

  robot.forget_heard();
  robot.chip().cut_power();
  robot.run_ms(100);
  ASSERT_EQ(robot.heard().size(), 1U) << "telemetry before a host said Hello";
  EXPECT_EQ(robot.last<protocol::HelloReply>()->reset_cause, protocol::kResetPowerOn);
  EXPECT_EQ(robot.last<protocol::HelloReply>()->session, 0);
  EXPECT_NE(robot.last<protocol::HelloReply>()->boot_id, before->boot_id);
  ASSERT_TRUE(robot.connect(4712));
  robot.run_ms(30);
  EXPECT_EQ(robot.last<protocol::Odometry>()->left_ticks, 0) << "counts are since the reset";
}

TEST_P(Reset, ResetPinMakesANewBootAndForgetsArming) {
  const auto before = robot.connect();
  ASSERT_TRUE(before);
  ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  robot.chip().pull_reset_pin();
  const auto after = robot.connect();
  ASSERT_TRUE(after);
  EXPECT_EQ(after->reset_cause, protocol::kResetExternal);
  EXPECT_NE(after->boot_id, before->boot_id);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 100, 100, 500, 0}), CommandStatus::kDisarmed);
}

class Clock : public OnEveryBoard {};

INSTANTIATE_TEST_SUITE_P(Boards, Clock, every_board(), image_label);

TEST_P(Clock, OdometryComesOnTheTickAndTheStampIsSimulatedTime) {
  constexpr std::int64_t kPeriodUs = 20'000;
  constexpr std::int64_t kMaxLateUs = 250;
  ASSERT_TRUE(robot.connect());
  robot.forget_heard();
  robot.run_ms(5000);
  std::vector<std::int64_t> stamps_us;
  std::int64_t fastest_us = INT64_MAX;
  std::int64_t slowest_us = 0;
  for (const Heard& heard : robot.heard()) {
    if (const auto* sample = std::get_if<protocol::Odometry>(&heard.message)) {
      stamps_us.push_back(sample->stamp_us);
      EXPECT_GT(heard.at_ns / 1000, stamps_us.back());
      const std::int64_t delay_us = heard.at_ns / 1000 - stamps_us.back();
      fastest_us = std::min(fastest_us, delay_us);
      slowest_us = std::max(slowest_us, delay_us);
    }
  }
  ASSERT_NEAR(double(stamps_us.size()), 250.0, 1.0);
  std::int64_t worst_us = 0;
  for (std::size_t i = 0; i < stamps_us.size(); ++i) {
    const std::int64_t due_us = stamps_us[0] + std::int64_t(i) * kPeriodUs;
    worst_us = std::max(worst_us, std::abs(stamps_us[i] - due_us));
  }
  std::printf(
      "%s: odometry within %lld us of its period over 5 s, heard %lld to %lld us after it\n",
      GetParam(),
      static_cast<long long>(worst_us),
      static_cast<long long>(fastest_us),
      static_cast<long long>(slowest_us));
  EXPECT_LE(worst_us, kMaxLateUs);
  EXPECT_LT(fastest_us, 6000) << "the frame, and what passed before the robot's clock started";
  EXPECT_LT(slowest_us - fastest_us, 4000) << "a Status and a Health may be in front of it";
}

}  // namespace
}  // namespace echomap::tests
