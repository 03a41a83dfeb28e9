// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <sim_avr.h>

namespace echomap::emulator {

/// Calls functions at exact cycles of the emulated chip, through one of simavr's cycle timers. The
/// CPU may be some cycles farther, at the end of its instruction; `avr_t::cycle` is set back to the
/// event's own during the call, so that a capture unit stamps the right count. Events of the same
/// cycle keep their order.
class CycleQueue {
 public:
  /// `avr` outlives the queue.
  explicit CycleQueue(avr_t& avr) : avr_(avr) {}
  CycleQueue(const CycleQueue&) = delete;
  CycleQueue& operator=(const CycleQueue&) = delete;

  /// Calls `event` at `cycle`, or as soon as possible where that is over.
  void at(std::uint64_t cycle, std::function<void()> event);

  avr_t& avr() { return avr_; }

  /// Starts the cycle timer again after `avr_reset`, which forgets every one of them.
  void rearm();

 private:
  static avr_cycle_count_t on_timer(avr_t* avr, avr_cycle_count_t when, void* queue);
  void call_until(std::uint64_t cycle);

  avr_t& avr_;
  std::multimap<std::uint64_t, std::function<void()>> events_;
};

}  // namespace echomap::emulator
