// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_counters.hpp"

#include <gtest/gtest.h>

#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {
namespace {

LinkStatistics told_by(const RobotCounters& counters) {
  LinkStatistics statistics;
  counters.add_to(statistics);
  return statistics;
}

protocol::Health with_errors(std::uint16_t encoder_errors) {
  protocol::Health health{};
  health.encoder_errors = encoder_errors;
  return health;
}

TEST(RobotCounters, HoldEachOfTheRobots) {
  RobotCounters counters;
  protocol::Health health{};
  health.frames_bad = 1;
  health.frames_lost = 2;
  health.receive_overruns = 3;
  health.telemetry_dropped = 4;
  health.encoder_errors = 5;
  health.stack_free_bytes = 600;
  health.rate_step = 2;
  counters.take(health);
  const LinkStatistics statistics = told_by(counters);
  EXPECT_EQ(statistics.robot_frames_bad, 1U);
  EXPECT_EQ(statistics.robot_frames_lost, 2U);
  EXPECT_EQ(statistics.robot_receive_overruns, 3U);
  EXPECT_EQ(statistics.robot_telemetry_dropped, 4U);
  EXPECT_EQ(statistics.robot_encoder_errors, 5U);
  EXPECT_EQ(statistics.robot_stack_free_bytes, 600);
  EXPECT_EQ(statistics.robot_rate_step, 2);
}

TEST(RobotCounters, GoOnBeyondSixteenBitsAndBeyondResets) {
  RobotCounters counters;
  counters.take(with_errors(65'000));
  counters.take(with_errors(1000));
  EXPECT_EQ(told_by(counters).robot_encoder_errors, 66'536U);
  counters.restart();
  counters.take(with_errors(7));
  EXPECT_EQ(told_by(counters).robot_encoder_errors, 66'543U);
}

TEST(RobotCounters, HoldTheErrorsOfEachEncoderBeyondResets) {
  RobotCounters counters;
  counters.take(protocol::EncoderErrors{0, 65'000, 3});
  counters.take(protocol::EncoderErrors{0, 1000, 3});
  counters.restart();
  counters.take(protocol::EncoderErrors{0, 7, 2});
  EXPECT_EQ(told_by(counters).robot_left_encoder_errors, 66'543U);
  EXPECT_EQ(told_by(counters).robot_right_encoder_errors, 5U);
}

TEST(RobotCounters, HoldNoEncoderErrorsOfABoardThatCannotSeeThem) {
  RobotCounters counters;
  counters.take_capabilities(protocol::kCapabilityWheels | protocol::kCapabilityBlindEncoders);
  counters.take(protocol::Health{});
  EXPECT_FALSE(told_by(counters).robot_encoder_errors);
  EXPECT_FALSE(told_by(counters).robot_left_encoder_errors);
  EXPECT_FALSE(told_by(counters).robot_right_encoder_errors);
  counters.take_capabilities(protocol::kCapabilityWheels);
  EXPECT_EQ(told_by(counters).robot_encoder_errors, 0U);
}

TEST(RobotCounters, KeepTheLeastStackThatIsKnown) {
  RobotCounters counters;
  EXPECT_FALSE(told_by(counters).robot_stack_free_bytes);
  for (const int free_bytes : {0, 700, 650, 0, 690}) {
    protocol::Health health{};
    health.stack_free_bytes = static_cast<std::uint16_t>(free_bytes);
    counters.take(health);
  }
  EXPECT_EQ(told_by(counters).robot_stack_free_bytes, 650);
}

}  // namespace
}  // namespace echomap::robot_link
