// SPDX-License-Identifier: MIT
#include "firmware/hal/board.hpp"

#include "firmware/boards/ev3/clock.hpp"
#include "firmware/boards/ev3/guard.hpp"
#include "firmware/boards/ev3/options.hpp"
#include "firmware/boards/ev3/parts.hpp"
#include "firmware/hal/boot.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/stack.hpp"
#include "firmware/hal/watchdog.hpp"
#include "protocol/handshake_messages.hpp"

/// One thread: what other boards do in interrupts happens here while the program sleeps.
namespace echomap {
namespace boards {
namespace {

constexpr uint64_t kTickUs = 1000000 / hal::kTickHz;
/// Silence is counted in ticks, so each that Linux delays is served late, one a pass of the main
/// loop. A robot that is later than this is stopped by its guard.
constexpr uint64_t kMaxTicksLate = kGuardMs;
/// The kernel obeys at once, a simulated world when the program sleeps.
constexpr uint64_t kResetUs = 2000;

uint64_t next_tick_us = 0;

void tick() {
  const uint64_t now_us = clock_us();
  if (now_us < next_tick_us) {
    return;
  }
  if (now_us - next_tick_us > kMaxTicksLate * kTickUs) {
    next_tick_us = now_us;
  }
  next_tick_us += kTickUs;
  hal::on_tick();
}

void sleep_fully_until(uint64_t until_us) {
  while (clock_us() < until_us) {
    sleep_until(until_us, nullptr, 0);
  }
}

}  // namespace
}  // namespace boards

namespace hal {

void start_board() {
  using namespace boards;
  const Options options = read_options();
  start_guard(options.sysfs, options.clock);
  reset_motors(starts_before() != 0);
  open_sensors(options.sysfs);
  start_line(options.line);
  tell_guard();
  sleep_fully_until(clock_us() + kResetUs);
  next_tick_us = clock_us() + kTickUs;
}

uint8_t lock_interrupts() { return 0; }
void restore_interrupts(uint8_t /*state*/) {}
void enable_interrupts() {}

void sleep_until_interrupt() {
  using namespace boards;
  send_to_line();
  if (!receive_from_line()) {
    pollfd waits[kMaxWaits];
    const nfds_t count = waits_of_line(waits);
    sleep_until(next_tick_us, waits, count);
    receive_from_line();
  }
  tick();
}

void start_watchdog() { kick_watchdog(); }

/// Comes with each control cycle.
void kick_watchdog() {
  boards::tell_guard();
  boards::repeat_refused_stops();
}

/// The guard starts again only what has crashed or hung.
uint8_t reset_cause() {
  return boards::starts_before() == 0 ? protocol::kResetPowerOn : protocol::kResetWatchdog;
}

uint16_t boot_id() { return static_cast<uint16_t>(boards::guard_id() + boards::starts_before()); }

/// Linux gives a stack of megabytes.
uint16_t min_free_stack_bytes() { return UINT16_MAX; }

}  // namespace hal
}  // namespace echomap
