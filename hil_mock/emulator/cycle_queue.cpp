// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/cycle_queue.hpp"

#include <algorithm>
#include <utility>

namespace echomap::emulator {

void CycleQueue::at(std::uint64_t cycle, std::function<void()> event) {
  const auto added = events_.emplace(std::max<std::uint64_t>(cycle, avr_.cycle), std::move(event));
  if (added == events_.begin()) {
    rearm();
  }
}

void CycleQueue::rearm() {
  if (events_.empty()) {
    return;
  }
  const std::uint64_t next = events_.begin()->first;
  const std::uint64_t delay = next > avr_.cycle ? next - avr_.cycle : 0;
  avr_cycle_timer_register(&avr_, delay, &CycleQueue::on_timer, this);
}

avr_cycle_count_t CycleQueue::on_timer(avr_t* /*avr*/, avr_cycle_count_t when, void* queue) {
  auto& self = *static_cast<CycleQueue*>(queue);
  self.call_until(when);
  self.rearm();  // and not by the return value: timers of simavr that are due go in between
  return 0;
}

void CycleQueue::call_until(std::uint64_t cycle) {
  const avr_cycle_count_t end_of_instruction = avr_.cycle;
  while (!events_.empty() && events_.begin()->first <= cycle) {
    const auto due = events_.extract(events_.begin());
    avr_.cycle = due.key();
    due.mapped()();
  }
  avr_.cycle = end_of_instruction;
}

}  // namespace echomap::emulator
