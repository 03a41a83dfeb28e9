// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include <avr/io.h>
#include <util/delay.h>

#include "firmware/hal/clock.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/servo.hpp"

namespace echomap {
namespace boards {

/// A 16-bit timer that counts half microseconds from 0 to 39,999: one servo frame of 20 ms, in
/// hardware on its output B, while its capture input stamps echo edges on the same count
/// (docs/decisions/0001-timer1-mode-15.md).
///
/// `Timer` gives the registers by what they are here: `count`, `captured`, `top` (OCRnA), `servo`
/// (OCRnB), `mode` (TCCRnA), `control` (TCCRnB), `flags`, `enables`, and of the port that its pins
/// are on `port`, `direction` and `level`, with kEchoPin, kTriggerPin and kServoPin.
template <class Timer>
class FrameTimer {
 public:
  static void start() {
    Timer::direction() |= Timer::kTriggerPin | Timer::kServoPin;
    Timer::top() = kFrameCounts - 1;  // At once in normal mode; after a hang it is still the same.
    Timer::mode() = kMode15;
    Timer::control() = _BV(ICNC1) | _BV(ICES1) | _BV(WGM13) | _BV(WGM12) | _BV(CS11);
    Timer::enables() = _BV(ICIE1) | _BV(TOIE1);
  }

  static uint32_t now_us() {
    const hal::InterruptLock lock;
    const uint16_t count = Timer::count();
    return frame_start_us(count) + count / 2;
  }

  static void set_servo_pulse_us(uint16_t pulse_us) {
    // 16-bit registers share one TEMP byte with those of the interrupts.
    const hal::InterruptLock lock;
    Timer::servo() = static_cast<uint16_t>(pulse_us * 2 - 1);
    Timer::mode() = kMode15 | _BV(COM1B1);
  }

  static void trigger_sonar() {
    {
      const hal::InterruptLock lock;
      Timer::control() |= _BV(ICES1);
      Timer::flags() = _BV(ICF1);
    }
    Timer::port() |= Timer::kTriggerPin;
    _delay_us(10);
    Timer::port() &= static_cast<uint8_t>(~Timer::kTriggerPin);
  }

  static bool echo_is_high() { return (Timer::level() & Timer::kEchoPin) != 0; }

  /// The overflow interrupt.
  static void on_overflow() { frames_us_ += kFrameUs; }

  /// The capture interrupt.
  static void on_capture() {
    const uint16_t count = Timer::captured();
    const uint8_t control = Timer::control();
    const bool high = (control & _BV(ICES1)) != 0;
    Timer::control() = control ^ _BV(ICES1);
    Timer::flags() = _BV(ICF1);  // Turning the edge round may set it.
    hal::on_echo_edge(high, frame_start_us(count) * 2 + count);
  }

 private:
  static constexpr uint16_t kFrameCounts = 40000;
  static constexpr uint16_t kFrameUs = kFrameCounts / 2;
  static_assert(F_CPU / 8 == 2000000, "half microseconds need 16 MHz");
  static_assert(kFrameUs == hal::kServoFrameMs * 1000U, "the frame is the servo's");

  /// Timer 1's bit names serve for every 16-bit timer: all have the same layout.
  static constexpr uint8_t kMode15 = _BV(WGM11) | _BV(WGM10);

  /// Start of the frame in which `count` was read, with interrupts locked. An overflow that nobody
  /// has served yet belongs before a low count and after a high one.
  static uint32_t frame_start_us(uint16_t count) {
    const bool overflow_waits = (Timer::flags() & _BV(TOV1)) != 0;
    return overflow_waits && count < kFrameCounts / 2 ? frames_us_ + kFrameUs : frames_us_;
  }

  static volatile uint32_t frames_us_;
};

/// Start of the frame under way, as far as its overflow has been served.
template <class Timer>
volatile uint32_t FrameTimer<Timer>::frames_us_ = 0;

}  // namespace boards
}  // namespace echomap
