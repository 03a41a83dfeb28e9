// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>
#include <util/delay.h>

#include "firmware/boards/arduino_uno/parts.hpp"
#include "firmware/boards/arduino_uno/pins.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/servo.hpp"
#include "firmware/hal/sonar.hpp"

/// Timer 1 counts half microseconds from 0 to 39,999: one servo frame of 20 ms, in hardware on
/// OC1B, while ICP1 stamps echo edges on the same count (docs/decisions/0001-timer1-mode-15.md).
namespace echomap {
namespace boards {
namespace {

constexpr uint16_t kFrameCounts = 40000;
constexpr uint16_t kFrameUs = kFrameCounts / 2;
static_assert(F_CPU / 8 == 2000000, "half microseconds need 16 MHz");
static_assert(kFrameUs == hal::kServoFrameMs * 1000U, "the frame is the servo's");

constexpr uint8_t kMode15 = _BV(WGM11) | _BV(WGM10);

volatile uint32_t frames_us = 0;

/// Start of the frame in which `count` was read, with interrupts locked. An overflow that nobody
/// has served yet belongs before a low count and after a high one.
uint32_t frame_start_us(uint16_t count) {
  const bool overflow_waits = (TIFR1 & _BV(TOV1)) != 0;
  return overflow_waits && count < kFrameCounts / 2 ? frames_us + kFrameUs : frames_us;
}

}  // namespace

void start_timer1() {
  DDRB |= kTriggerPin | kServoPin;
  OCR1A = kFrameCounts - 1;  // Still in normal mode, where it holds at once.
  TCCR1A = kMode15;
  TCCR1B = _BV(ICNC1) | _BV(ICES1) | _BV(WGM13) | _BV(WGM12) | _BV(CS11);
  TIMSK1 = _BV(ICIE1) | _BV(TOIE1);
}

}  // namespace boards

namespace hal {

uint32_t now_us() {
  const InterruptLock lock;
  const uint16_t count = TCNT1;
  return boards::frame_start_us(count) + count / 2;
}

void set_servo_pulse_us(uint16_t pulse_us) {
  const InterruptLock lock;  // 16-bit registers share one TEMP byte with those of the interrupts.
  OCR1B = static_cast<uint16_t>(pulse_us * 2 - 1);
  TCCR1A = boards::kMode15 | _BV(COM1B1);
}

void trigger_sonar() {
  {
    const InterruptLock lock;
    TCCR1B |= _BV(ICES1);
    TIFR1 = _BV(ICF1);
  }
  PORTB |= boards::kTriggerPin;
  _delay_us(10);
  PORTB &= static_cast<uint8_t>(~boards::kTriggerPin);
}

bool echo_is_high() { return (PINB & boards::kEchoPin) != 0; }

ISR(TIMER1_OVF_vect) { boards::frames_us += boards::kFrameUs; }

ISR(TIMER1_CAPT_vect) {
  const uint16_t count = ICR1;
  const bool high = (TCCR1B & _BV(ICES1)) != 0;
  TCCR1B ^= _BV(ICES1);
  TIFR1 = _BV(ICF1);  // Turning the edge round may set it.
  on_echo_edge(high, boards::frame_start_us(count) * 2 + count);
}

}  // namespace hal
}  // namespace echomap
