// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// The words of the PIO's instructions that the firmware uses, without delay and side-set: RP2040
/// data sheet, 3.4.
namespace echomap {
namespace boards {
namespace pio {

/// A jump always, where X is 0, and one that counts Y down and falls through where Y was 0.
constexpr uint16_t jmp(uint8_t address) { return static_cast<uint16_t>(0x0000 | address); }
constexpr uint16_t jmp_not_x(uint8_t address) { return static_cast<uint16_t>(0x0020 | address); }
constexpr uint16_t jmp_y_down(uint8_t address) { return static_cast<uint16_t>(0x0080 | address); }

/// Shifts levels of pins into ISR, or bits of OSR out into ISR.
constexpr uint16_t in_pins(uint8_t count) { return static_cast<uint16_t>(0x4000 | count); }
constexpr uint16_t out_isr(uint8_t count) { return static_cast<uint16_t>(0x60C0 | count); }

/// ISR goes to the program, or is lost where the FIFO is full.
constexpr uint16_t kPush = 0x8000;

/// Moves: X from the status, Y from its own inverse, the program counter from ISR, ..
constexpr uint16_t kMovXStatus = 0xA025;
constexpr uint16_t kMovYNotY = 0xA04A;
constexpr uint16_t kMovPcIsr = 0xA0A6;
constexpr uint16_t kMovIsrY = 0xA0C2;
constexpr uint16_t kMovOsrIsr = 0xA0E6;
constexpr uint16_t kMovOsrPins = 0xA0E0;
constexpr uint16_t kSetY0 = 0xE040;

/// Raises the flag that has the state machine's own number.
constexpr uint16_t kIrqOwn = 0xC010;

}  // namespace pio
}  // namespace boards
}  // namespace echomap
