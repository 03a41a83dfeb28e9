// SPDX-License-Identifier: MIT
#include "firmware/app/robot.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/firmware/native_robot.hpp"

namespace echomap::app {
namespace {

using protocol::CommandStatus;
using protocol::MotionOutcome;
using tests::NativeRobot;

std::uint8_t number(MotionOutcome outcome) { return static_cast<std::uint8_t>(outcome); }

/// Renews the motion every 100 ms until the robot says that it is over.
protocol::Status drive_to_the_end(NativeRobot& robot) {
  for (int i = 0; i < 200; ++i) {
    robot.send(protocol::KeepAlive{300});
    robot.run_ms(100);
    const protocol::Status status = robot.all<protocol::Status>().back();
    if (status.move_outcome != number(MotionOutcome::kRunning)) {
      return status;
    }
  }
  return {};
}

TEST(Robot, SaysThatItHasStarted) {
  NativeRobot robot;
  robot.run_ms(100);
  const auto replies = robot.all<protocol::HelloReply>();
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_EQ(replies[0].session, 0);
  EXPECT_EQ(robot.heard.size(), 1U) << "telemetry without a host";
}

TEST(Robot, DrivesAMoveOverTheWire) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 3000, -3000, 1500, 300}),
            CommandStatus::kAccepted);
  const protocol::Status status = drive_to_the_end(robot);
  EXPECT_EQ(status.move_id, robot.last_command_id());
  EXPECT_EQ(status.move_outcome, number(MotionOutcome::kReached));
  robot.run_ms(100);
  EXPECT_NEAR(robot.left_wheel.ticks(), 3000, 3);
  EXPECT_NEAR(robot.right_wheel.ticks(), -3000, 3);
  const protocol::Odometry last = robot.all<protocol::Odometry>().back();
  EXPECT_NEAR(last.left_ticks, robot.left_wheel.ticks(), 1);
  EXPECT_NEAR(last.right_ticks, robot.right_wheel.ticks(), 1);
}

TEST(Robot, WheelsRestSoonAfterTheHostFallsSilent) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 9000, 9000, 1500, 300}), CommandStatus::kAccepted);
  for (int i = 0; i < 10; ++i) {
    robot.send(protocol::KeepAlive{200});
    robot.run_ms(100);
  }
  robot.run_ms(98);
  EXPECT_NEAR(robot.left_wheel.ticks_per_s(), 1500.0, 100.0);
  robot.run_ms(2 + 128 + 5);
  EXPECT_EQ(robot.board.left_duty(), 0);
  robot.run_ms(200);
  EXPECT_EQ(robot.all<protocol::Status>().back().move_outcome, number(MotionOutcome::kExpired));
}

TEST(Robot, BumpCutsTheMotorsWithinTwoMilliseconds) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 9000, 9000, 1500, 500}), CommandStatus::kAccepted);
  robot.run_ms(300);
  ASSERT_GT(robot.board.left_duty(), 0);
  robot.board.set_bump(false, true);
  robot.run_ms(2);
  EXPECT_EQ(robot.board.left_duty(), 0);
  EXPECT_EQ(robot.board.right_duty(), 0);
  robot.run_ms(10);
  const protocol::Status status = robot.all<protocol::Status>().back();
  EXPECT_EQ(status.move_outcome, number(MotionOutcome::kBumped));
  EXPECT_EQ(status.flags, protocol::kFlagArmed | protocol::kFlagBumpLeft);
}

/// A robot whose bridges brake at duty 0, armed.
struct BrakingRobot : NativeRobot {
  BrakingRobot() {
    EXPECT_TRUE(arm());
    EXPECT_EQ(command(protocol::ConfigureWiring{0, 1, protocol::kBrakeAtZero, 0}),
              CommandStatus::kAccepted);
    EXPECT_FALSE(brakes()) << "before the first motion";
  }
  bool brakes() const { return board.left_brakes() || board.right_brakes(); }
  void begin_long_move() {
    ASSERT_EQ(command(protocol::MoveTicks{0, 9000, 9000, 1500, 500}), CommandStatus::kAccepted);
    run_ms(200);
    ASSERT_GT(board.left_duty(), 0);
  }
  bool is_off() const { return board.left_duty() == 0 && board.right_duty() == 0 && !brakes(); }
};

TEST(Robot, BrakesAfterAMotionUntilTheTimeToLiveIsOver) {
  BrakingRobot robot;
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 100, 100, 500, 500}), CommandStatus::kAccepted);
  for (int i = 0; i < 20; ++i) {
    robot.send(protocol::KeepAlive{500});
    robot.run_ms(100);
  }
  ASSERT_EQ(robot.all<protocol::Status>().back().move_outcome, number(MotionOutcome::kReached));
  EXPECT_TRUE(robot.board.left_brakes());
  EXPECT_TRUE(robot.board.right_brakes());
  robot.run_ms(450);
  EXPECT_TRUE(robot.is_off()) << "nobody is there";
}

