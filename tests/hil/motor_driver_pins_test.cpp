// SPDX-License-Identifier: MIT
/// For each motor driver on each board: the pins drive no motor from power-up until the host
/// drives, nor behind any cut. Every write of the program counts.
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil/measure/drive_trace.hpp"
#include "tests/hil/measure/robot_on_the_move.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;
using runner::Wheel;
using world::DriverChip;

using BoardAndDriver = std::tuple<const char*, DriverChip>;

bool has_servo_timer(std::string_view image) { return image != "echomap-uno"; }

class DrivenBoard : protected RobotOnTheMove, public ::testing::TestWithParam<BoardAndDriver> {
 protected:
  DrivenBoard()
      : RobotOnTheMove(release_image(std::get<0>(GetParam())),
                       world::MotorDriver(std::get<1>(GetParam()))),
        trace(robot.board(), driver) {}

  /// From here on no motor is driven for so long.
  void expect_off_for(std::int64_t ms) {
    trace.take_longest_ns();
    robot.run_ms(ms);
    EXPECT_LE(trace.take_longest_ns(), DriveTrace::kGlitchNs);
  }

  /// On a bend so narrow that one wheel goes back, for which half of the pins are: bumpers do not
  /// stop a turn on the spot. Of each kind of wires one chip has it left and another right.
  void drive_both_ways() {
    const bool left_goes_back =
        driver.chip() == DriverChip::kTb6612fng || driver.chip() == DriverChip::kDrv8833;
    const std::int16_t back_ticks_per_s = -kTicksPerS / 2;
    protocol::DriveSetpoint bend{kTicksPerS, back_ticks_per_s, kTimeToLiveMs};
    if (left_goes_back) {
      std::swap(bend.left_ticks_per_s, bend.right_ticks_per_s);
    }
    connect_and_arm();
    renewing = true;
    robot.send(bend);
    robot.run_ms(700);
    EXPECT_NEAR(left.ticks_per_s(), bend.left_ticks_per_s, 60.0);
    EXPECT_NEAR(right.ticks_per_s(), bend.right_ticks_per_s, 60.0);
  }

  /// Drives, does something that takes the PWM off within `ms`, and waits for that.
  template <class Cut>
  void cut_while_driving(Cut cut, std::int64_t ms) {
    drive_both_ways();
    EXPECT_FALSE(off());
    renewing = false;
    cut();
    EXPECT_LE(ms_until_off(ms + 50), static_cast<double>(ms));
  }

  /// Rests at speed 0, of which the host goes on to say that it is alive.
  void rest_with(const protocol::ConfigureWiring& asked) {
    ASSERT_EQ(robot.command(protocol::Arm{0, 0}), CommandStatus::kAccepted);
    ASSERT_EQ(robot.command(asked), CommandStatus::kAccepted);
    ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
    robot.send(protocol::DriveSetpoint{kTicksPerS, -kTicksPerS, kTimeToLiveMs});
    robot.run_ms(500);
    EXPECT_FALSE(off());
    robot.send(protocol::DriveSetpoint{0, 0, kTimeToLiveMs});
    EXPECT_LE(ms_until_off(800), 700.0);
  }

  /// Whether neither motor is driven, braked or told to stand.
  bool lets_go() {
    const auto is_free = [&](Wheel wheel) {
      const world::DriverInputs inputs = robot.board().driver_inputs(wheel, driver.interface());
      return driver.chip() == DriverChip::kServo ? inputs.pwm.high_share() == 0.0
                                                 : driver.drive(inputs).coasting == 1.0;
    };
    return is_free(Wheel::kLeft) && is_free(Wheel::kRight);
  }

  DriveTrace trace;
};

std::string driver_label(const ::testing::TestParamInfo<BoardAndDriver>& info) {
  std::string driver(world::name_of(std::get<1>(info.param)));
  std::erase(driver, '-');
  return label_of(std::get<0>(info.param)) + "_" + driver;
}

