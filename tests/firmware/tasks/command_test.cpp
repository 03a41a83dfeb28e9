// SPDX-License-Identifier: MIT
#include "firmware/tasks/command.hpp"

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "protocol/config_digest.hpp"
#include "tests/firmware/native_robot.hpp"

namespace echomap::tasks {
namespace {

using protocol::CommandStatus;
using protocol::MotionOutcome;
using tests::NativeRobot;

constexpr protocol::MoveTicks kLongMove{0, 5000, 5000, 1000, 500};

TEST(Command, GreetsAHostWithItsSessionAfterADelimiter) {
  NativeRobot robot;
  robot.run_ms(10);
  robot.bytes.clear();
  const auto reply = robot.connect(4711);
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(robot.bytes[0], 0);
  EXPECT_EQ(reply->schema_digest, protocol::kSchemaDigest);
  EXPECT_EQ(reply->receive_credit_bytes, drivers::SerialPort::kReceiveBytes);
  EXPECT_EQ(reply->tick_hz, 1000);
}

TEST(Command, RepliesWithTheDigestOfTheConfigurationThatHolds) {
  NativeRobot robot;
  protocol::Configuration expected = app::kDefaultConfiguration;
  EXPECT_EQ(robot.connect(1)->config_digest, protocol::config_digest(expected));
  expected.drive.inversions = protocol::kInvertLeftMotor;
  ASSERT_EQ(robot.command(expected.drive), CommandStatus::kAccepted);
  EXPECT_EQ(robot.connect(1)->config_digest, protocol::config_digest(expected));
  expected.sonar.ping_gap_ms = 55;
  expected.pan.deg_per_s = 250;
  ASSERT_EQ(robot.command(expected.sonar), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(expected.pan), CommandStatus::kAccepted);
  EXPECT_EQ(robot.connect(1)->config_digest, protocol::config_digest(expected));
  protocol::ConfigureSonar refused = expected.sonar;
  refused.max_echo_us = 0;
  ASSERT_EQ(robot.command(refused), CommandStatus::kOutOfRange);
  EXPECT_EQ(robot.connect(1)->config_digest, protocol::config_digest(expected));
  robot.power_on();
  EXPECT_EQ(robot.connect(1)->config_digest, protocol::config_digest(app::kDefaultConfiguration));
}

TEST(Command, AnswersPingWithItsTokenAndTheTime) {
  NativeRobot robot;
  robot.run_ms(100);
  robot.send(protocol::Ping{0xABCD1234U});
  robot.run_ms(10);
  const auto pongs = robot.all<protocol::Pong>();
  ASSERT_EQ(pongs.size(), 1U);
  EXPECT_EQ(pongs[0].token, 0xABCD1234U);
  EXPECT_GE(pongs[0].stamp_us, 100000U);
  EXPECT_LE(pongs[0].stamp_us, 102000U);
}

TEST(Command, NobodyArmsARobotThatNobodyGreeted) {
  NativeRobot robot;
  EXPECT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kDisarmed);
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kDisarmed);
  ASSERT_TRUE(robot.connect(1).has_value());
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kDisarmed);
  EXPECT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
}

TEST(Command, NobodyIsObeyedBeforeHello) {
  NativeRobot robot;
  EXPECT_EQ(robot.command(app::kDefaultDrive), CommandStatus::kDisarmed);
  EXPECT_EQ(robot.command(protocol::StartSweep{0, 0, 0, 0, 0}), CommandStatus::kDisarmed);
  ASSERT_TRUE(robot.connect(1).has_value());
  EXPECT_EQ(robot.command(app::kDefaultDrive), CommandStatus::kAccepted);
}

