// SPDX-License-Identifier: MIT
#include "hil_mock/world/motor_driver.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::world {
namespace {

using enum BridgeState;
using testing::HasSubstr;

constexpr double kPwmUs = 128.0;

/// State of a chip for each of its inputs' levels, as in its data sheet's truth table.
struct TruthTable {
  DriverChip chip;
  /// PWM IN1 IN2 = LLL, LLH, LHL, LHH, HLL, HLH, HHL, HHH.
  std::vector<BridgeState> states;
};

class EachChip : public ::testing::TestWithParam<TruthTable> {};

// Phase/enable looks at EN and PH only, two-PWM at IN1 and IN2.
INSTANTIATE_TEST_SUITE_P(
    DataSheets,
    EachChip,
    ::testing::Values(
        TruthTable{DriverChip::kPhaseEnable,
                   {kBrake, kBrake, kBrake, kBrake, kReverse, kReverse, kForward, kForward}},
        TruthTable{DriverChip::kDrv8835,
                   {kBrake, kBrake, kBrake, kBrake, kReverse, kReverse, kForward, kForward}},
        TruthTable{DriverChip::kTb6612fng,
                   {kCoast, kBrake, kBrake, kBrake, kCoast, kReverse, kForward, kBrake}},
        TruthTable{DriverChip::kL298n,
                   {kCoast, kCoast, kCoast, kCoast, kBrake, kReverse, kForward, kBrake}},
        TruthTable{DriverChip::kL293d,
                   {kCoast, kCoast, kCoast, kCoast, kBrake, kReverse, kForward, kBrake}},
        TruthTable{DriverChip::kDrv8833,
                   {kCoast, kReverse, kForward, kBrake, kCoast, kReverse, kForward, kBrake}},
        TruthTable{DriverChip::kDrv8835InIn,
                   {kCoast, kReverse, kForward, kBrake, kCoast, kReverse, kForward, kBrake}},
        TruthTable{DriverChip::kMx1508,
                   {kCoast, kReverse, kForward, kBrake, kCoast, kReverse, kForward, kBrake}},
        TruthTable{DriverChip::kMdd3a,
                   {kBrake, kReverse, kForward, kBrake, kBrake, kReverse, kForward, kBrake}}),
    [](const auto& table) {
      std::string name(name_of(table.param.chip));
      std::erase(name, '-');
      return name;
    });

TEST_P(EachChip, HasTheTruthTableOfItsDataSheet) {
  const MotorDriver driver(GetParam().chip);
  for (unsigned row = 0; row < 8; ++row) {
    EXPECT_EQ(driver.state({(row & 4U) != 0, (row & 2U) != 0, (row & 1U) != 0}),
              GetParam().states.at(row))
        << row;
  }
}

/// Also before a program has made outputs of the pins, and with L298N's resistors in place.
TEST_P(EachChip, DoesNotTurnOnFloatingPins) {
  EXPECT_EQ(MotorDriver(GetParam().chip).drive({}).duty, 0.0);
}

TEST_P(EachChip, TurnsAsItIsTold) {
  const MotorDriver driver(GetParam().chip);
  const double period_us = GetParam().chip == DriverChip::kL293d ? 1024.0 : kPwmUs;
  for (const double duty : {-1.0, -0.25, 0.0, 0.5, 1.0}) {
    const MotorDrive got = driver.drive(inputs_for(driver.interface(), duty, false, period_us));
    EXPECT_DOUBLE_EQ(got.duty, duty);
  }
}

double coasting(DriverChip chip, double duty, bool brake = false) {
  const MotorDriver driver(chip);
  return driver.drive(inputs_for(driver.interface(), duty, brake, 1024.0)).coasting;
}

TEST(MotorDriver, BrakesOrCoastsInThePausesOfThePwm) {
  for (const double duty : {0.25, -0.25}) {
    EXPECT_EQ(coasting(DriverChip::kPhaseEnable, duty), 0.0);
    EXPECT_EQ(coasting(DriverChip::kTb6612fng, duty), 0.0);
    EXPECT_EQ(coasting(DriverChip::kL298n, duty), 0.75);
    EXPECT_EQ(coasting(DriverChip::kL293d, duty), 0.75);
  }
  EXPECT_EQ(coasting(DriverChip::kDrv8833, 0.25), 0.75) << "IN1 PWM, IN2 low";
  EXPECT_EQ(coasting(DriverChip::kDrv8833, -0.25), 0.0) << "IN1 inverted PWM, IN2 high";
}

TEST(MotorDriver, CoastsOrBrakesAtNoDuty) {
  for (const DriverChip chip : {DriverChip::kTb6612fng,
                                DriverChip::kL298n,
                                DriverChip::kDrv8833,
                                DriverChip::kDrv8835InIn,
                                DriverChip::kMx1508}) {
    EXPECT_EQ(coasting(chip, 0.0, false), 1.0) << name_of(chip);
    EXPECT_EQ(coasting(chip, 0.0, true), 0.0) << name_of(chip);
  }
  EXPECT_EQ(coasting(DriverChip::kDrv8835, 0.0), 0.0) << "EN low brakes";
}

/// The trap of two-PWM: taking the PWM off is not enough.
TEST(MotorDriver, ALevelThatIsLeftHighIsFullReverse) {
  const DriverInputs left_behind{floating(), level(false), level(true)};
  EXPECT_EQ(MotorDriver(DriverChip::kDrv8833).drive(left_behind).duty, -1.0);
  EXPECT_EQ(MotorDriver(DriverChip::kMx1508).drive(left_behind).duty, -1.0);
}

/// As on B4 of the STM32F103, which JTAG's reset has from power-up on.
TEST(MotorDriver, TakesAPullUpForALevelWhereNothingStrongerPullsDown) {
  const DriverInputs pull_up_on_in2{floating(), floating(), pulled_up()};
  EXPECT_EQ(MotorDriver(DriverChip::kDrv8833).drive(pull_up_on_in2).duty, -1.0);
  EXPECT_EQ(MotorDriver(DriverChip::kMx1508).drive(pull_up_on_in2).duty, 0.0) << "10 kOhm";
  EXPECT_EQ(MotorDriver().drive({level(true), pulled_up(), floating()}).duty, -1.0);
}

TEST(MotorDriver, L298nWithoutPullDownsTurnsWithOneInputLow) {
  const DriverInputs only_in2_low{floating(), floating(), level(false)};
  EXPECT_EQ(MotorDriver(DriverChip::kL298n, false).drive(only_in2_low).duty, 1.0);
  EXPECT_EQ(MotorDriver(DriverChip::kL298n, true).drive(only_in2_low).duty, 0.0);
  EXPECT_EQ(MotorDriver(DriverChip::kL298n, false).drive({}).duty, 0.0) << "all high: it brakes";
}

TEST(MotorDriver, L293dDoesNotTurnAboveFiveKilohertz) {
  const MotorDriver driver(DriverChip::kL293d);
  const auto duty = [&](double period_us) {
    return driver.drive({pulses(0.5, period_us), level(true), level(false)}).duty;
  };
  EXPECT_EQ(duty(128.0), 0.0);
  EXPECT_EQ(duty(1024.0), 0.5);
  EXPECT_EQ(driver.drive({level(true), level(true), level(false)}).duty, 1.0);
}

double servo_duty(double pulse_us, double period_us = 20'000.0) {
  return MotorDriver(DriverChip::kServo)
      .drive({pulses(pulse_us / period_us, period_us), floating(), floating()})
      .duty;
}

TEST(MotorDriver, AServoTurnsByTheLengthOfItsPulses) {
  EXPECT_NEAR(servo_duty(2000.0), 1.0, 1e-9);
  EXPECT_NEAR(servo_duty(1000.0), -1.0, 1e-9);
  EXPECT_NEAR(servo_duty(1600.0), 0.2, 1e-9);
  EXPECT_EQ(servo_duty(1510.0), 0.0) << "its dead band";
  EXPECT_NEAR(servo_duty(2200.0), 1.0, 1e-9) << "no faster than full speed";
}

TEST(MotorDriver, AServoStandsWithoutPulsesOfItsKind) {
  const MotorDriver servo(DriverChip::kServo);
  EXPECT_EQ(servo.drive({}).duty, 0.0);
  EXPECT_EQ(servo.drive({level(false), floating(), floating()}).duty, 0.0);
  EXPECT_EQ(servo.drive({level(true), floating(), floating()}).duty, 0.0);
  EXPECT_EQ(servo_duty(2000.0, 4'000.0), 0.0);
  EXPECT_EQ(servo_duty(400.0), 0.0);
  EXPECT_THROW(servo.state({}), std::logic_error);
}

TEST(MotorDriver, HasNames) {
  for (const std::string& name : driver_names()) {
    EXPECT_EQ(name_of(driver_named(name)), name);
  }
  try {
    driver_named("tb6612");
    FAIL();
  } catch (const std::invalid_argument& unknown) {
    EXPECT_THAT(unknown.what(), HasSubstr("did you mean 'tb6612fng'"));
  }
}

}  // namespace
}  // namespace echomap::world
