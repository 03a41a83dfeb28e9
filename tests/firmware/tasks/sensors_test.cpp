// SPDX-License-Identifier: MIT
#include "firmware/tasks/sensors.hpp"

#include <gtest/gtest.h>

#include "protocol/limits.hpp"
#include "tests/firmware/native_robot.hpp"

namespace echomap::tasks {
namespace {

using echomap::tests::NativeRobot;
using protocol::CommandStatus;
using protocol::MotionOutcome;

std::uint8_t number(MotionOutcome outcome) { return static_cast<std::uint8_t>(outcome); }

/// A robot with its hazards, two range channels, battery and gyro connected.
class SensorsTest : public testing::Test {
 protected:
  SensorsTest() {
    pins.pin_0 = protocol::kPinCliffLeft;
    pins.pin_1 = protocol::kPinWheelDrop | protocol::kPinActiveHigh;
    pins.pin_2 = protocol::kPinRange0;
    pins.pin_3 = protocol::kPinRange0 + 7;
    pins.pin_4 = protocol::kPinBattery;
    robot.board.set_aux_level(1, false);
    robot.board.set_aux_analog(2, 100);
    robot.board.set_aux_analog(3, 800);
    robot.board.set_aux_analog(4, 700);
    robot.board.two_wire.on_write = [](auto, auto, auto) { return true; };
    robot.board.two_wire.on_read = [](auto, auto) { return std::int16_t{250}; };
  }
  ~SensorsTest() override {
    robot.board.two_wire = native::NativeTwoWire();
    robot.board.set_aux_level(0, true);
    robot.board.set_aux_level(1, true);
  }

  NativeRobot robot;
  protocol::ConfigurePins pins{};
};

TEST_F(SensorsTest, RangesBatteryAndGyroReachTheHost) {
  ASSERT_TRUE(robot.connect(1).has_value());
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::ConfigureSensors{0, 40, 10, 2}), CommandStatus::kAccepted);
  robot.run_ms(2000);
  const protocol::Ranges ranges = robot.all<protocol::Ranges>().back();
  EXPECT_EQ(ranges.channel_0, 100);
  EXPECT_EQ(ranges.channel_1, protocol::kNoRange);
  EXPECT_EQ(ranges.channel_7, 800);
  EXPECT_EQ(robot.all<protocol::Health>().back().battery_raw, 700);
  const protocol::Gyro gyro = robot.all<protocol::Gyro>().back();
  EXPECT_NEAR(gyro.samples, 200, 5);
  EXPECT_EQ(gyro.yaw_sum, 250 * (gyro.samples - gyro.errors));
}

TEST_F(SensorsTest, GreetingSaysWhatTheBoardCanDo) {
  const auto reply = robot.connect(1);
  ASSERT_TRUE(reply.has_value());
  for (const protocol::Capability one : {protocol::kCapabilityPins,
                                         protocol::kCapabilityRanges,
                                         protocol::kCapabilityGyro,
                                         protocol::kCapabilityStepper,
                                         protocol::kCapabilityScalar}) {
    EXPECT_TRUE((reply->capabilities & one) != 0) << one;
  }
  EXPECT_FALSE((reply->capabilities & protocol::kCapabilityBlindEncoders) != 0);
}

TEST_F(SensorsTest, RefusesWhatNoBoardCanDo) {
  ASSERT_TRUE(robot.connect(1).has_value());
  pins.pin_9 = 11;
  EXPECT_EQ(robot.command(pins), CommandStatus::kOutOfRange);
  EXPECT_EQ(robot.command(protocol::ConfigureSensors{0, 0, 10, 4}), CommandStatus::kOutOfRange);
  EXPECT_EQ(robot.command(protocol::ConfigureSafety{0, 0, protocol::kMaxStallMs + 1, 0, 0}),
            CommandStatus::kOutOfRange);
}