TEST(Command, WithoutAnIdIsNotDone) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  robot.send(protocol::Arm{0, 0});
  robot.run_ms(20);
  const auto ack = robot.all<protocol::Ack>().back();
  EXPECT_EQ(ack.command_id, 0);
  EXPECT_EQ(ack.status, static_cast<std::uint8_t>(CommandStatus::kOutOfRange));
  robot.run_ms(300);
  EXPECT_NE(robot.all<protocol::Status>().back().flags & protocol::kFlagArmed, 0);
}

TEST(Command, DoesACommandOnceHoweverOftenItComes) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 100, 100, 1000, 500}), CommandStatus::kAccepted);
  robot.run_ms(400);
  robot.send(protocol::KeepAlive{500});
  robot.run_ms(400);
  ASSERT_NEAR(robot.left_wheel.ticks(), 100, 3);
  const protocol::MoveTicks again{robot.last_command_id(), 100, 100, 1000, 500};
  const std::int64_t from_ns = robot.board.now_ns();
  for (int i = 0; i < 5; ++i) {
    robot.send(again);
    robot.run_ms(20);
  }
  EXPECT_EQ(robot.all<protocol::Ack>(from_ns).size(), 5U);
  robot.run_ms(500);
  EXPECT_NEAR(robot.left_wheel.ticks(), 100, 3);
}

TEST(Command, TakeOverForgetsIdsAndStopsAndDisarms) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
  const std::uint8_t id = robot.last_command_id();
  robot.send(protocol::TakeOver{2});
  robot.run_ms(20);
  EXPECT_EQ(robot.all<protocol::HelloReply>().back().session, 2);
  EXPECT_EQ(robot.board.left_duty(), 0);
  const std::int64_t from_ns = robot.board.now_ns();
  robot.send(protocol::MoveTicks{id, 100, 100, 1000, 500});
  robot.run_ms(20);
  const auto acks = robot.all<protocol::Ack>(from_ns);
  ASSERT_EQ(acks.size(), 1U);
  EXPECT_EQ(acks[0].status, static_cast<std::uint8_t>(CommandStatus::kDisarmed));
}

TEST(Command, RepeatedHelloChangesNothing) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
  ASSERT_TRUE(robot.connect(1).has_value());
  robot.run_ms(100);
  EXPECT_GT(robot.board.left_duty(), 0);
}

/// What a robot replies to the Hello of this session.
std::uint16_t reply_to(NativeRobot& robot, std::uint16_t session) {
  const std::int64_t from_ns = robot.board.now_ns();
  robot.connect(session);
  const auto replies = robot.all<protocol::HelloReply>(from_ns);
  return replies.size() == 1 ? replies[0].session : std::uint16_t{0};
}

TEST(Command, NamesTheSessionThatHoldsTheRobotAHundredTimes) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 30000, 30000, 1000, 500}),
            CommandStatus::kAccepted);
  const auto repeat = robot.last_command_id();
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(reply_to(robot, static_cast<std::uint16_t>(1000 + i)), 1);
    robot.send(protocol::KeepAlive{200});
    robot.run_ms(20);
    ASSERT_GT(robot.board.left_duty(), 0);
  }
  const std::int64_t from_ns = robot.board.now_ns();
  robot.send(protocol::MoveTicks{repeat, 30000, 30000, 1000, 500});
  robot.run_ms(1200);
  EXPECT_EQ(robot.all<protocol::Ack>(from_ns).back().status,
            static_cast<std::uint8_t>(CommandStatus::kAccepted))
      << "the last command is remembered";
  EXPECT_NE(robot.all<protocol::Status>(from_ns).back().flags & protocol::kFlagArmed, 0);
}

TEST(Command, ARefusedHelloCountsForNothing) {
  NativeRobot robot;
  ASSERT_TRUE(robot.connect(1).has_value());
  protocol::FrameEncoder encoder;
  for (int i = 0; i < 24; ++i) {
    const protocol::ByteSpan hello = encoder.encode(protocol::Hello{1, 3, 0, 2}, 77);
    robot.board.receive(hello.data, hello.size);
    robot.send(protocol::KeepAlive{200});
    robot.run_ms(50);
  }
  EXPECT_EQ(robot.all<protocol::HelloReply>().back().session, 1);
  EXPECT_EQ(robot.all<protocol::Health>().back().frames_lost, 0);
}

