// SPDX-License-Identifier: MIT
/// The registers of the AVR boards' motor pins by each kind of bridge: at rest, driven, braked,
/// cut.
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "hil_mock/emulator/simavr_board.hpp"
#include "tests/hil/release_images.hpp"
#include "tests/hil/robot_session.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;
using protocol::MotorBridgeKind;

/// Addresses of ATmega328P and ATmega2560 by their data sheets; those of ports B, D, E and G and of
/// timer 0 are the same in both.
enum Address : std::uint16_t {
  kDdrB = 0x24,
  kPortB = 0x25,
  kPortD = 0x2B,
  kPortE = 0x2E,
  kPortG = 0x34,
  kTccr0A = 0x44,
  kTccr0B = 0x45,
  kOcr0A = 0x47,
  kTccr1A = 0x80,
  kOcr1A = 0x88,
  kTccr3A = 0x90,
  kTccr4A = 0xA0,
  kDdrH = 0x101,
  kPortH = 0x102
};

constexpr unsigned kFastPwm = 0b11;
constexpr unsigned kUnoMotorPins = 0b11110000;    // D4 .. D7.
constexpr unsigned kUnoReversePins = 0b00011000;  // D11, D12.

class MotorRegisters : public ::testing::Test {
 protected:
  explicit MotorRegisters(const std::string& image) : robot(release_image(image)) {}

  unsigned at(std::uint16_t address) {
    return dynamic_cast<emulator::SimavrBoard&>(robot.board()).machine().core().data[address];
  }
  void configure(MotorBridgeKind kind, unsigned options = 0) {
    ASSERT_EQ(robot.command(protocol::ConfigureWiring{
                  0, static_cast<std::uint8_t>(kind), static_cast<std::uint8_t>(options), 0}),
              CommandStatus::kAccepted);
  }
  void arm() { ASSERT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted); }
  /// Both wheels, which never turn, get more and more duty.
  void drive(int ticks_per_s) {
    const auto speed = static_cast<std::int16_t>(ticks_per_s);
    robot.send(protocol::DriveSetpoint{speed, speed, 400});
    robot.run_ms(150);
  }
  void stop() { ASSERT_EQ(robot.command(protocol::Stop{0}), CommandStatus::kAccepted); }

  RobotSession robot;
};

class UnoMotors : public MotorRegisters {
 protected:
  UnoMotors() : MotorRegisters("echomap-uno") {}

  void expect_off(const std::string& when) {
    EXPECT_EQ(at(kPortD) & kUnoMotorPins, 0U) << when;
    EXPECT_EQ(at(kTccr0A), kFastPwm) << when;
    EXPECT_EQ(at(kPortB) & at(kDdrB) & kUnoReversePins, 0U) << when;
  }
};

TEST_F(UnoMotors, AreLowFromPowerUpToTheFirstMotion) {
  for (int ms = 0; ms < 100; ++ms) {
    robot.run_ms(1);
    expect_off("before Hello");
    EXPECT_EQ(at(kPortB) & kUnoReversePins, 0U) << "D11 and D12 do not even pull up";
  }
  ASSERT_TRUE(robot.connect());
  for (const auto kind : {MotorBridgeKind::kIn1In2Pwm, MotorBridgeKind::kTwoPwm}) {
    configure(kind, protocol::kBrakeAtZero);
    expect_off("configured");
    arm();
    expect_off("armed");
  }
}

TEST_F(UnoMotors, OfThreeWiresHaveTwoLevelsAndAPwm) {
  ASSERT_TRUE(robot.connect());
  configure(MotorBridgeKind::kIn1In2Pwm);
  EXPECT_EQ(at(kDdrB) & kUnoReversePins, kUnoReversePins);
  arm();
  drive(1000);
  EXPECT_EQ(at(kTccr0A), kFastPwm | 0b10100000U);
  EXPECT_EQ(at(kPortD) & kUnoMotorPins, 0b10010000U) << "IN1 of both";
  EXPECT_EQ(at(kPortB) & kUnoReversePins, 0U);
  EXPECT_GT(at(kOcr0A), 0U);
  stop();
  expect_off("Stop");
  drive(-1000);
  EXPECT_EQ(at(kTccr0A), kFastPwm | 0b10100000U);
  EXPECT_EQ(at(kPortD) & kUnoMotorPins, 0U);
  EXPECT_EQ(at(kPortB) & kUnoReversePins, kUnoReversePins);
  stop();
  expect_off("Stop");
  configure(MotorBridgeKind::kPhaseEnable);
  EXPECT_EQ(at(kDdrB) & kUnoReversePins, 0U) << "spare pins again";
}