TEST(Robot, EveryCutLeavesTheMotorsWithoutBrake) {
  BrakingRobot robot;
  robot.begin_long_move();
  robot.board.set_bump(true, true);
  robot.run_ms(2);
  EXPECT_TRUE(robot.is_off()) << "bump";
  robot.board.set_bump(true, false);
  robot.run_ms(100);

  robot.begin_long_move();
  ASSERT_EQ(robot.command(protocol::Stop{0}), CommandStatus::kAccepted);
  EXPECT_TRUE(robot.is_off()) << "Stop";

  robot.begin_long_move();
  robot.run_ms(800);
  EXPECT_TRUE(robot.is_off()) << "silence";

  robot.begin_long_move();
  ASSERT_EQ(robot.command(protocol::Arm{0, 0}), CommandStatus::kAccepted);
  EXPECT_TRUE(robot.is_off()) << "disarmed";
}

TEST(Robot, SweepsOverTheWireWithoutBeingArmed) {
  NativeRobot robot;
  robot.board.on_trigger = [&](std::int64_t at_ns) {
    robot.board.schedule_echo(at_ns + 460000, at_ns + 460000 + 5830000);
  };
  ASSERT_TRUE(robot.connect(1).has_value());
  ASSERT_EQ(robot.command(protocol::StartSweep{0, -3000, 3000, 600, 40}), CommandStatus::kAccepted);
  robot.run_ms(3000);
  const auto echoes = robot.all<protocol::Echo>();
  ASSERT_EQ(echoes.size(), 11U);
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    EXPECT_EQ(echoes[i].pan_cdeg, -3000 + 600 * static_cast<int>(i));
    EXPECT_EQ(echoes[i].flight_us, 5830);
  }
  EXPECT_EQ(robot.all<protocol::Status>().back().sweep_outcome, number(MotionOutcome::kReached));
}

TEST(Robot, EveryPowerOnIsTheSame) {
  NativeRobot robot;
  std::vector<std::vector<std::uint8_t>> runs;
  for (int run = 0; run < 3; ++run) {
    robot.power_on();
    ASSERT_TRUE(robot.arm());
    ASSERT_EQ(robot.command(protocol::MoveTicks{0, 500, 300, 1500, 500}), CommandStatus::kAccepted);
    ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 3000, 600, 40}), CommandStatus::kAccepted);
    robot.run_ms(700 + 100 * run);
    runs.push_back(robot.bytes);
  }
  ASSERT_GE(runs[0].size(), 500U);
  runs[1].resize(runs[0].size());
  runs[2].resize(runs[0].size());
  EXPECT_EQ(runs[0], runs[1]);
  EXPECT_EQ(runs[0], runs[2]);
}

TEST(Robot, IsDisarmedAfterAReset) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  robot.power_on();
  ASSERT_TRUE(robot.connect(1).has_value());
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 10, 10, 100, 200}), CommandStatus::kDisarmed);
}

TEST(Robot, KicksTheWatchdogAllTheTime) {
  NativeRobot robot;
  robot.run_ms(1000);
  EXPECT_GE(robot.board.watchdog_kicks(), 200U);
}

TEST(Robot, SurvivesAnyBytes) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  std::uint32_t bits = 1;
  for (int i = 0; i < 2000; ++i) {
    bits = bits * 1664525U + 1013904223U;
    const auto byte = static_cast<std::uint8_t>(bits >> 24);
    robot.board.receive(&byte, 1);
  }
  robot.run_ms(300);
  const std::uint8_t delimiter = 0;
  robot.board.receive(&delimiter, 1);
  EXPECT_EQ(robot.command(protocol::Stop{0}), CommandStatus::kAccepted);
  robot.run_ms(1000);
  EXPECT_GT(robot.all<protocol::Health>().back().frames_bad, 0);
}

TEST(Robot, MotorTheWrongWayRoundStopsAndDisarms) {
  NativeRobot robot;
  ASSERT_TRUE(robot.arm());
  protocol::ConfigureDrive drive = kDefaultDrive;
  drive.inversions = protocol::kInvertRightMotor;
  ASSERT_EQ(robot.command(drive), CommandStatus::kAccepted);
  robot.send(protocol::DriveSetpoint{500, 500, 500});
  robot.run_ms(400);
  robot.send(protocol::KeepAlive{500});
  robot.run_ms(400);
  const protocol::Status status = robot.all<protocol::Status>().back();
  EXPECT_EQ(status.move_outcome, number(MotionOutcome::kRunaway));
  EXPECT_EQ(status.flags & (protocol::kFlagArmed | protocol::kFlagMoving), 0);
  EXPECT_GT(robot.right_wheel.ticks(), -600) << "stopped on its way";
}

TEST(Robot, BlockedWheelStopsButStaysArmed) {
  NativeRobot robot;
  robot.left_wheel.blocked = true;
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 9000, 9000, 1000, 500}), CommandStatus::kAccepted);
  const protocol::Status status = drive_to_the_end(robot);
  EXPECT_EQ(status.move_outcome, number(MotionOutcome::kStalled));
  EXPECT_TRUE((status.flags & protocol::kFlagArmed) != 0);
  EXPECT_EQ(robot.board.left_duty(), 0);
}

}  // namespace
}  // namespace echomap::app
