// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/pins.hpp"

namespace echomap {
namespace boards {
namespace {

void make_input(Pin pin, uint32_t pull) {
  sio().oe_clr = bit(pin);
  pads().pin[pin] = kPadInput | kPadSchmitt | pull;
  set_function(pin, PinFunction::kLevel);
}

}  // namespace

void make_output(Pin pin) {
  sio().oe_set = bit(pin);
  pads().pin[pin] = kPadInput | kPadSchmitt | kPad4Ma;
  set_function(pin, PinFunction::kLevel);
}

void pull_up(Pin pin) { make_input(pin, kPadPullUp); }

void pull_down(Pin pin) { make_input(pin, kPadPullDown); }

void make_analog(Pin pin) {
  sio().oe_clr = bit(pin);
  set_function(pin, PinFunction::kNone);
  pads().pin[pin] = kPadNoOutput;
}

}  // namespace boards
}  // namespace echomap
