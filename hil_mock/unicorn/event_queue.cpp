// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/event_queue.hpp"

#include <algorithm>
#include <utility>

namespace echomap::unicorn {

void EventQueue::at(std::uint64_t cycle, std::function<void()> event) {
  events_.emplace(std::max(cycle, now_), std::move(event));
  find_next();
}

void EventQueue::call_due() {
  const std::uint64_t cpu_now = now_;
  while (next_ <= cpu_now) {
    const auto due = events_.extract(events_.begin());
    find_next();
    now_ = due.key();
    due.mapped()();
  }
  now_ = cpu_now;
}

void EventQueue::skip_to(std::uint64_t cycle) {
  now_ = std::max(now_, cycle);
  call_due();
}

}  // namespace echomap::unicorn
