// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/wwdg.hpp"

#include <utility>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kCr = 0x0;
constexpr std::uint32_t kCfr = 0x4;
constexpr std::uint32_t kSr = 0x8;
constexpr std::uint32_t kCountBits = 0x7F;
constexpr std::uint32_t kOn = bit(7);
constexpr std::uint32_t kWarning = bit(9);
constexpr unsigned kPrescalerShift = 7;
constexpr std::uint32_t kLastGoodCount = 0x40;
constexpr std::uint64_t kCyclesPerShortStep = 4096 * 2;
constexpr std::uint8_t kLine = 0;

}  // namespace

std::uint32_t Wwdg::read(std::uint32_t offset) {
  switch (offset) {
    case kCr:
      return count() | (runs_ ? kOn : 0);
    case kCfr:
      return configuration_;
    case kSr:
      return warned_ ? 1 : 0;
    default:
      return 0;
  }
}

void Wwdg::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kCr) {
    write_control(value);
  } else if (offset == kCfr) {
    const std::uint32_t count_now = count();
    configuration_ = value | (configuration_ & kWarning);
    restart(count_now);
  } else if (offset == kSr && (value & 1U) == 0) {
    warned_ = false;
  }
  update();
}

void Wwdg::reset() {
  runs_ = false;
  warned_ = false;
  first_count_ = kCountBits;
  configuration_ = kCountBits;
  ++rounds_;
  update();
}

/// A count without its highest bit resets at once, and so does a kick before the window.
void Wwdg::write_control(std::uint32_t value) {
  const bool too_early = runs_ && count() > (configuration_ & kCountBits);
  runs_ = runs_ || (value & kOn) != 0;
  if (runs_ && on_timeout && (too_early || (value & kCountBits) < kLastGoodCount)) {
    on_timeout();
  }
  restart(value & kCountBits);
}

std::uint64_t Wwdg::step_cycles() const {
  return kCyclesPerShortStep << (configuration_ >> kPrescalerShift & 3U);
}

std::uint32_t Wwdg::count() const {
  if (!runs_) {
    return first_count_;
  }
  const std::uint64_t steps = (queue_.now() - start_cycle_) / step_cycles();
  return static_cast<std::uint32_t>(first_count_ - steps) & kCountBits;
}

void Wwdg::restart(std::uint32_t count) {
  ++rounds_;
  first_count_ = count;
  start_cycle_ = queue_.now();
  if (!runs_ || count < kLastGoodCount) {
    return;
  }
  at_step(count - kLastGoodCount, [this] {
    warned_ = true;
    update();
  });
  at_step(count - kLastGoodCount + 1, [this] {
    if (on_timeout) {
      on_timeout();
    }
  });
}

void Wwdg::at_step(std::uint64_t step, std::function<void()> event) {
  queue_.at(start_cycle_ + step * step_cycles(), [this, round = rounds_, event = std::move(event)] {
    if (round == rounds_) {
      event();
    }
  });
}

void Wwdg::update() { nvic_.set_line(kLine, warned_ && (configuration_ & kWarning) != 0); }

}  // namespace echomap::unicorn
