// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/rp2040/pio_instructions.hpp"

namespace echomap {
namespace boards {

/// Counts a wheel without the core. Y is the count, OSR has the pins of the last look in its low
/// bits. Each round looks at both pins and jumps to the address made of the old and the new levels
/// (bit 0 A, bit 1 B), which is why the program stands at address 0. At most 13 cycles a round, 0.1
/// us. The count goes to the program whenever the FIFO is empty, so that at most one old one waits.
struct QuadratureProgram {
  static constexpr uint8_t kWords = 30;

  /// Addresses behind the table.
  static constexpr uint8_t kDown = 16;
  static constexpr uint8_t kTell = 17;
  static constexpr uint8_t kLook = 21;
  static constexpr uint8_t kUp = 25;
  static constexpr uint8_t kIllegal = 28;
  static constexpr uint8_t kLast = 29;

  uint16_t word[kWords];

  constexpr QuadratureProgram() : word() {
    for (uint8_t levels = 0; levels < 16; ++levels) {
      word[levels] = pio::jmp(target(levels >> 2, levels & 3));
    }
    word[kDown] = pio::jmp_y_down(kTell);
    word[kTell] = pio::kMovXStatus;
    word[kTell + 1] = pio::jmp_not_x(kLook);
    word[kTell + 2] = pio::kMovIsrY;
    word[kTell + 3] = pio::kPush;
    word[kLook] = pio::out_isr(2);
    word[kLook + 1] = pio::in_pins(2);
    word[kLook + 2] = pio::kMovOsrIsr;
    word[kLook + 3] = pio::kMovPcIsr;
    word[kUp] = pio::kMovYNotY;
    word[kUp + 1] = pio::jmp_y_down(kUp + 2);
    word[kUp + 2] = pio::kMovYNotY;  // And over the jump of the wrap to kTell.
    word[kIllegal] = pio::kIrqOwn;
    word[kLast] = pio::jmp(kTell);
  }

 private:
  /// Forward is the order 00 01 11 10 of B and A.
  static constexpr uint8_t target(uint8_t before, uint8_t after) {
    const uint8_t changed = before ^ after;
    if (changed == 0) {
      return kTell;
    }
    if (changed == 3) {
      return kIllegal;
    }
    const uint8_t before_a = before & 1;
    const uint8_t after_b = (after >> 1) & 1;
    return before_a == after_b ? kUp : kDown;
  }
};

}  // namespace boards
}  // namespace echomap
