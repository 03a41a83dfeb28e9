// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/nvic.hpp"

#include <algorithm>

#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kSetEnable = 0xE000E100;
constexpr std::uint32_t kClearEnable = 0xE000E180;
constexpr std::uint32_t kSetPending = 0xE000E200;
constexpr std::uint32_t kClearPending = 0xE000E280;
constexpr std::uint32_t kPriority = 0xE000E400;
constexpr std::uint32_t kPriorityEnd = 0xE000E440;
constexpr std::uint32_t kSystemPriority3 = 0xE000ED20;
constexpr std::uint32_t kBankBytes = 8;
constexpr unsigned kSysTickShift = 24;
constexpr std::uint8_t kPriorityBits = 0xF0;

bool is_in(std::uint32_t address, std::uint32_t bank) {
  return address >= bank && address < bank + kBankBytes;
}

}  // namespace

void Nvic::set_line(std::uint8_t line, bool high) {
  const std::size_t exception = kFirstLine + line;
  pending_[exception] = pending_[exception] || (high && !high_[exception]);
  high_[exception] = high;
}

std::optional<Exception> Nvic::next(Masks masks) const {
  std::uint16_t limit = running_priority();
  if (masks.basepri != 0) {
    limit = std::min<std::uint16_t>(limit, masks.basepri);
  }
  std::optional<Exception> chosen;
  for (std::size_t i = kSysTick; i < kExceptions && !masks.primask; ++i) {
    const bool may = pending_[i] && (enabled_[i] || i == kSysTick);
    if (may && priority_[i] < limit) {
      limit = priority_[i];
      chosen = static_cast<Exception>(i);
    }
  }
  return chosen;
}

void Nvic::enter(Exception exception) {
  pending_[exception] = false;
  served_.push_back(exception);
}

void Nvic::leave() {
  const Exception exception = served_.back();
  served_.pop_back();
  pending_[exception] = pending_[exception] || high_[exception];
}

std::uint16_t Nvic::running_priority() const {
  return served_.empty() ? kThreadPriority : priority_[served_.back()];
}

std::uint32_t Nvic::word_of(const Flags& flags, std::uint32_t word) const {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 32; ++i) {
    bits |= flags[kFirstLine + word * 32 + i] ? bit(i) : 0;
  }
  return bits;
}

void Nvic::pend(Exception exception, bool pends) {
  pending_[exception] = pends || high_[exception];
}

std::uint32_t Nvic::read(std::uint32_t address) const {
  const std::uint32_t word = address % kBankBytes / 4;
  if (is_in(address, kSetEnable) || is_in(address, kClearEnable)) {
    return word_of(enabled_, word);
  }
  if (is_in(address, kSetPending) || is_in(address, kClearPending)) {
    return word_of(pending_, word);
  }
  std::uint32_t priorities = 0;
  if (address >= kPriority && address < kPriorityEnd) {
    for (unsigned i = 0; i < 4; ++i) {
      priorities |= std::uint32_t{priority_[kFirstLine + address - kPriority + i]} << (8 * i);
    }
  } else if (address == kSystemPriority3) {
    priorities = std::uint32_t{priority_[kSysTick]} << kSysTickShift;
  }
  return priorities;
}

void Nvic::write(std::uint32_t address, std::uint32_t value) {
  const std::uint32_t word = address % kBankBytes / 4;
  for (unsigned i = 0; i < 32; ++i) {
    const auto exception = static_cast<Exception>(kFirstLine + word * 32 + i);
    if ((value & bit(i)) == 0) {
      continue;
    }
    if (is_in(address, kSetEnable) || is_in(address, kClearEnable)) {
      enabled_[exception] = address < kClearEnable;
    } else if (is_in(address, kSetPending) || is_in(address, kClearPending)) {
      pend(exception, address < kClearPending);
    }
  }
  if (address >= kPriority && address < kPriorityEnd) {
    for (unsigned i = 0; i < 4; ++i) {
      priority_[kFirstLine + address - kPriority + i] =
          static_cast<std::uint8_t>(value >> (8 * i) & kPriorityBits);
    }
  } else if (address == kSystemPriority3) {
    priority_[kSysTick] = static_cast<std::uint8_t>(value >> kSysTickShift & kPriorityBits);
  }
}

}  // namespace echomap::unicorn
