// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hil_mock/unicorn/stm32_chip.hpp"

/// Where the robot's parts are wired to the Blue Pill: the same table as
/// docs/hardware/stm32f103.md.
namespace echomap::unicorn {

/// A port and the number of the pin in it.
struct Pin {
  Stm32Chip::PortName port;
  std::uint8_t number;
};

namespace blue_pill_pins {

/// What stands on each pin, as in firmware/boards/stm32f103/pins.hpp.
constexpr Pin kLeftEncoderA{Stm32Chip::kPortA, 15};     ///< TIM2_CH1
constexpr Pin kLeftEncoderB{Stm32Chip::kPortB, 3};      ///< TIM2_CH2
constexpr Pin kRightEncoderA{Stm32Chip::kPortB, 6};     ///< TIM4_CH1
constexpr Pin kRightEncoderB{Stm32Chip::kPortB, 7};     ///< TIM4_CH2
constexpr Pin kSonarEcho{Stm32Chip::kPortA, 8};         ///< TIM1_CH1
constexpr Pin kSonarTrigger{Stm32Chip::kPortB, 14};     ///< GPIO
constexpr Pin kPanServo{Stm32Chip::kPortA, 11};         ///< TIM1_CH4
constexpr Pin kLeftMotorPwm{Stm32Chip::kPortA, 6};      ///< TIM3_CH1
constexpr Pin kRightMotorPwm{Stm32Chip::kPortA, 7};     ///< TIM3_CH2
constexpr Pin kLeftMotorForward{Stm32Chip::kPortB, 4};  ///< High is forward.
constexpr Pin kRightMotorForward{Stm32Chip::kPortB, 5};
constexpr Pin kLeftMotorSecond{Stm32Chip::kPortB, 12};  ///< IN2 of drivers that have one.
constexpr Pin kRightMotorSecond{Stm32Chip::kPortB, 13};
constexpr Pin kLeftBump{Stm32Chip::kPortB, 8};  ///< Low is pressed.
constexpr Pin kRightBump{Stm32Chip::kPortB, 9};

/// The spare pins in the order of protocol::ConfigurePins. The first eight are also channels of the
/// converter: A0 .. A5 0 to 5, B0 and B1 8 and 9.
constexpr std::array<Pin, 14> kSpare = {{{Stm32Chip::kPortA, 0},
                                         {Stm32Chip::kPortA, 1},
                                         {Stm32Chip::kPortA, 2},
                                         {Stm32Chip::kPortA, 3},
                                         {Stm32Chip::kPortA, 4},
                                         {Stm32Chip::kPortA, 5},
                                         {Stm32Chip::kPortB, 0},
                                         {Stm32Chip::kPortB, 1},
                                         {Stm32Chip::kPortB, 15},
                                         {Stm32Chip::kPortB, 10},
                                         {Stm32Chip::kPortB, 11},
                                         {Stm32Chip::kPortB, 12},
                                         {Stm32Chip::kPortB, 13},
                                         {Stm32Chip::kPortA, 12}}};
constexpr std::array<std::uint8_t, 8> kChannelOfSpare = {0, 1, 2, 3, 4, 5, 8, 9};

}  // namespace blue_pill_pins
}  // namespace echomap::unicorn
