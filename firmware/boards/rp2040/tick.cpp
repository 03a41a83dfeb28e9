// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/usb_line.hpp"
#include "firmware/boards/rp2040/vectors.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kPeriodUs = 1000000 / hal::kTickHz;

uint32_t next_us = 0;

/// An alarm is for an equal time only, so one that is over already must not be set.
void set_next_alarm() {
  next_us += kPeriodUs;
  timer().alarm[0] = next_us;
  if (static_cast<int32_t>(timer().timerawl - next_us) >= 0) {
    pend_line(InterruptLine::kTimer0);
  }
}

}  // namespace

void start_tick() {
  set_bits(timer().inte, bit(0));
  enable_line(InterruptLine::kTimer0);
  next_us = timer().timerawl;
  set_next_alarm();
}

}  // namespace boards

namespace hal {

uint32_t now_us() { return boards::timer().timerawl; }

}  // namespace hal
}  // namespace echomap

extern "C" void on_timer0() {
  using namespace echomap;
  boards::timer().intr = boards::bit(0);
  const uint32_t until_next_us = boards::next_us - boards::timer().timerawl;
  if (static_cast<int32_t>(until_next_us) > static_cast<int32_t>(boards::kPeriodUs / 2)) {
    return;  // Pended by hand, and the alarm came as well.
  }
  boards::set_next_alarm();
  boards::take_next_usb_packet();
  hal::on_tick();
}