TEST(Command, ASessionThatIsSilentForTwoAndAHalfSecondsHoldsNoRobot) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  robot.run_ms(1950);
  EXPECT_EQ(reply_to(robot, 2), 1) << "it needs a ping a second, of which one may be lost";
  for (int i = 0; i < 9; ++i) {
    EXPECT_EQ(reply_to(robot, 2), 1) << "asking does not keep it alive";
    robot.run_ms(20);
  }
  robot.run_ms(300);
  EXPECT_EQ(reply_to(robot, 2), 2);
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kDisarmed);
  EXPECT_EQ(reply_to(robot, 1), 2) << "the new one holds it";
}

TEST(Command, ASessionThatIsHeardAgainHoldsTheRobotAgain) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  robot.run_ms(4000);
  robot.send(protocol::Ping{1});
  robot.run_ms(20);
  EXPECT_EQ(reply_to(robot, 2), 1);
}

TEST(Command, ASessionThatDisarmsGivesTheRobotUp) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::Arm{0, 0}), CommandStatus::kAccepted);
  robot.send(protocol::Ping{1});
  robot.run_ms(20);
  EXPECT_EQ(reply_to(robot, 2), 2);
  ASSERT_EQ(robot.command(protocol::Arm{0, 0}), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  EXPECT_EQ(reply_to(robot, 1), 2) << "who arms it again keeps it";
}

TEST(Command, AFloodOfPingsLeavesOdometryItsPlace) {
  NativeRobot robot;
  ASSERT_TRUE(robot.connect(1).has_value());
  const std::int64_t from_ns = robot.board.now_ns();
  for (int ms = 0; ms < 2000; ++ms) {
    for (int byte = 0; byte < 1'000'000 / native::NativeBoard::kByteNs; byte += 10) {
      robot.send(protocol::Ping{1});
    }
    robot.run_ms(1);
  }
  const int due = 2000 / app::kDefaultDrive.odometry_period_ms;
  EXPECT_GE(robot.all<protocol::Odometry>(from_ns).size(), static_cast<std::size_t>(due * 9 / 10));
  EXPECT_GE(robot.all<protocol::Pong>(from_ns).size(), 3000U) << "the rest is theirs";
}

TEST(Command, RefusesWhatIsBusyOrOutOfRange) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 10, 10, 1000, 501}), CommandStatus::kOutOfRange);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 10, 10, 0, 500}), CommandStatus::kOutOfRange);
  ASSERT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kBusy);
  EXPECT_EQ(robot.command(app::kDefaultDrive), CommandStatus::kBusy);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 9000, 600, 40}), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(protocol::StartSweep{0, 0, 9000, 600, 40}), CommandStatus::kBusy);
  EXPECT_EQ(robot.command(app::kDefaultSonar), CommandStatus::kBusy);
  ASSERT_EQ(robot.command(protocol::Stop{0}), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(protocol::StartSweep{0, 0, 9001, 600, 40}), CommandStatus::kOutOfRange);
  protocol::ConfigureDrive drive = app::kDefaultDrive;
  drive.max_ticks_per_s2 = 0;
  EXPECT_EQ(robot.command(drive), CommandStatus::kOutOfRange);
  protocol::ConfigureSonar sonar = app::kDefaultSonar;
  sonar.max_echo_us = 0;
  EXPECT_EQ(robot.command(sonar), CommandStatus::kOutOfRange);
}