/// Of each kind of wires the chips whose tables, pull-ups or PWM differ; an Uno has no timer left
/// for servos.
std::vector<BoardAndDriver> drivers_of_every_board() {
  std::vector<BoardAndDriver> all;
  for (const char* image : flashed_images()) {
    for (const DriverChip chip : {DriverChip::kPhaseEnable,
                                  DriverChip::kTb6612fng,
                                  DriverChip::kL298n,
                                  DriverChip::kL293d,
                                  DriverChip::kDrv8833,
                                  DriverChip::kMx1508,
                                  DriverChip::kServo}) {
      if (chip != DriverChip::kServo || has_servo_timer(image)) {
        all.emplace_back(image, chip);
      }
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Drivers,
                         DrivenBoard,
                         ::testing::ValuesIn(drivers_of_every_board()),
                         driver_label);

/// The drawings have a resistor to ground at each enable of an L298N, so that this is no test of
/// the firmware alone.
TEST_P(DrivenBoard, StandsFromPowerUpUntilItIsDriven) {
  expect_off_for(30);
  ASSERT_TRUE(robot.connect());
  EXPECT_EQ(robot.command(wiring()), CommandStatus::kAccepted);
  expect_off_for(50);
  robot.send(protocol::DriveSetpoint{kTicksPerS, -kTicksPerS, kTimeToLiveMs});
  expect_off_for(50);
  EXPECT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  expect_off_for(50);
}

TEST_P(DrivenBoard, TurnsBothWheelsBothWays) {
  connect_and_arm();
  renewing = true;
  for (const std::int16_t left_ticks_per_s : {kTicksPerS, static_cast<std::int16_t>(-kTicksPerS)}) {
    const auto right_ticks_per_s = static_cast<std::int16_t>(-left_ticks_per_s);
    robot.send(protocol::DriveSetpoint{left_ticks_per_s, right_ticks_per_s, kTimeToLiveMs});
    robot.run_ms(1200);
    EXPECT_NEAR(left.ticks_per_s(), left_ticks_per_s, 60.0);
    EXPECT_NEAR(right.ticks_per_s(), right_ticks_per_s, 60.0);
  }
}

TEST_P(DrivenBoard, StandsOnceTheHostIsSilent) {
  cut_while_driving([] {}, kTimeToLiveMs + 100);
  expect_off_for(300);
}

TEST_P(DrivenBoard, StandsBehindAStop) {
  cut_while_driving([&] { robot.command(protocol::Stop{}); }, 100);
  expect_off_for(100);
}

TEST_P(DrivenBoard, StandsOnceItIsDisarmed) {
  cut_while_driving([&] { robot.command(protocol::Arm{0, 0}); }, 100);
  expect_off_for(100);
}

TEST_P(DrivenBoard, StandsBehindABump) {
  cut_while_driving([&] { robot.board().set_bump(Wheel::kLeft, true); }, 3);
  expect_off_for(100);
}

TEST_P(DrivenBoard, StandsBehindAWheelDrop) {
  connect_and_arm();
  protocol::ConfigurePins pins{};
  pins.pin_3 = protocol::kPinWheelDrop;
  EXPECT_EQ(robot.command(pins), CommandStatus::kAccepted);
  cut_while_driving([&] { robot.board().set_aux_level(3, false); }, 3);
  expect_off_for(100);
}

TEST_P(DrivenBoard, StandsBehindAHangAndTheWatchdogsReset) {
  cut_while_driving(
      [&] {
        robot.forget_heard();
        robot.chip().hang();
      },
      150);
  expect_off_for(400);
  EXPECT_TRUE(robot.last<protocol::HelloReply>()) << "it has not started again";
}

TEST_P(DrivenBoard, StandsBehindTheResetPin) {
  drive_both_ways();
  robot.chip().pull_reset_pin();
  expect_off_for(100);
}

TEST_P(DrivenBoard, StandsBehindAPowerCut) {
  drive_both_ways();
  robot.chip().cut_power();
  expect_off_for(100);
}

TEST_P(DrivenBoard, BrakesAtZeroWhereItIsAskedTo) {
  connect_and_arm();
  renewing = true;
  const bool chip_decides = driver.interface() == world::DriverInterface::kPhaseEnable;
  protocol::ConfigureWiring braking = wiring();
  braking.bridge_options |= protocol::kBrakeAtZero;
  if (chip_decides) {
    EXPECT_EQ(robot.command(protocol::Arm{0, 0}), CommandStatus::kAccepted);
    EXPECT_EQ(robot.command(braking), CommandStatus::kOutOfRange);
    return;
  }
  rest_with(wiring());
  EXPECT_TRUE(lets_go());
  rest_with(braking);
  EXPECT_TRUE(off());
  EXPECT_FALSE(lets_go());
  robot.command(protocol::Arm{0, 0});
  EXPECT_TRUE(lets_go()) << "disarmed";
}

/// Also to a driver that the robot does not have: both wires of two-PWM are low meanwhile.
TEST_P(DrivenBoard, StandsWhileAnotherDriverIsConfigured) {
  cut_while_driving([&] { robot.command(protocol::Stop{}); }, 100);
  trace.take_longest_ns();
  for (std::uint8_t bridge = 0;
       bridge <= static_cast<std::uint8_t>(protocol::MotorBridgeKind::kServo);
       ++bridge) {
    robot.command(protocol::ConfigureWiring{0, bridge, 0, 0});
    robot.command(wiring());
  }
  EXPECT_LE(trace.take_longest_ns(), DriveTrace::kGlitchNs);
  expect_off_for(100);
}

class ServosAsWheels : public OnEveryBoard {};

INSTANTIATE_TEST_SUITE_P(Boards, ServosAsWheels, every_board(), image_label);

TEST_P(ServosAsWheels, AreRefusedByABoardWithoutATimerForThem) {
  ASSERT_TRUE(robot.connect());
  const auto servo = static_cast<std::uint8_t>(protocol::MotorBridgeKind::kServo);
  EXPECT_EQ(robot.command(protocol::ConfigureWiring{0, servo, 0, 0}),
            has_servo_timer(GetParam()) ? CommandStatus::kAccepted : CommandStatus::kOutOfRange);
}

}  // namespace
}  // namespace echomap::tests
