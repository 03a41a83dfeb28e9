// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/arduino_uno/pins.hpp"
#include "firmware/boards/avr_common/frame_timer.hpp"
#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/servo.hpp"
#include "firmware/hal/sonar.hpp"

namespace echomap {
namespace boards {
namespace {

struct Timer1 {
  static volatile uint16_t& count() { return TCNT1; }
  static volatile uint16_t& captured() { return ICR1; }
  static volatile uint16_t& top() { return OCR1A; }
  static volatile uint16_t& servo() { return OCR1B; }
  static volatile uint8_t& mode() { return TCCR1A; }
  static volatile uint8_t& control() { return TCCR1B; }
  static volatile uint8_t& flags() { return TIFR1; }
  static volatile uint8_t& enables() { return TIMSK1; }
  static volatile uint8_t& port() { return PORTB; }
  static volatile uint8_t& direction() { return DDRB; }
  static volatile uint8_t& level() { return PINB; }
  static constexpr uint8_t kEchoPin = boards::kEchoPin;
  static constexpr uint8_t kTriggerPin = boards::kTriggerPin;
  static constexpr uint8_t kServoPin = boards::kServoPin;
};

using Clock = FrameTimer<Timer1>;

}  // namespace

void start_frame_timer() { Clock::start(); }

}  // namespace boards

namespace hal {

uint32_t now_us() { return boards::Clock::now_us(); }

void set_servo_pulse_us(uint16_t pulse_us) { boards::Clock::set_servo_pulse_us(pulse_us); }

void trigger_sonar() { boards::Clock::trigger_sonar(); }

bool echo_is_high() { return boards::Clock::echo_is_high(); }

ISR(TIMER1_OVF_vect) { boards::Clock::on_overflow(); }

ISR(TIMER1_CAPT_vect) { boards::Clock::on_capture(); }

}  // namespace hal
}  // namespace echomap
