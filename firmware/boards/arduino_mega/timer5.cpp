// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/arduino_mega/pins.hpp"
#include "firmware/boards/avr_common/frame_timer.hpp"
#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/servo.hpp"
#include "firmware/hal/sonar.hpp"

namespace echomap {
namespace boards {
namespace {

struct Timer5 {
  static volatile uint16_t& count() { return TCNT5; }
  static volatile uint16_t& captured() { return ICR5; }
  static volatile uint16_t& top() { return OCR5A; }
  static volatile uint16_t& servo() { return OCR5B; }
  static volatile uint8_t& mode() { return TCCR5A; }
  static volatile uint8_t& control() { return TCCR5B; }
  static volatile uint8_t& flags() { return TIFR5; }
  static volatile uint8_t& enables() { return TIMSK5; }
  static volatile uint8_t& port() { return PORTL; }
  static volatile uint8_t& direction() { return DDRL; }
  static volatile uint8_t& level() { return PINL; }
  static constexpr uint8_t kEchoPin = boards::kEchoPin;
  static constexpr uint8_t kTriggerPin = boards::kTriggerPin;
  static constexpr uint8_t kServoPin = boards::kServoPin;
};

using Clock = FrameTimer<Timer5>;

}  // namespace

void start_frame_timer() { Clock::start(); }

}  // namespace boards

namespace hal {

uint32_t now_us() { return boards::Clock::now_us(); }

void set_servo_pulse_us(uint16_t pulse_us) { boards::Clock::set_servo_pulse_us(pulse_us); }

void trigger_sonar() { boards::Clock::trigger_sonar(); }

bool echo_is_high() { return boards::Clock::echo_is_high(); }

ISR(TIMER5_OVF_vect) { boards::Clock::on_overflow(); }

ISR(TIMER5_CAPT_vect) { boards::Clock::on_capture(); }

}  // namespace hal
}  // namespace echomap
