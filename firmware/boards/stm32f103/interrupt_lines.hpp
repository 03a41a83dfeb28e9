// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/stm32f103/registers.hpp"

namespace echomap {
namespace boards {

/// Positions in the vector table behind the 16 of the core: RM0008, table 63.
enum class InterruptLine : uint8_t {
  kWwdg = 0,
  kExti0 = 6,  ///< .. 10: lines 0 .. 4.
  kExti5To9 = 23,
  kTim1Capture = 27,
  kI2c2Event = 33,
  kI2c2Error = 34,
  kUsart1 = 37,
  kExti10To15 = 40,
};

/// All events of the program share one priority, so that none interrupts another and one lock
/// (BASEPRI) holds them all; only the watchdog's warning is above it.
constexpr uint8_t kEventPriority = 0x10;
constexpr uint8_t kWarningPriority = 0x00;

/// Lets the line interrupt, at this priority.
inline void enable_line(InterruptLine line, uint8_t priority) {
  const uint8_t number = static_cast<uint8_t>(line);
  nvic().ipr[number] = priority;
  nvic().iser[number / 32] = bit(number % 32);
}

/// Makes the line's interrupt happen as if its part had asked for it.
inline void pend_line(InterruptLine line) {
  const uint8_t number = static_cast<uint8_t>(line);
  nvic().ispr[number / 32] = bit(number % 32);
}

}  // namespace boards
}  // namespace echomap
