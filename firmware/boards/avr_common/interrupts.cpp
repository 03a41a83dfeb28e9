// SPDX-License-Identifier: MIT
#include "firmware/hal/interrupts.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

namespace echomap {
namespace hal {

uint8_t lock_interrupts() {
  const uint8_t state = SREG;
  cli();
  return state;
}

void restore_interrupts(uint8_t state) {
  asm volatile("" ::: "memory");
  SREG = state;
}

void enable_interrupts() { sei(); }

void sleep_until_interrupt() {
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_enable();
  sei();  // The instruction after SEI is still done before any interrupt.
  sleep_cpu();
  sleep_disable();
}

}  // namespace hal
}  // namespace echomap
