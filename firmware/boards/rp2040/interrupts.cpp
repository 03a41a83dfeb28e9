// SPDX-License-Identifier: MIT
#include "firmware/hal/interrupts.hpp"

namespace echomap {
namespace hal {

uint8_t lock_interrupts() {
  uint32_t state = 0;
  asm volatile("mrs %0, primask\n cpsid i" : "=r"(state)::"memory");
  return static_cast<uint8_t>(state);
}

void restore_interrupts(uint8_t state) {
  asm volatile("msr primask, %0" ::"r"(uint32_t{state}) : "memory");
}

void enable_interrupts() { asm volatile("cpsie i" ::: "memory"); }

/// Every interrupt leaves an event behind (ARMv6-M, B1.5.18), and WFE does not sleep on one: what
/// comes in between the two instructions is not slept through.
void sleep_until_interrupt() { asm volatile("cpsie i\n wfe" ::: "memory"); }

}  // namespace hal
}  // namespace echomap
