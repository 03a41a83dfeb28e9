// SPDX-License-Identifier: MIT
#include "firmware/hal/interrupts.hpp"

#include "firmware/boards/stm32f103/interrupt_lines.hpp"

namespace echomap {
namespace hal {

uint8_t lock_interrupts() {
  uint32_t state = 0;
  asm volatile("mrs %0, basepri" : "=r"(state));
  asm volatile("msr basepri, %0" ::"r"(uint32_t{boards::kEventPriority}) : "memory");
  return static_cast<uint8_t>(state);
}

void restore_interrupts(uint8_t state) {
  asm volatile("msr basepri, %0" ::"r"(uint32_t{state}) : "memory");
}

void enable_interrupts() { restore_interrupts(0); }

void sleep_until_interrupt() {
  // WFI wakes for an interrupt that PRIMASK holds back, but not for one that BASEPRI does.
  asm volatile("cpsid i" ::: "memory");
  restore_interrupts(0);
  asm volatile("dsb\n wfi\n cpsie i\n isb" ::: "memory");
}

}  // namespace hal
}  // namespace echomap
