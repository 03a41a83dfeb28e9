// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/sys_tick.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kCtrl = 0x0;
constexpr std::uint32_t kLoad = 0x4;
constexpr std::uint32_t kVal = 0x8;
constexpr std::uint32_t kInterruptEnabled = 2;
constexpr std::uint32_t kCounterBits = 0xFFFFFF;

}  // namespace

std::uint32_t SysTick::read(std::uint32_t offset) {
  switch (offset) {
    case kCtrl:
      return ctrl_;
    case kLoad:
      return load_;
    case kVal:
      // The block that reads may be past the end of the round, whose event comes behind it.
      return runs() ? load_ - static_cast<std::uint32_t>((queue_.now() - round_start_) %
                                                         (std::uint64_t{load_} + 1))
                    : 0;
    default:
      return 0;
  }
}

void SysTick::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kLoad) {
    load_ = value & kCounterBits;
    return;
  }
  if (offset == kCtrl) {
    ctrl_ = value & 7U;
  }
  if (offset == kCtrl || offset == kVal) {
    begin_round(queue_.now());
  }
}

void SysTick::reset() {
  ctrl_ = 0;
  load_ = 0;
  ++rounds_;
}

void SysTick::begin_round(std::uint64_t cycle) {
  round_start_ = cycle;
  ++rounds_;
  if (!runs()) {
    return;
  }
  const std::uint64_t end = round_start_ + load_ + 1;
  queue_.at(end, [this, end, round = rounds_] {
    if (round != rounds_) {
      return;
    }
    if ((ctrl_ & kInterruptEnabled) != 0) {
      nvic_.pend_sys_tick();
    }
    begin_round(end);
  });
}

}  // namespace echomap::unicorn
