// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

/// Where the robot's parts are wired to the Pico: the same table as docs/hardware/pico.md.
namespace echomap::rp2040::pico_pins {

/// Numbers of GPIO pins.
constexpr std::uint8_t kLeftEncoderA = 2;
constexpr std::uint8_t kLeftEncoderB = 3;
constexpr std::uint8_t kRightEncoderA = 4;
constexpr std::uint8_t kRightEncoderB = 5;
constexpr std::uint8_t kSonarTrigger = 6;
constexpr std::uint8_t kSonarEcho = 7;
constexpr std::uint8_t kPanServo = 8;
constexpr std::uint8_t kLeftMotorPwm = 10;
constexpr std::uint8_t kLeftMotorSecond = 11;
constexpr std::uint8_t kRightMotorPwm = 12;
constexpr std::uint8_t kRightMotorSecond = 13;
constexpr std::uint8_t kLeftMotorForward = 14;
constexpr std::uint8_t kRightMotorForward = 15;
constexpr std::uint8_t kLeftBump = 16;  ///< Low is pressed.
constexpr std::uint8_t kRightBump = 17;

/// The spare pins in the order of protocol::ConfigurePins.
constexpr std::array<std::uint8_t, 11> kSpare = {18, 19, 22, 9, 26, 27, 28, 20, 21, 11, 13};
/// Channel 0 of the converter is this spare pin; two more follow.
constexpr unsigned kFirstAnalogSpare = 4;
constexpr unsigned kAnalogSpares = 3;

}  // namespace echomap::rp2040::pico_pins