TEST_F(SensorsTest, PulsesAreCountedOneByOneAndSummedUpSinceTheReset) {
  protocol::ConfigurePins tube{};
  tube.pin_5 = protocol::kPinScalarPulses;
  ASSERT_TRUE(robot.connect(1).has_value());
  ASSERT_EQ(robot.command(tube), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::ConfigureScalar{0, 100}), CommandStatus::kAccepted);
  const std::int64_t begin_ns = robot.board.now_ns();
  constexpr int kPulses = 1000;
  for (int i = 0; i < kPulses; ++i) {
    const std::int64_t fall_ns = begin_ns + std::int64_t{i} * 997000;
    robot.board.schedule_aux_pulse(5, fall_ns, fall_ns + 100000);
  }
  robot.run_ms(1200);
  const auto told = robot.all<protocol::Scalar>();
  EXPECT_NEAR(double(told.size()), 12.0, 1.0);
  EXPECT_EQ(told.back().sum, unsigned{kPulses});
  EXPECT_EQ(told.back().samples, 0);
  for (std::size_t i = 1; i < told.size(); ++i) {
    const double passed_s = 1e-6 * (told[i].stamp_us - told[i - 1].stamp_us);
    const double pulses = told[i].sum - told[i - 1].sum;
    EXPECT_LE(pulses, passed_s / 997e-6 + 2.0);
  }
}

TEST_F(SensorsTest, LevelIsSummedUpWithTheNumberOfItsConversions) {
  protocol::ConfigurePins light{};
  light.pin_5 = protocol::kPinScalarLevel;
  robot.board.set_aux_analog(5, 321);
  ASSERT_TRUE(robot.connect(1).has_value());
  ASSERT_EQ(robot.command(light), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::ConfigureScalar{0, 50}), CommandStatus::kAccepted);
  robot.run_ms(1000);
  const protocol::Scalar last = robot.all<protocol::Scalar>().back();
  EXPECT_NEAR(last.samples, 1000, 60);
  EXPECT_EQ(last.sum, 321U * last.samples);
}

TEST_F(SensorsTest, ScalarSensorIsSilentWithoutAPeriodAndRefusesALongOne) {
  ASSERT_TRUE(robot.connect(1).has_value());
  EXPECT_EQ(robot.command(protocol::ConfigureScalar{0, protocol::kMaxScalarPeriodMs + 1}),
            CommandStatus::kOutOfRange);
  EXPECT_EQ(robot.command(protocol::ConfigureScalar{0, protocol::kMaxScalarPeriodMs}),
            CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(protocol::ConfigureScalar{0, 0}), CommandStatus::kAccepted);
  robot.run_ms(3000);
  EXPECT_TRUE(robot.all<protocol::Scalar>().empty());
}

TEST_F(SensorsTest, GyroAndSparePinsCannotBothHaveThePinsOfTheBus) {
  constexpr protocol::ConfigureSensors kGyroOn{0, 0, 10, 2};
  robot.board.twi_aux_pins = 1U << 3 | 1U << 4;
  ASSERT_TRUE(robot.connect(1).has_value());
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(kGyroOn), CommandStatus::kOutOfRange);
  EXPECT_EQ(robot.command(protocol::ConfigureSensors{0, 40, 0, 2}), CommandStatus::kAccepted);
  pins.pin_3 = pins.pin_4 = protocol::kPinUnused;
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(kGyroOn), CommandStatus::kAccepted);
  robot.run_ms(200);
  const std::uint16_t samples = robot.all<protocol::Gyro>().back().samples;
  EXPECT_GT(samples, 10);
  pins.pin_4 = protocol::kPinBattery;
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted) << "and the gyro is off";
  const std::size_t told = robot.all<protocol::Gyro>().size();
  robot.run_ms(200);
  EXPECT_LE(robot.all<protocol::Gyro>().size(), told + 1);
  robot.board.twi_aux_pins = 0;
}

TEST_F(SensorsTest, PinsDoNotChangeUnderAMovingRobot) {
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 9000, 9000, 1500, 500}), CommandStatus::kAccepted);
  EXPECT_EQ(robot.command(pins), CommandStatus::kBusy);
}

TEST_F(SensorsTest, CliffCutsTheMotorsWithinTwoMilliseconds) {
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::MoveTicks{0, 9000, 9000, 1500, 500}), CommandStatus::kAccepted);
  robot.run_ms(300);
  ASSERT_GT(robot.board.left_duty(), 0);
  robot.board.set_aux_level(0, false);
  robot.run_ms(2);
  EXPECT_EQ(robot.board.left_duty(), 0);
  EXPECT_EQ(robot.board.right_duty(), 0);
  robot.run_ms(20);
  const protocol::Status status = robot.all<protocol::Status>().back();
  EXPECT_EQ(status.move_outcome, number(MotionOutcome::kHazard));
  EXPECT_EQ(status.hazards, protocol::kHazardCliffLeft);
  EXPECT_TRUE((status.flags & protocol::kFlagArmed) != 0);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, 500, 500, 500, 500}), CommandStatus::kBlocked);
  EXPECT_EQ(robot.command(protocol::MoveTicks{0, -500, -500, 500, 500}), CommandStatus::kAccepted);
}