TEST(Command, StopEndsMoveAndSweepAndStaysArmed) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 9000, 600, 40}), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::Stop{0}), CommandStatus::kAccepted);
  EXPECT_EQ(robot.board.left_duty(), 0);
  const protocol::Status status = robot.all<protocol::Status>().back();
  EXPECT_EQ(status.flags, protocol::kFlagArmed);
  EXPECT_EQ(status.move_outcome, static_cast<std::uint8_t>(MotionOutcome::kStopped));
  EXPECT_EQ(status.sweep_outcome, static_cast<std::uint8_t>(MotionOutcome::kStopped));
}

TEST(Command, DisarmStopsTheWheelsAndTheSweep) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 9000, 600, 40}), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::Arm{0, 0}), CommandStatus::kAccepted);
  EXPECT_EQ(robot.board.left_duty(), 0);
  EXPECT_EQ(robot.all<protocol::Status>().back().sweep_outcome,
            static_cast<std::uint8_t>(MotionOutcome::kStopped));
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kDisarmed);
}

TEST(Command, SetPointsDriveOnlyArmedRobotsAndOnlyWithAValidTimeToLive) {
  NativeRobot robot;
  ASSERT_TRUE(robot.connect(1).has_value());
  robot.send(protocol::DriveSetpoint{500, 500, 200});
  robot.run_ms(100);
  EXPECT_EQ(robot.left_wheel.ticks(), 0);
  ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  robot.send(protocol::DriveSetpoint{500, 500, 501});
  robot.run_ms(100);
  EXPECT_EQ(robot.left_wheel.ticks(), 0);
  robot.send(protocol::DriveSetpoint{500, 500, 500});
  robot.run_ms(400);
  EXPECT_GT(robot.left_wheel.ticks(), 50);
}

TEST(Command, SetPointsOfABlockedWheelWaitForStopOrArm) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  robot.left_wheel.blocked = true;
  const auto stream = [&robot] {
    int driven_ms = 0;
    for (int ms = 0; ms < 2000; ms += 20) {
      robot.send(protocol::DriveSetpoint{1000, 1000, 200});
      robot.run_ms(20);
      driven_ms += robot.board.left_duty() != 0 ? 20 : 0;
    }
    return driven_ms;
  };
  EXPECT_LE(stream(), 400) << "stall_ms is 300";
  EXPECT_EQ(stream(), 0);
  ASSERT_EQ(robot.command(protocol::Stop{0}), CommandStatus::kAccepted);
  EXPECT_GT(stream(), 0);
  EXPECT_EQ(stream(), 0);
  ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  EXPECT_GT(stream(), 0);
}

TEST(Command, PressedContactBlocksForwardAndLetsBack) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  robot.board.set_bump(true, true);
  robot.run_ms(2);
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kBlocked);
  robot.send(protocol::DriveSetpoint{500, 500, 500});
  robot.run_ms(100);
  EXPECT_EQ(robot.left_wheel.ticks(), 0);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, -100, -100, 500, 500}), CommandStatus::kAccepted);
  robot.run_ms(300);
  EXPECT_LT(robot.left_wheel.ticks(), -20);
}

protocol::ConfigureWiring wiring_of(protocol::MotorBridgeKind kind, unsigned options = 0) {
  return {0, static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(options), 0};
}

TEST(Command, TakesTheWiringOfEveryKindAndHoldsIt) {
  NativeRobot robot;
  protocol::Configuration expected = app::kDefaultConfiguration;
  ASSERT_TRUE(robot.connect(1).has_value());
  for (const auto kind : {protocol::MotorBridgeKind::kTwoPwm,
                          protocol::MotorBridgeKind::kIn1In2Pwm,
                          protocol::MotorBridgeKind::kServo,
                          protocol::MotorBridgeKind::kPhaseEnable}) {
    expected.wiring = wiring_of(kind);
    expected.wiring.contacts_normally_closed = 3;
    ASSERT_EQ(robot.command(expected.wiring), CommandStatus::kAccepted);
    EXPECT_EQ(static_cast<int>(robot.board.bridge_kind()), static_cast<int>(kind));
    EXPECT_EQ(robot.connect(1)->config_digest, protocol::config_digest(expected));
  }
}