TEST_F(UnoMotors, OfTwoWiresChopTheFirstAgainstTheSecond) {
  ASSERT_TRUE(robot.connect());
  configure(MotorBridgeKind::kTwoPwm);
  arm();
  drive(1000);
  EXPECT_EQ(at(kTccr0A), kFastPwm | 0b10100000U);
  EXPECT_EQ(at(kPortD) & kUnoMotorPins, 0U);
  stop();
  expect_off("Stop");
  drive(-1000);
  EXPECT_EQ(at(kTccr0A), kFastPwm | 0b11110000U) << "inverted";
  EXPECT_EQ(at(kPortD) & kUnoMotorPins, 0b10010000U) << "the second inputs";
  robot.chip().hang();
  robot.run_ms(100);
  expect_off("hung");
}

TEST_F(UnoMotors, BrakeWithAllPinsHigh) {
  ASSERT_TRUE(robot.connect());
  configure(MotorBridgeKind::kTwoPwm, protocol::kBrakeAtZero);
  arm();
  robot.send(protocol::DriveSetpoint{0, 0, 200});
  robot.run_ms(50);
  EXPECT_EQ(at(kPortD) & kUnoMotorPins, kUnoMotorPins);
  EXPECT_EQ(at(kTccr0A), kFastPwm);
  robot.run_ms(200);
  expect_off("the time to live is over");
}

TEST_F(UnoMotors, HaveASlowPwmToo) {
  ASSERT_TRUE(robot.connect());
  EXPECT_EQ(at(kTccr0B), 0b010U) << "by 8";
  configure(MotorBridgeKind::kIn1In2Pwm, protocol::kSlowPwm);
  EXPECT_EQ(at(kTccr0B), 0b011U) << "by 64";
}

TEST_F(UnoMotors, AreNoServos) {
  ASSERT_TRUE(robot.connect());
  EXPECT_EQ(robot.command(protocol::ConfigureWiring{0, 3, 0, 0}), CommandStatus::kOutOfRange);
}

class MegaMotors : public MotorRegisters {
 protected:
  MegaMotors() : MotorRegisters("echomap-mega") {}

  void expect_off(const std::string& when) {
    EXPECT_EQ(at(kPortG) & 0b00100000U, 0U) << when;
    EXPECT_EQ(at(kPortE) & 0b00001000U, 0U) << when;
    EXPECT_EQ(at(kPortH) & 0b01111000U, 0U) << when;
    EXPECT_EQ(at(kPortB) & 0b01100000U, 0U) << when;
    EXPECT_EQ(at(kTccr0A), kFastPwm) << when;
    EXPECT_EQ(at(kTccr1A) & 0xF0U, 0U) << when;
    EXPECT_EQ(at(kTccr3A) & 0xF0U, 0U) << when;
    EXPECT_EQ(at(kTccr4A) & 0xF0U, 0U) << when;
  }
};

TEST_F(MegaMotors, OfTwoWiresHaveAPwmEach) {
  ASSERT_TRUE(robot.connect());
  configure(MotorBridgeKind::kTwoPwm);
  expect_off("configured");
  arm();
  drive(1000);
  EXPECT_EQ(at(kTccr4A) & 0xF0U, 0b10000000U) << "OC4A, the left one";
  EXPECT_EQ(at(kTccr3A) & 0xF0U, 0b10000000U) << "OC3A, the right one";
  EXPECT_EQ(at(kTccr0A), kFastPwm);
  stop();
  expect_off("Stop");
  drive(-1000);
  EXPECT_EQ(at(kTccr0A), kFastPwm | 0b00100000U) << "OC0B, the left one";
  EXPECT_EQ(at(kTccr4A) & 0xF0U, 0b00100000U) << "OC4B, the right one";
  EXPECT_EQ(at(kTccr3A) & 0xF0U, 0U);
  robot.chip().hang();
  robot.run_ms(100);
  expect_off("hung");
}

TEST_F(MegaMotors, OfThreeWiresHaveTwoLevelsAndAPwm) {
  ASSERT_TRUE(robot.connect());
  configure(MotorBridgeKind::kIn1In2Pwm, protocol::kBrakeAtZero);
  EXPECT_EQ(at(kDdrH) & 0b01100000U, 0b01100000U);
  arm();
  drive(-1000);
  EXPECT_EQ(at(kPortH) & 0b01110000U, 0b01100000U) << "IN2 of both";
  EXPECT_EQ(at(kPortG) & 0b00100000U, 0U);
  stop();
  expect_off("Stop");
}

TEST_F(MegaMotors, AsServosGetPulsesAndNoneAtRest) {
  const auto compare = [this] { return at(kOcr1A) | at(kOcr1A + 1) << 8U; };
  ASSERT_TRUE(robot.connect());
  configure(MotorBridgeKind::kServo);
  expect_off("configured");
  arm();
  drive(1000);
  EXPECT_EQ(at(kTccr1A) & 0xF0U, 0b10100000U);
  EXPECT_GT(compare(), 3000U);
  EXPECT_LE(compare(), 3999U);
  stop();
  robot.run_ms(3);
  expect_off("a pulse under way is over");
  drive(-1000);
  EXPECT_LT(compare(), 2999U);
  EXPECT_GE(compare(), 1999U);
}

}  // namespace
}  // namespace echomap::tests
