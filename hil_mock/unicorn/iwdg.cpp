// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/iwdg.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kKr = 0x0;
constexpr std::uint32_t kPr = 0x4;
constexpr std::uint32_t kRlr = 0x8;
constexpr std::uint32_t kKick = 0xAAAA;
constexpr std::uint32_t kUnlock = 0x5555;
constexpr std::uint32_t kStart = 0xCCCC;
constexpr std::uint32_t kReloadBits = 0xFFF;
constexpr std::uint64_t kCyclesPerOscillation = 72'000'000 / 40'000;

}  // namespace

std::uint32_t Iwdg::read(std::uint32_t offset) {
  if (offset == kPr) {
    return prescaler_;
  }
  return offset == kRlr ? reload_ : 0;
}

void Iwdg::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kKr) {
    unlocked_ = value == kUnlock;
    runs_ = runs_ || value == kStart;
    if (value == kKick || value == kStart) {
      restart();
    }
  } else if (offset == kPr && unlocked_) {
    prescaler_ = value & 7U;
  } else if (offset == kRlr && unlocked_) {
    reload_ = value & kReloadBits;
  }
}

void Iwdg::reset() {
  runs_ = false;
  unlocked_ = false;
  prescaler_ = 0;
  reload_ = kReloadBits;
  ++rounds_;
}

void Iwdg::restart() {
  ++rounds_;
  if (!runs_) {
    return;
  }
  const std::uint64_t oscillations = (reload_ + std::uint64_t{1}) * (4U << prescaler_);
  queue_.at(queue_.now() + oscillations * kCyclesPerOscillation, [this, round = rounds_] {
    if (round == rounds_ && on_timeout) {
      on_timeout();
    }
  });
}

}  // namespace echomap::unicorn