TEST_F(SensorsTest, WheelDropDisarmsWithinTwoMilliseconds) {
  ASSERT_TRUE(robot.arm());
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  robot.send(protocol::DriveSetpoint{-1000, -1000, 500});
  robot.run_ms(300);
  ASSERT_LT(robot.board.left_duty(), 0);
  robot.board.set_aux_level(1, true);
  robot.run_ms(2);
  EXPECT_EQ(robot.board.left_duty(), 0);
  robot.run_ms(20);
  const protocol::Status status = robot.all<protocol::Status>().back();
  EXPECT_EQ(status.move_outcome, number(MotionOutcome::kLifted));
  EXPECT_EQ(status.flags & protocol::kFlagArmed, 0);
  EXPECT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kBlocked);
  robot.board.set_aux_level(1, false);
  robot.run_ms(50);
  EXPECT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
}

TEST_F(SensorsTest, StepperOfASweepGetsNoCurrentOnceTheHostIsSilent) {
  protocol::ConfigurePins phases{};
  phases.pin_12 = protocol::kPinStepperPhaseA;
  phases.pin_13 = protocol::kPinStepperPhaseA + 1;
  phases.pin_14 = protocol::kPinStepperPhaseA + 2;
  phases.pin_15 = protocol::kPinStepperPhaseA + 3;
  ASSERT_TRUE(robot.connect(1).has_value());
  ASSERT_EQ(robot.command(protocol::ConfigurePan{0, 1, 0, 0, 2048, -36000, 36000, 80}),
            CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(phases), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 36000, 9000, 10000}),
            CommandStatus::kAccepted);
  const auto coils = [this] {
    int on = 0;
    for (std::uint8_t pin = 12; pin < 16; ++pin) {
      on += robot.board.aux_output(pin) ? 1 : 0;
    }
    return on;
  };
  robot.run_ms(2000);
  robot.send(protocol::Ping{0});
  robot.run_ms(protocol::kMaxSweepSilenceMs - 100);
  EXPECT_EQ(robot.all<protocol::Status>().back().sweep_outcome, number(MotionOutcome::kRunning));
  robot.run_ms(300);
  EXPECT_EQ(robot.all<protocol::Status>().back().sweep_outcome, number(MotionOutcome::kExpired));
  EXPECT_EQ(coils(), 0);
}

TEST_F(SensorsTest, StepperSweepsTwoTurnsAndUnwindsThem) {
  protocol::ConfigurePins phases{};
  phases.pin_12 = protocol::kPinStepperPhaseA;
  phases.pin_13 = protocol::kPinStepperPhaseA + 1;
  phases.pin_14 = protocol::kPinStepperPhaseA + 2;
  phases.pin_15 = protocol::kPinStepperPhaseA + 3;
  const protocol::ConfigurePan stepper{0, 1, 0, 0, 2048, -36000, 36000, 80};
  ASSERT_TRUE(robot.connect(1).has_value());
  ASSERT_EQ(robot.command(stepper), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, -36000, 36000, 9000, 0}),
            CommandStatus::kOutOfRange)
      << "no phases yet";
  ASSERT_EQ(robot.command(phases), CommandStatus::kAccepted);
  int steps = 0;
  robot.board.on_aux_output = [&](std::int64_t, std::uint8_t, bool) { ++steps; };
  ASSERT_EQ(robot.command(protocol::StartSweep{0, -36000, 36000, 9000, 0}),
            CommandStatus::kAccepted);
  robot.run_ms(16000);
  robot.board.on_aux_output = nullptr;
  const auto echoes = robot.all<protocol::Echo>();
  ASSERT_EQ(echoes.size(), 9U);
  const int expected[] = {0, 9000, 18000, -9000, 0, 9000, 18000, -9000, 0};
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    EXPECT_EQ(echoes[i].pan_cdeg, expected[i]) << i;
  }
  EXPECT_NEAR(steps, 3 * 2048, 4) << "half a level change a half step: a turn there, two back";
}

}  // namespace
}  // namespace echomap::tasks
