// SPDX-License-Identifier: MIT
#include "firmware/hal/stack.hpp"

#include <avr/io.h>

/// End of the static data, by the linker: the stack grows down towards it.
extern "C" uint8_t _end;

namespace echomap {
namespace boards {
namespace {

constexpr uint8_t kPaint = 0xC5;

/// Fills all of the RAM behind the static data, before anything uses the stack.
extern "C" void paint_stack() __attribute__((naked, used, section(".init1")));
extern "C" void paint_stack() {
  asm volatile(
      "ldi r30, lo8(_end)\n"
      "ldi r31, hi8(_end)\n"
      "ldi r24, %0\n"
      "ldi r25, hi8(__stack)\n"
      "1: st Z+, r24\n"
      "cpi r30, lo8(__stack)\n"
      "cpc r31, r25\n"
      "brlo 1b\n" ::"M"(int{kPaint}));
}

}  // namespace
}  // namespace boards

namespace hal {

uint16_t min_free_stack_bytes() {
  constexpr uint8_t kBytesPerCall = RAMEND - RAMSTART < 4096 ? 2 : 4;  // All of it in two seconds.
  static const uint8_t* next = &_end;
  static uint16_t free_bytes = 0;
  const uint8_t* looked_at = next;
  for (uint8_t i = kBytesPerCall; i != 0; --i) {
    if (*looked_at != boards::kPaint) {
      free_bytes = static_cast<uint16_t>(looked_at - &_end);
      looked_at = &_end;
      break;
    }
    ++looked_at;
  }
  next = looked_at;
  return free_bytes;
}

}  // namespace hal
}  // namespace echomap
