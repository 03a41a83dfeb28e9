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
  SMCR = _BV(SE) | SLEEP_MODE_IDLE;  // In one write, for this is done after every encoder edge.
  sei();  // The instruction after SEI is still done before any interrupt.
  sleep_cpu();
}

}  // namespace hal
}  // namespace echomap
