// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/rp2040/registers.hpp"

namespace echomap {
namespace boards {
/// Apart from those of other chips, which have the same names.
inline namespace rp2040 {

/// Positions in the vector table behind the 16 of the core: RP2040 data sheet, 2.3.2.
enum class InterruptLine : uint8_t {
  kTimer0 = 0,
  kTimer1 = 1,
  kUsb = 5,
  kPio0 = 7,
  kPins = 13,
  kUart0 = 20,
  kI2c0 = 23,
  kSend = 26,  ///< No part's: the program asks for it, see hal::request_send.
};

/// Gives every line the priority of the program's events, so that none interrupts another; the
/// watchdog's warning alone is above them.
inline void start_lines() {
  constexpr uint32_t kFourOfEvents = 0xC0C0C0C0;
  constexpr uint32_t kWarningAbove = 0xC0C000C0;  // Line 1.
  nvic().ipr[0] = kWarningAbove;
  for (uint8_t word = 1; word < 8; ++word) {
    nvic().ipr[word] = kFourOfEvents;
  }
}

/// Lets the line interrupt.
inline void enable_line(InterruptLine line) {
  nvic().icpr[0] = bit(static_cast<uint8_t>(line));
  nvic().iser[0] = bit(static_cast<uint8_t>(line));
}

/// Makes the line's interrupt happen as if its part had asked for it.
inline void pend_line(InterruptLine line) { nvic().ispr[0] = bit(static_cast<uint8_t>(line)); }

}  // namespace rp2040
}  // namespace boards
}  // namespace echomap
