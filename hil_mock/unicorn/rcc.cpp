// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/rcc.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kCr = 0x00;
constexpr std::uint32_t kCfgr = 0x04;
constexpr std::uint32_t kApb2Enable = 0x18;
constexpr std::uint32_t kApb1Enable = 0x1C;
constexpr std::uint32_t kCsr = 0x24;

constexpr std::uint32_t kHsiOnAndReady = 3;
constexpr std::uint32_t kHseOn = bit(16);
constexpr std::uint32_t kHseReady = bit(17);
constexpr std::uint32_t kPllOn = bit(24);
constexpr std::uint32_t kPllReady = bit(25);
constexpr std::uint32_t kSwitch = 3;
constexpr std::uint32_t kSwitchToPll = 2;
constexpr unsigned kSwitchStatusShift = 2;
constexpr std::uint32_t kRemoveFlags = bit(24);
constexpr std::uint32_t kAllFlags = 0xFC000000;
constexpr std::uint32_t kPinFlag = bit(26);
constexpr std::uint32_t kPowerOnFlag = bit(27);
constexpr std::uint32_t kSoftwareFlag = bit(28);
constexpr std::uint32_t kIwdgFlag = bit(29);
constexpr std::uint32_t kWwdgFlag = bit(30);

/// Start-up of the crystal in 2 ms and lock of the PLL in 0.2 ms: data sheet of the STM32F103x8,
/// tables 22 and 28.
constexpr std::uint64_t kHseCycles = 144'000;
constexpr std::uint64_t kPllCycles = 14'400;

}  // namespace

unsigned Rcc::cpu_cycle() const {
  constexpr unsigned kOfHsi = 9;
  const bool from_pll = (cfgr_ >> kSwitchStatusShift & kSwitch) == kSwitchToPll;
  return from_pll ? 1 : kOfHsi;
}

bool Rcc::clocks(Bus bus, std::uint8_t number) const {
  if (bus == Bus::kAlwaysOn) {
    return true;
  }
  return ((bus == Bus::kApb1 ? apb1_enabled_ : apb2_enabled_) & bit(number)) != 0;
}

void Rcc::note_reset(ResetSource source) {
  if (source == ResetSource::kPowerOn) {
    csr_ = kPowerOnFlag;
  }
  csr_ |= kPinFlag | (source == ResetSource::kWatchdog ? kIwdgFlag : 0) |
          (source == ResetSource::kWindowWatchdog ? kWwdgFlag : 0) |
          (source == ResetSource::kSoftware ? kSoftwareFlag : 0);
}

std::uint32_t Rcc::read(std::uint32_t offset) {
  switch (offset) {
    case kCr:
      return cr_;
    case kCfgr:
      return cfgr_;
    case kApb2Enable:
      return apb2_enabled_;
    case kApb1Enable:
      return apb1_enabled_;
    case kCsr:
      return csr_;
    default:
      return 0;
  }
}

void Rcc::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kCr) {
    const std::uint32_t kept = cr_ & (kHseReady | kPllReady);
    cr_ = (value & ~(kHseReady | kPllReady)) | kept | kHsiOnAndReady;
    make_ready(kHseOn, kHseReady, kHseCycles);
    make_ready(kPllOn, kPllReady, kPllCycles);
  } else if (offset == kCfgr) {
    write_cfgr(value);
  } else if (offset == kApb2Enable) {
    apb2_enabled_ = value;
  } else if (offset == kApb1Enable) {
    apb1_enabled_ = value;
  } else if (offset == kCsr && (value & kRemoveFlags) != 0) {
    csr_ &= ~kAllFlags;
  }
}

/// A switch to a PLL that is not ready is not made.
void Rcc::write_cfgr(std::uint32_t value) {
  const std::uint32_t status = kSwitch << kSwitchStatusShift;
  const bool possible = (value & kSwitch) != kSwitchToPll || (cr_ & kPllReady) != 0;
  const std::uint32_t switched = (value & kSwitch) << kSwitchStatusShift;
  cfgr_ = (value & ~status) | (possible ? switched : cfgr_ & status);
}

void Rcc::reset() {
  cr_ = kHsiOnAndReady;
  cfgr_ = 0;
  apb2_enabled_ = 0;
  apb1_enabled_ = 0;
}

void Rcc::make_ready(std::uint32_t on, std::uint32_t ready, std::uint64_t after_cycles) {
  if ((cr_ & on) != 0 && (cr_ & ready) == 0) {
    queue_.at(queue_.now() + after_cycles,
              [this, on, ready] { cr_ |= (cr_ & on) != 0 ? ready : 0; });
  }
}

}  // namespace echomap::unicorn
