// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// Where the robot's parts are wired to the Uno: the same table as docs/hardware/uno.md.
namespace echomap::emulator {

/// A port letter and the bit in it.
struct Pin {
  char port;
  std::uint8_t bit;
};

namespace uno_pins {

/// What stands on each pin, as in firmware/boards/arduino_uno/pins.hpp.
constexpr Pin kLeftEncoderA{'C', 0};
constexpr Pin kLeftEncoderB{'C', 1};
constexpr Pin kRightEncoderA{'C', 2};
constexpr Pin kRightEncoderB{'C', 3};
constexpr Pin kSonarEcho{'B', 0};         ///< ICP1
constexpr Pin kSonarTrigger{'B', 1};      ///< GPIO
constexpr Pin kPanServo{'B', 2};          ///< OC1B
constexpr Pin kLeftMotorPwm{'D', 6};      ///< OC0A
constexpr Pin kRightMotorPwm{'D', 5};     ///< OC0B
constexpr Pin kLeftMotorForward{'D', 4};  ///< High is forward.
constexpr Pin kRightMotorForward{'D', 7};
constexpr Pin kLeftBump{'D', 2};  ///< Low is pressed.
constexpr Pin kRightBump{'D', 3};

}  // namespace uno_pins
}  // namespace echomap::emulator
