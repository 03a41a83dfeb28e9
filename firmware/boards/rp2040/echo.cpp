// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"
#include "firmware/boards/rp2040/pulse_length.hpp"
#include "firmware/boards/rp2040/vectors.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/sonar.hpp"

/// PWM slice 3 counts half microseconds while the echo pin, its channel B, is high. The pin's
/// interrupts tell that there was an edge, late as they may be; the slice tells how long the pulse
/// was.
namespace echomap {
namespace boards {
namespace {

/// GP7 is the last of the first word: edges low and high.
constexpr uint32_t kFall = bit(30);
constexpr uint32_t kRise = bit(31);

uint32_t rise_half_us = 0;

/// Clears the edges before it.
void wait_for_edge(uint32_t edge) {
  pins().intr[0] = kFall | kRise;
  pins().inte[0] = edge;
}

SliceRegisters& slice() { return pwm().slice[kEchoSlice]; }

}  // namespace

void start_echo() {
  slice().div = kHalfUsDivider;
  slice().top = UINT16_MAX;
  slice().csr = kPwmGatedByB | kPwmEnable;
  pull_down(kEchoPin);
  set_function(kEchoPin, PinFunction::kPwm);
  set_level(kTriggerPin, false);
  make_output(kTriggerPin);
  enable_line(InterruptLine::kPins);
}

}  // namespace boards

namespace hal {

void trigger_sonar() {
  using namespace boards;
  constexpr uint32_t kTriggerUs = 10;
  slice().ctr = 0;
  wait_for_edge(kRise);
  set_level(kTriggerPin, true);
  const uint32_t start = timer().timerawl;
  while (timer().timerawl - start <= kTriggerUs) {
  }
  set_level(kTriggerPin, false);
}

bool echo_is_high() { return boards::level_of(boards::kEchoPin); }

}  // namespace hal
}  // namespace echomap

/// The edges of the echo come in turns, so only the one that is waited for may interrupt.
extern "C" void on_pins() {
  using namespace echomap::boards;
  take_pulse();
  if (pins().ints[0] == 0) {
    return;
  }
  const uint32_t now_half_us = timer().timerawl * 2;
  if ((pins().inte[0] & kRise) != 0) {
    pins().inte[0] = kFall;  // One that has come meanwhile counts.
    pins().intr[0] = kRise;
    rise_half_us = now_half_us;
    echomap::hal::on_echo_edge(true, rise_half_us);
  } else {
    pins().inte[0] = 0;
    pins().intr[0] = kFall;
    const uint16_t counted = static_cast<uint16_t>(slice().ctr);
    echomap::hal::on_echo_edge(
        false, rise_half_us + echo_length_half_us(now_half_us - rise_half_us, counted));
  }
}
