// SPDX-License-Identifier: MIT
// The EV3's release ELF under qemu-arm, without a body: what holds for every board, and that its
// guard stops the motors when the robot's program is no more.
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "protocol/version.hpp"
#include "tests/hil/measure/robot_on_the_move.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

const char* const image = "echomap-ev3";

TEST(Ev3Release, SaysHelloUnaskedAndAnswersWithItsSchema) {
  RobotSession robot(release_image(image));
  robot.run_ms(50);
  const auto unasked = robot.last<protocol::HelloReply>();
  ASSERT_TRUE(unasked);
  EXPECT_EQ(unasked->session, 0);
  EXPECT_EQ(unasked->reset_cause, protocol::kResetPowerOn);
  const auto reply = robot.connect();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->schema_digest, protocol::kSchemaDigest);
  EXPECT_EQ(reply->firmware_version, protocol::kFirmwareVersion);
}

TEST(Ev3Release, HasNoPinForAScalarSensorAndSaysSo) {
  RobotSession robot(release_image(image));
  const auto reply = robot.connect();
  ASSERT_TRUE(reply);
  EXPECT_FALSE((reply->capabilities & protocol::kCapabilityScalar) != 0);
  protocol::ConfigurePins pins{};
  pins.pin_0 = protocol::kPinScalarPulses;
  EXPECT_EQ(robot.command(pins), CommandStatus::kOutOfRange);
  pins.pin_0 = protocol::kPinScalarLevel;
  EXPECT_EQ(robot.command(pins), CommandStatus::kOutOfRange);
}

TEST(Ev3Release, TellsTheSameBytesAtTheSameTimes) {
  const auto run = [] {
    RobotOnTheMove robot(release_image(image));
    robot.drive();
    return robot.robot.bytes();
  };
  const auto first = run();
  EXPECT_GT(first.size(), 500U);
  EXPECT_TRUE(first == run());
}

class MovingBrick : public RobotOnTheMove, public ::testing::Test {
 protected:
  MovingBrick() : RobotOnTheMove(release_image(image)) {}

  /// The guard has stopped the motors, and the program that has started again is not armed.
  void expect_stopped(const HangOutcome& outcome, const char* what) {
    std::printf("%s: motors off %.1f ms, program anew %.1f ms after it\n",
                what,
                outcome.off_ms,
                outcome.reset_ms);
    RecordProperty("off_ms", std::to_string(outcome.off_ms));
    EXPECT_LE(outcome.off_ms, 150.0);
    EXPECT_LE(outcome.reset_ms, 400.0);
    EXPECT_TRUE(outcome.stayed_off);
    EXPECT_EQ(outcome.reset_cause, protocol::kResetWatchdog);
    ASSERT_TRUE(robot.connect(4712));
    EXPECT_EQ(robot.command(protocol::MoveTicks{0, 100, 100, 500, 0}), CommandStatus::kDisarmed);
  }
};

TEST_F(MovingBrick, StopsWithinTimeToLiveAndRampOnceTheHostIsSilent) {
  drive();
  renewing = false;
  robot.send(protocol::KeepAlive{kTimeToLiveMs});
  const double ms = ms_until_off(1500);
  std::printf("motors off %.1f ms after the last KeepAlive\n", ms);
  EXPECT_GT(ms, kTimeToLiveMs - 2.0);
  // 64 ms of ramp, two of USB's milliseconds, a period of tick and control each.
  EXPECT_LE(ms, kTimeToLiveMs + 64.0 + 2.0 + 10.0);
}

TEST_F(MovingBrick, StopsWithinFourMillisecondsOfABump) {
  drive();
  robot.board().set_bump(runner::Wheel::kLeft, true);
  const double ms = ms_until_off(150);
  std::printf("motors off %.1f ms after a bump\n", ms);
  EXPECT_LE(ms, 4.0);
}

TEST_F(MovingBrick, StopsWithin150MillisecondsOfAHang) {
  drive();
  robot.chip().hang();
  expect_stopped(outcome_of_hang(), "hang");
}

TEST_F(MovingBrick, StopsWithin150MillisecondsOfACrash) {
  drive();
  robot.chip().crash();
  expect_stopped(outcome_of_hang(), "kill -9");
}

}  // namespace
}  // namespace echomap::tests
