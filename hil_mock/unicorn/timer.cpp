// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/timer.hpp"

#include <algorithm>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kCr1 = 0x00;
constexpr std::uint32_t kDier = 0x0C;
constexpr std::uint32_t kSr = 0x10;
constexpr std::uint32_t kEgr = 0x14;
constexpr std::uint32_t kCcmr1 = 0x18;
constexpr std::uint32_t kCcmr2 = 0x1C;
constexpr std::uint32_t kCcer = 0x20;
constexpr std::uint32_t kCnt = 0x24;
constexpr std::uint32_t kPsc = 0x28;
constexpr std::uint32_t kArr = 0x2C;
constexpr std::uint32_t kCcr1 = 0x34;
constexpr std::uint32_t kCcr2 = 0x38;
constexpr std::uint32_t kCcr4 = 0x40;

constexpr std::uint32_t kUpdate = bit(0);
constexpr std::uint32_t kHalfWord = 0xFFFF;
constexpr std::uint32_t kPreload = bit(3);
constexpr unsigned kForcedActive = 5;
constexpr unsigned kPwmMode1 = 6;
constexpr unsigned kPwmMode2 = 7;
constexpr double kCyclesPerUs = 72.0;
constexpr unsigned kSelectTi1[] = {1, 2};

constexpr std::uint32_t kSmcr = 0x08;
constexpr std::uint32_t kBdtr = 0x44;
constexpr std::uint32_t kMainOutputEnable = bit(15);
constexpr std::uint32_t kSlaveMode = 7;
constexpr std::uint32_t kEncoderOfBothInputs = 3;

/// Channels count from 1.
std::uint32_t compare_offset(unsigned channel) { return kCcr1 + 4 * (channel - 1); }

bool is_compare(std::uint32_t offset) { return offset >= kCcr1 && offset <= kCcr4; }

}  // namespace

/// Bits of one channel in CCMR1 or CCMR2, and in CCER.
unsigned Timer::mode_bits(unsigned channel) const {
  return value(channel <= 2 ? kCcmr1 : kCcmr2) >> (8 * ((channel - 1) % 2)) & 0xFFU;
}

unsigned Timer::enable_bits(unsigned channel) const {
  return value(kCcer) >> (4 * (channel - 1)) & 0xFU;
}

void Timer::set_input(unsigned input, bool high) {
  bool& level = inputs_.at(input - 1);
  if (high == level) {
    return;
  }
  level = high;
  if (runs() && is_encoder()) {
    count_edge(input);
  }
  if (input == 1) {
    capture(high);
  }
}

/// RM0008, table 81: after an edge of the first input it leads where the two differ, after one of
/// the second where they are the same.
void Timer::count_edge(unsigned input) {
  const bool differ = inputs_[0] != inputs_[1];
  const std::uint32_t rounds_at = value(kArr) + 1;
  const std::uint32_t step = differ == (input == 1) ? 1 : rounds_at - 1;
  stopped_count_ = (stopped_count_ + step) % rounds_at;
}

void Timer::capture(bool high) {
  for (const unsigned channel : {1U, 2U}) {
    if (captures(channel, high)) {
      value(channel == 1 ? kCcr1 : kCcr2) = count();
      set_flags(bit(channel));
    }
  }
}

/// Mode 2 is the complement of mode 1, and so is the other polarity (CCxP).
world::PinSignal Timer::output(unsigned channel) const {
  if (!is_output(channel)) {
    return world::level(false);
  }
  const unsigned mode = mode_bits(channel) >> 4 & 7U;
  const bool inverted = (enable_bits(channel) & 2U) != 0;
  if (mode != kPwmMode1 && mode != kPwmMode2) {
    return world::level((mode == kForcedActive) != inverted);
  }
  const double compare = compare_in_force(channel);
  const double before_match = std::min(1.0, compare / (value(kArr) + 1.0));
  const double period_us = static_cast<double>(period_cycles()) / kCyclesPerUs;
  return inverted == (mode == kPwmMode1) ? world::inverted_pulses(before_match, period_us)
                                         : world::pulses(before_match, period_us);
}

std::uint64_t Timer::pulse_cycles(unsigned channel) const {
  return makes_pwm(channel) ? std::uint64_t{compare_in_force(channel)} * (prescaler_ + 1) : 0;
}

std::uint32_t Timer::read(std::uint32_t offset) {
  if (offset >= 4 * registers_.size()) {
    return 0;
  }
  if (offset == kCnt) {
    return count();
  }
  if (offset == kCcr1 || offset == kCcr2) {
    const unsigned channel = offset == kCcr1 ? 1 : 2;
    if ((mode_bits(channel) & 3U) != 0) {
      value(kSr) &= ~bit(channel);
      set_flags(0);
    }
  }
  return value(offset);
}

