// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/cycle_queue.hpp"

#include <utility>

namespace echomap::emulator {

void CycleQueue::at(std::uint64_t cycle, std::function<void()> event) {
  const auto added = events_.emplace(cycle, std::move(event));
  if (!calling_ && added == events_.begin()) {
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

avr_cycle_count_t CycleQueue::on_timer(avr_t* /*avr*/, avr_cycle_count_t /*when*/, void* queue) {
  auto& self = *static_cast<CycleQueue*>(queue);
  self.calling_ = true;
  self.call_due();
  self.calling_ = false;
  return self.events_.empty() ? 0 : self.events_.begin()->first;
}

void CycleQueue::call_due() {
  while (!events_.empty() && events_.begin()->first <= avr_.cycle) {
    const auto due = events_.extract(events_.begin());
    due.mapped()();
  }
}

}  // namespace echomap::emulator
