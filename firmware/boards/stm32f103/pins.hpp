// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/stm32f103/registers.hpp"

/// Every pin of the Blue Pill that the firmware uses; docs/hardware/stm32f103.md shows the wires.
namespace echomap {
namespace boards {

/// The ports that have pins of ours.
enum class Port : uint8_t { kA, kB };

/// A pin by its name on the board: {Port::kB, 12} is B12.
struct Pin {
  Port port;
  uint8_t number;
};

/// What a pin is, as its four bits in CRL or CRH: RM0008, table 20.
enum class PinMode : uint8_t {
  kAnalog = 0x0,
  kInputPulled = 0x8,  ///< Up or down by ODR.
  kOutput = 0x2,       ///< Push-pull, 2 MHz.
  kOutputOpenDrain = 0x6,
  kAlternate = 0xA,  ///< The same, by a timer or the USART.
  kAlternateOpenDrain = 0xE,
};

/// The registers of the pin's port.
inline GpioRegisters& port_of(Pin pin) {
  return block_at<GpioRegisters>(0x40010800 + 0x400U * static_cast<uint8_t>(pin.port));
}

/// Level of an output, or the direction in which an input is pulled.
inline void set_level(Pin pin, bool high) {
  port_of(pin).bsrr = bit(high ? pin.number : static_cast<uint8_t>(pin.number + 16));
}

/// Level on the pin now.
inline bool level_of(Pin pin) { return (port_of(pin).idr & bit(pin.number)) != 0; }

/// Makes the pin what it is to be from now on.
void set_mode(Pin pin, PinMode mode);
/// An input with its pull-up.
void pull_up(Pin pin);
/// An input with its pull-down.
void pull_down(Pin pin);

/// From now on this pin's pulses are counted, and no other's; or no more, if it was the one.
void count_pulses_of(Pin pin);
void count_no_pulses_of(Pin pin);

/// Quadrature inputs with pull-up: left A, left B (TIM2_CH1, CH2, remapped), right A, right B
/// (TIM4_CH1, CH2).
constexpr Pin kEncoderPins[] = {{Port::kA, 15}, {Port::kB, 3}, {Port::kB, 6}, {Port::kB, 7}};

/// Sonar and servo.
constexpr Pin kEchoPin{Port::kA, 8};  // TIM1_CH1
constexpr Pin kTriggerPin{Port::kB, 14};
constexpr Pin kServoPin{Port::kA, 11};  // TIM1_CH4

/// Contacts, to ground.
constexpr Pin kContactLeftPin{Port::kB, 8};
constexpr Pin kContactRightPin{Port::kB, 9};

/// Motors. The forward pins are PH, high is forward, or IN1. The reverse pins are IN2, of bridges
/// with two inputs too, whose IN1 is the PWM pin: a pull-up at reset, as B4 has, would be full
/// reverse there. Servos are on the PWM pins.
constexpr Pin kLeftPwmPin{Port::kA, 6};   // TIM3_CH1
constexpr Pin kRightPwmPin{Port::kA, 7};  // TIM3_CH2
constexpr Pin kLeftForwardPin{Port::kB, 4};
constexpr Pin kRightForwardPin{Port::kB, 5};
constexpr Pin kLeftReversePin{Port::kB, 12};  // Spare pins where the bridge does not need them.
constexpr Pin kRightReversePin{Port::kB, 13};

/// I2C2; spare pins while no transfer was started.
constexpr Pin kTwiClockPin{Port::kB, 10};
constexpr Pin kTwiDataPin{Port::kB, 11};

/// USART1.
constexpr Pin kSendPin{Port::kA, 9};
constexpr Pin kReceivePin{Port::kA, 10};

}  // namespace boards
}  // namespace echomap