void Timer::write(std::uint32_t offset, std::uint32_t value_written) {
  if (offset >= 4 * registers_.size()) {
    return;
  }
  const std::uint32_t before = count();
  const bool ran = counts_clock();
  const bool updates = offset == kEgr && (value_written & kUpdate) != 0;
  if (offset == kSr) {
    value(kSr) &= value_written;
  } else if (updates) {
    prescaler_ = value(kPsc);
    set_flags(kUpdate);
  } else if (offset != kEgr) {
    value(offset) = value_written & kHalfWord;
  }
  take_compares(updates);
  set_flags(0);
  if (offset == kCnt || offset == kEgr) {
    restart(offset == kCnt ? value_written & kHalfWord : 0);
  } else if (ran != counts_clock() || offset == kArr) {
    restart(before);
  } else if (offset == kDier || is_compare(offset)) {
    schedule_update();
  }
}

void Timer::reset() {
  registers_ = {};
  value(kArr) = kHalfWord;
  compares_ = {};
  prescaler_ = 0;
  stopped_count_ = 0;
  ++schedules_;
  set_flags(0);
}

bool Timer::runs() const { return (value(kCr1) & 1U) != 0; }

/// Its inputs are those that the first two channels look at.
bool Timer::is_encoder() const {
  return (value(kSmcr) & kSlaveMode) == kEncoderOfBothInputs && (mode_bits(1) & 3U) == 1 &&
         (mode_bits(2) & 3U) == 1;
}

bool Timer::is_output(unsigned channel) const {
  const bool enabled = !kind_.has_main_output_enable || (value(kBdtr) & kMainOutputEnable) != 0;
  return runs() && enabled && (mode_bits(channel) & 3U) == 0 && (enable_bits(channel) & 1U) != 0;
}

bool Timer::is_preloaded(unsigned channel) const {
  return (mode_bits(channel) & 3U) == 0 && (mode_bits(channel) & kPreload) != 0;
}

bool Timer::makes_pwm(unsigned channel) const {
  return is_output(channel) && (mode_bits(channel) >> 4 & 7U) == kPwmMode1;
}

bool Timer::captures(unsigned channel, bool rising) const {
  const unsigned enable = enable_bits(channel);
  const bool falling_wanted = (enable & 2U) != 0;
  return runs() && (mode_bits(channel) & 3U) == kSelectTi1[channel - 1] && (enable & 1U) != 0 &&
         falling_wanted != rising;
}

std::uint64_t Timer::period_cycles() const {
  return (std::uint64_t{value(kArr)} + 1) * (prescaler_ + 1);
}

std::uint32_t Timer::count() const {
  if (!counts_clock()) {
    return stopped_count_;
  }
  const std::uint64_t counts = (queue_.now() - zero_cycle_) / (prescaler_ + 1);
  return static_cast<std::uint32_t>(counts % (value(kArr) + 1));
}

void Timer::restart(std::uint32_t count) {
  stopped_count_ = count;
  zero_cycle_ = queue_.now() - std::uint64_t{count} * (prescaler_ + 1);
  schedule_update();
}

/// With a preloaded 0 the pulse under way is the last one: behind it the pin stays as it is.
std::uint32_t Timer::compare_in_force(unsigned channel) const {
  const std::uint32_t compare = compares_.at(channel - 1);
  const bool was_the_last = value(compare_offset(channel)) == 0 && count() >= compare;
  return was_the_last ? 0 : compare;
}

/// A channel without preload takes a new compare at once, as does one that loses its preload.
void Timer::take_compares(bool at_update) {
  for (unsigned channel = 1; channel <= compares_.size(); ++channel) {
    if (at_update || !is_preloaded(channel)) {
      compares_.at(channel - 1) = value(compare_offset(channel));
    }
  }
}

bool Timer::has_preloads() const {
  for (unsigned channel = 1; channel <= compares_.size(); ++channel) {
    if (is_preloaded(channel) && compares_.at(channel - 1) != value(compare_offset(channel))) {
      return true;
    }
  }
  return false;
}

void Timer::schedule_update() {
  ++schedules_;
  const bool interrupts = (value(kDier) & kUpdate) != 0;
  if (!counts_clock() || (!interrupts && !has_preloads())) {
    return;
  }
  const std::uint64_t rounds = (queue_.now() - zero_cycle_) / period_cycles();
  queue_.at(zero_cycle_ + (rounds + 1) * period_cycles(), [this, schedule = schedules_] {
    if (schedule == schedules_) {
      update();
    }
  });
}

void Timer::update() {
  if ((value(kDier) & kUpdate) != 0) {
    set_flags(kUpdate);
  }
  if (has_preloads()) {
    take_compares(true);
    if (on_preload_taken) {
      on_preload_taken();
    }
  }
  schedule_update();
}

void Timer::set_flags(std::uint32_t flags) {
  value(kSr) |= flags;
  const std::uint32_t asks = value(kSr) & value(kDier) & kHalfWord;
  if (kind_.update_line == kind_.capture_line) {
    nvic_.set_line(kind_.update_line, asks != 0);
  } else {
    nvic_.set_line(kind_.update_line, (asks & kUpdate) != 0);
    nvic_.set_line(kind_.capture_line, (asks & ~kUpdate) != 0);
  }
}

}  // namespace echomap::unicorn