TEST(Command, RefusesWiringThatThereIsNot) {
  NativeRobot robot;
  ASSERT_TRUE(robot.connect(1).has_value());
  for (const protocol::ConfigureWiring& wiring : {protocol::ConfigureWiring{0, 4, 0, 0},
                                                  protocol::ConfigureWiring{0, 1, 4, 0},
                                                  protocol::ConfigureWiring{0, 1, 0, 4},
                                                  protocol::ConfigureWiring{0, 0, 1, 0}}) {
    EXPECT_EQ(robot.command(wiring), CommandStatus::kOutOfRange);
  }
  EXPECT_EQ(robot.board.bridge_kind(), hal::BridgeKind::kPhaseEnable);
}

TEST(Command, ABridgesPinsAreNoSparePinsAndTheOtherWayRound) {
  NativeRobot robot;
  ASSERT_TRUE(robot.connect(1).has_value());
  const auto three_wires = wiring_of(protocol::MotorBridgeKind::kIn1In2Pwm);
  protocol::ConfigurePins pins{};
  pins.pin_1 = protocol::kPinWall;
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(three_wires), CommandStatus::kOutOfRange);
  ASSERT_EQ(robot.command(protocol::ConfigurePins{}), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(three_wires), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(pins), CommandStatus::kOutOfRange);
  ASSERT_EQ(robot.command(wiring_of(protocol::MotorBridgeKind::kTwoPwm)), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(pins), CommandStatus::kAccepted);
}

TEST(Command, TakesNoWiringWhileTheWheelsTurn) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(wiring_of(protocol::MotorBridgeKind::kTwoPwm)), CommandStatus::kBusy);
  EXPECT_GT(robot.board.left_duty(), 0);
}

/// Until the robot knows of its wiring it takes a contact at rest for a press; then for none at
/// once.
TEST(Command, ContactsMayBeNormallyClosed) {
  NativeRobot robot;
  robot.board.set_bump(false, true);
  robot.board.set_bump(true, true);
  ASSERT_TRUE(robot.arm());
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kBlocked);
  protocol::ConfigureWiring wiring{};
  wiring.contacts_normally_closed = hal::kContactLeft | hal::kContactRight;
  ASSERT_EQ(robot.command(wiring), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(kLongMove), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(wiring), CommandStatus::kBusy);
  robot.run_ms(100);
  ASSERT_GT(robot.left_wheel.ticks(), 0);
  robot.board.set_bump(true, false);
  robot.run_ms(2);
  EXPECT_EQ(robot.board.left_duty(), 0) << "a broken wire is a bump";
  EXPECT_EQ(robot.command(kLongMove), CommandStatus::kBlocked);
  robot.board.set_bump(true, true);
  robot.run_ms(100);
  wiring.contacts_normally_closed = 4;
  EXPECT_EQ(robot.command(wiring), CommandStatus::kOutOfRange);
}

TEST(Command, CountsDamagedAndMissingFrames) {
  NativeRobot robot;
  ASSERT_TRUE(robot.connect(1).has_value());
  protocol::FrameEncoder encoder;
  const auto send_numbered = [&](std::uint8_t seq, bool damaged) {
    const protocol::ByteSpan span = encoder.encode(protocol::Ping{1}, seq);
    std::vector<std::uint8_t> frame(span.data, span.data + span.size);
    frame[4] = static_cast<std::uint8_t>(frame[4] ^ (damaged ? 0x40U : 0U));
    robot.board.receive(frame.data(), frame.size());
  };
  send_numbered(1, false);
  send_numbered(2, true);
  send_numbered(5, false);
  robot.run_ms(1050);
  const protocol::Health health = robot.all<protocol::Health>().back();
  EXPECT_EQ(health.frames_bad, 1);
  EXPECT_EQ(health.frames_lost, 3);
}

}  // namespace
}  // namespace echomap::tasks
