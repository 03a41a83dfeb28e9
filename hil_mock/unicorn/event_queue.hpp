// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>

namespace echomap::unicorn {

/// The time of an emulated chip in CPU cycles, and what happens when. The CPU runs block by block
/// and may be some cycles past an event; `now` is set back to the event's own cycle during its
/// call, so that a capture unit stamps the right count. Events of the same cycle keep their order.
class EventQueue {
 public:
  std::uint64_t now() const { return now_; }

  /// Calls `event` at `cycle`, or as soon as possible where that is over.
  void at(std::uint64_t cycle, std::function<void()> event);

  /// Cycle of the next event; the largest number where there is none.
  std::uint64_t next() const { return next_; }

  /// The CPU has been busy for `cycles`; calls nothing.
  void spend(std::uint64_t cycles) { now_ += cycles; }
  /// Calls what is due at `now`.
  void call_due();
  /// Lets time pass up to `cycle` with the CPU asleep; does nothing where that is past.
  void skip_to(std::uint64_t cycle);

 private:
  static constexpr std::uint64_t kNever = UINT64_MAX;

  void find_next() { next_ = events_.empty() ? kNever : events_.begin()->first; }

  std::multimap<std::uint64_t, std::function<void()>> events_;
  std::uint64_t now_ = 0;
  std::uint64_t next_ = kNever;
};

}  // namespace echomap::unicorn
